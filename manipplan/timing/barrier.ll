; barrier.c 06029fb8a3a5a9a22f35aa353ba255f5f32a89b1ea9cdd37fdf77fc569051345: written by make kernel

%struct.State = type { ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, [2 x double], double, double }
%struct.Model = type { ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr }
%struct.Motion = type { i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, [2 x double], [2 x double], [2 x double], [2 x double] }
%struct.Descent = type { double, double, double, double, double, double, i64 }

@ODD = internal unnamed_addr constant [18 x double] [double 0x3F9D41D41D41D41D, double 0x3F9F07C1F07C1F08, double 0x3FA0842108421084, double 0x3FA1A7B9611A7B96, double 0x3FA2F684BDA12F68, double 4.000000e-02, double 0x3FA642C8590B2164, double 0x3FA8618618618618, double 0x3FAAF286BCA1AF28, double 0x3FAE1E1E1E1E1E1E, double 0x3FB1111111111111, double 0x3FB3B13B13B13B14, double 0x3FB745D1745D1746, double 0x3FBC71C71C71C71C, double 0x3FC2492492492492, double 2.000000e-01, double 0x3FD5555555555555, double 1.000000e+00], align 16

define dso_local i64 @manipplan_descend(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef %2) local_unnamed_addr #0 {
  %4 = alloca [5 x ptr], align 8
  %5 = alloca [16 x ptr], align 16
  %6 = alloca [4 x ptr], align 16
  %7 = alloca %struct.State, align 8
  %8 = alloca %struct.Model, align 8
  %9 = alloca ptr, align 8
  %10 = alloca ptr, align 8
  call void @llvm.lifetime.start.p0(i64 112, ptr nonnull %7) #8
  call void @llvm.lifetime.start.p0(i64 64, ptr nonnull %8) #8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %9) #8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %10) #8
  call void @llvm.lifetime.start.p0(i64 128, ptr nonnull %5) #8
  store ptr %7, ptr %5, align 16
  %11 = getelementptr inbounds ptr, ptr %5, i64 1
  %12 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 1
  store ptr %12, ptr %11, align 8
  %13 = getelementptr inbounds ptr, ptr %5, i64 2
  %14 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 2
  store ptr %14, ptr %13, align 16
  %15 = getelementptr inbounds ptr, ptr %5, i64 3
  %16 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 3
  store ptr %16, ptr %15, align 8
  %17 = getelementptr inbounds ptr, ptr %5, i64 4
  %18 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 4
  store ptr %18, ptr %17, align 16
  %19 = getelementptr inbounds ptr, ptr %5, i64 5
  %20 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 5
  store ptr %20, ptr %19, align 8
  %21 = getelementptr inbounds ptr, ptr %5, i64 6
  store ptr %8, ptr %21, align 16
  %22 = getelementptr inbounds ptr, ptr %5, i64 7
  %23 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 1
  store ptr %23, ptr %22, align 8
  %24 = getelementptr inbounds ptr, ptr %5, i64 8
  %25 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 2
  store ptr %25, ptr %24, align 16
  %26 = getelementptr inbounds ptr, ptr %5, i64 9
  %27 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 3
  store ptr %27, ptr %26, align 8
  %28 = getelementptr inbounds ptr, ptr %5, i64 10
  %29 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 4
  store ptr %29, ptr %28, align 16
  %30 = getelementptr inbounds ptr, ptr %5, i64 11
  %31 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 5
  store ptr %31, ptr %30, align 8
  %32 = getelementptr inbounds ptr, ptr %5, i64 12
  %33 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 6
  store ptr %33, ptr %32, align 16
  %34 = getelementptr inbounds ptr, ptr %5, i64 13
  %35 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 7
  store ptr %35, ptr %34, align 8
  %36 = getelementptr inbounds ptr, ptr %5, i64 14
  store ptr %9, ptr %36, align 16
  %37 = getelementptr inbounds ptr, ptr %5, i64 15
  store ptr %10, ptr %37, align 8
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %6) #8
  %38 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 6
  store ptr %38, ptr %6, align 16
  %39 = getelementptr inbounds ptr, ptr %6, i64 1
  %40 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 7
  store ptr %40, ptr %39, align 8
  %41 = getelementptr inbounds ptr, ptr %6, i64 2
  %42 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 8
  store ptr %42, ptr %41, align 16
  %43 = getelementptr inbounds ptr, ptr %6, i64 3
  %44 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 9
  store ptr %44, ptr %43, align 8
  %45 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 3
  %46 = load i64, ptr %45, align 8
  %47 = add nsw i64 %46, 16
  %48 = shl nsw i64 %47, 4
  %49 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 1
  %50 = load i64, ptr %49, align 8
  %51 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 2
  %52 = load i64, ptr %51, align 8
  %53 = add nsw i64 %52, %50
  %54 = shl i64 %46, 1
  %55 = mul i64 %54, %53
  %56 = add nsw i64 %55, %48
  %57 = call noalias ptr @calloc(i64 noundef %56, i64 noundef 8) #9
  %58 = icmp eq ptr %57, null
  br i1 %58, label %59, label %60

59:                                               ; preds = %3
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %6) #8
  call void @llvm.lifetime.end.p0(i64 128, ptr nonnull %5) #8
  br label %758

60:                                               ; preds = %3, %60
  %61 = phi i64 [ %66, %60 ], [ 0, %3 ]
  %62 = phi ptr [ %67, %60 ], [ %57, %3 ]
  %63 = getelementptr inbounds double, ptr %62, i64 8
  %64 = getelementptr inbounds [16 x ptr], ptr %5, i64 0, i64 %61
  %65 = load ptr, ptr %64, align 8
  store ptr %63, ptr %65, align 8
  %66 = add nuw nsw i64 %61, 1
  %67 = getelementptr inbounds double, ptr %62, i64 %47
  %68 = icmp eq i64 %66, 16
  br i1 %68, label %69, label %60

69:                                               ; preds = %60, %69
  %70 = phi i64 [ %79, %69 ], [ 0, %60 ]
  %71 = phi ptr [ %78, %69 ], [ %67, %60 ]
  %72 = getelementptr inbounds [4 x ptr], ptr %6, i64 0, i64 %70
  %73 = load ptr, ptr %72, align 8
  store ptr %71, ptr %73, align 8
  %74 = icmp ult i64 %70, 2
  %75 = select i1 %74, ptr %49, ptr %51
  %76 = load i64, ptr %75, align 8
  %77 = mul nsw i64 %76, %46
  %78 = getelementptr inbounds double, ptr %71, i64 %77
  %79 = add nuw nsw i64 %70, 1
  %80 = icmp eq i64 %79, 4
  br i1 %80, label %81, label %69

81:                                               ; preds = %69
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %6) #8
  call void @llvm.lifetime.end.p0(i64 128, ptr nonnull %5) #8
  %82 = call fastcc i32 @look(ptr noundef %0, ptr noundef %2, ptr noundef nonnull %7)
  %83 = icmp eq i32 %82, 0
  br i1 %83, label %756, label %84

84:                                               ; preds = %81
  %85 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 1
  %86 = load double, ptr %85, align 8
  %87 = load double, ptr %1, align 8
  %88 = fmul double %86, %87
  %89 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 11
  %90 = load double, ptr %89, align 8
  %91 = fdiv double %88, %90
  %92 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 12
  %93 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 6
  %94 = getelementptr inbounds ptr, ptr %4, i64 1
  %95 = getelementptr inbounds ptr, ptr %4, i64 2
  %96 = getelementptr inbounds ptr, ptr %4, i64 3
  %97 = getelementptr inbounds ptr, ptr %4, i64 4
  %98 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 5
  %99 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 9
  %100 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 10
  %101 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 14
  %102 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 12
  %103 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 13
  %104 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 6
  %105 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 16
  %106 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 16, i64 1
  %107 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 4
  %108 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 5
  %109 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 3
  %110 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 2
  br label %111

111:                                              ; preds = %753, %84
  %112 = phi double [ %90, %84 ], [ %750, %753 ]
  %113 = phi i64 [ 0, %84 ], [ %746, %753 ]
  %114 = phi double [ %91, %84 ], [ %755, %753 ]
  %115 = load ptr, ptr %9, align 8
  %116 = load ptr, ptr %10, align 8
  %117 = load i64, ptr %0, align 8
  %118 = add i64 %117, -1
  %119 = load i64, ptr %93, align 8
  %120 = icmp sgt i64 %119, 0
  br i1 %120, label %121, label %744

121:                                              ; preds = %111
  %122 = fmul double %114, %112
  %123 = load double, ptr %92, align 8
  %124 = fsub double %122, %123
  %125 = insertelement <8 x double> poison, double %114, i64 0
  %126 = shufflevector <8 x double> %125, <8 x double> poison, <8 x i32> zeroinitializer
  %127 = fmul double %114, -1.500000e+00
  %128 = fmul double %114, 2.250000e+00
  %129 = icmp sgt i64 %117, 1
  %130 = add i64 %117, -2
  %131 = icmp sgt i64 %117, 2
  %132 = icmp sgt i64 %117, 3
  %133 = add nsw i64 %117, -4
  %134 = shl i64 %118, 3
  br label %135

135:                                              ; preds = %741, %121
  %136 = phi i64 [ 0, %121 ], [ %740, %741 ]
  %137 = phi double [ %124, %121 ], [ %727, %741 ]
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %4)
  %138 = load i64, ptr %0, align 8
  %139 = load i64, ptr %45, align 8
  %140 = load ptr, ptr %8, align 8
  %141 = load ptr, ptr %23, align 8
  %142 = load ptr, ptr %25, align 8
  %143 = load ptr, ptr %27, align 8
  store ptr %141, ptr %94, align 8
  store ptr %142, ptr %95, align 8
  store ptr %143, ptr %96, align 8
  store ptr null, ptr %97, align 8
  %144 = icmp eq ptr %140, null
  br i1 %144, label %148, label %145

145:                                              ; preds = %135
  %146 = shl i64 %139, 3
  %147 = add i64 %146, 64
  br label %150

148:                                              ; preds = %150, %135
  %149 = icmp sgt i64 %139, 0
  br i1 %149, label %160, label %156

150:                                              ; preds = %150, %145
  %151 = phi ptr [ %140, %145 ], [ %154, %150 ]
  %152 = phi ptr [ %4, %145 ], [ %153, %150 ]
  call void @llvm.memset.p0.i64(ptr nonnull align 8 %151, i8 0, i64 %147, i1 false)
  %153 = getelementptr inbounds ptr, ptr %152, i64 1
  %154 = load ptr, ptr %153, align 8
  %155 = icmp eq ptr %154, null
  br i1 %155, label %148, label %150

156:                                              ; preds = %303, %148
  %157 = add nsw i64 %138, -1
  %158 = load ptr, ptr %104, align 8
  %159 = load ptr, ptr %12, align 8
  br label %421

160:                                              ; preds = %148, %303
  %161 = phi i64 [ %341, %303 ], [ 0, %148 ]
  %162 = load ptr, ptr %7, align 8
  %163 = getelementptr inbounds double, ptr %162, i64 %161
  %164 = load <8 x double>, ptr %163, align 8
  %165 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %164
  %166 = load ptr, ptr %20, align 8
  %167 = getelementptr inbounds double, ptr %166, i64 %161
  %168 = load <8 x double>, ptr %167, align 8
  %169 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %168
  %170 = fsub <8 x double> %169, %165
  %171 = fmul <8 x double> %165, %165
  %172 = fmul <8 x double> %169, %169
  %173 = fadd <8 x double> %171, %172
  %174 = load ptr, ptr %12, align 8
  %175 = getelementptr inbounds double, ptr %174, i64 %161
  %176 = load <8 x double>, ptr %175, align 8
  %177 = load ptr, ptr %98, align 8
  %178 = getelementptr inbounds double, ptr %177, i64 %161
  %179 = load <8 x double>, ptr %178, align 8
  %180 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %179
  %181 = load ptr, ptr %18, align 8
  %182 = getelementptr inbounds double, ptr %181, i64 %161
  %183 = load <8 x double>, ptr %182, align 8
  %184 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %183
  %185 = fmul <8 x double> %184, %184
  %186 = load ptr, ptr %16, align 8
  %187 = add nsw i64 %161, -1
  %188 = getelementptr inbounds double, ptr %186, i64 %187
  %189 = load <8 x double>, ptr %188, align 8
  %190 = getelementptr inbounds double, ptr %186, i64 %161
  %191 = load <8 x double>, ptr %190, align 8
  %192 = fadd <8 x double> %189, %191
  %193 = fmul <8 x double> %126, %192
  %194 = fmul <8 x double> %176, <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>
  %195 = fmul <8 x double> %176, %194
  %196 = fmul <8 x double> %176, %195
  %197 = fdiv <8 x double> %193, %196
  %198 = fsub <8 x double> %185, %197
  %199 = fmul <8 x double> %180, %184
  %200 = fmul <8 x double> %180, %198
  %201 = fmul <8 x double> %180, %200
  %202 = fmul <8 x double> %179, %198
  %203 = fmul <8 x double> %180, %202
  %204 = fmul <8 x double> %179, %184
  %205 = fadd <8 x double> %170, %204
  %206 = fmul <8 x double> %179, %202
  %207 = fadd <8 x double> %173, %206
  %208 = load i64, ptr %49, align 8
  %209 = icmp sgt i64 %208, 0
  br i1 %209, label %210, label %215

210:                                              ; preds = %160
  %211 = load ptr, ptr %38, align 8
  %212 = load ptr, ptr %40, align 8
  %213 = load ptr, ptr %99, align 8
  %214 = load ptr, ptr %100, align 8
  br label %266

215:                                              ; preds = %266, %160
  %216 = phi <8 x double> [ %203, %160 ], [ %297, %266 ]
  %217 = phi <8 x double> [ %201, %160 ], [ %300, %266 ]
  %218 = phi <8 x double> [ %199, %160 ], [ %292, %266 ]
  %219 = phi <8 x double> [ %207, %160 ], [ %295, %266 ]
  %220 = phi <8 x double> [ %205, %160 ], [ %290, %266 ]
  %221 = or i64 %161, 1
  %222 = getelementptr inbounds double, ptr %174, i64 %221
  %223 = load <8 x double>, ptr %222, align 8
  %224 = getelementptr inbounds double, ptr %177, i64 %221
  %225 = load <8 x double>, ptr %224, align 8
  %226 = fmul <8 x double> %176, <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %227 = fdiv <8 x double> %179, %226
  %228 = fdiv <8 x double> %180, %226
  %229 = fmul <8 x double> %223, <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %230 = fdiv <8 x double> %225, %229
  %231 = fadd <8 x double> %228, %230
  %232 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %225
  %233 = fdiv <8 x double> %232, %229
  %234 = fmul <8 x double> %126, %191
  %235 = fmul <8 x double> %234, <double -2.000000e+00, double -2.000000e+00, double -2.000000e+00, double -2.000000e+00, double -2.000000e+00, double -2.000000e+00, double -2.000000e+00, double -2.000000e+00>
  %236 = fadd <8 x double> %176, %223
  %237 = fdiv <8 x double> %235, %236
  %238 = fmul <8 x double> %227, %234
  %239 = fadd <8 x double> %238, %220
  %240 = fmul <8 x double> %234, %231
  %241 = fadd <8 x double> %218, %240
  %242 = fmul <8 x double> %227, %237
  %243 = fmul <8 x double> %227, %242
  %244 = fadd <8 x double> %219, %243
  %245 = fmul <8 x double> %242, %231
  %246 = fadd <8 x double> %216, %245
  %247 = fmul <8 x double> %237, %231
  %248 = fmul <8 x double> %231, %247
  %249 = fadd <8 x double> %217, %248
  %250 = fmul <8 x double> %234, %233
  %251 = fmul <8 x double> %242, %233
  %252 = fmul <8 x double> %233, %247
  %253 = fmul <8 x double> %237, %233
  %254 = fmul <8 x double> %233, %253
  %255 = fmul <8 x double> %227, %191
  %256 = fmul <8 x double> %191, %231
  %257 = fmul <8 x double> %191, %233
  %258 = load i64, ptr %51, align 8
  %259 = icmp sgt i64 %258, 0
  br i1 %259, label %260, label %303

260:                                              ; preds = %215
  %261 = load ptr, ptr %101, align 8
  %262 = load ptr, ptr %42, align 8
  %263 = load ptr, ptr %44, align 8
  %264 = load ptr, ptr %102, align 8
  %265 = load ptr, ptr %103, align 8
  br label %343

266:                                              ; preds = %266, %210
  %267 = phi <8 x double> [ %205, %210 ], [ %290, %266 ]
  %268 = phi <8 x double> [ %207, %210 ], [ %295, %266 ]
  %269 = phi <8 x double> [ %199, %210 ], [ %292, %266 ]
  %270 = phi <8 x double> [ %201, %210 ], [ %300, %266 ]
  %271 = phi <8 x double> [ %203, %210 ], [ %297, %266 ]
  %272 = phi i64 [ 0, %210 ], [ %301, %266 ]
  %273 = mul nsw i64 %272, %139
  %274 = add nsw i64 %273, %161
  %275 = getelementptr inbounds double, ptr %211, i64 %274
  %276 = load <8 x double>, ptr %275, align 8
  %277 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %276
  %278 = getelementptr inbounds double, ptr %212, i64 %274
  %279 = load <8 x double>, ptr %278, align 8
  %280 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %279
  %281 = getelementptr inbounds double, ptr %213, i64 %274
  %282 = load <8 x double>, ptr %281, align 8
  %283 = getelementptr inbounds double, ptr %214, i64 %274
  %284 = load <8 x double>, ptr %283, align 8
  %285 = fsub <8 x double> %277, %280
  %286 = fmul <8 x double> %277, %277
  %287 = fmul <8 x double> %280, %280
  %288 = fadd <8 x double> %286, %287
  %289 = fmul <8 x double> %282, %285
  %290 = fadd <8 x double> %267, %289
  %291 = fmul <8 x double> %285, %284
  %292 = fadd <8 x double> %269, %291
  %293 = fmul <8 x double> %282, %288
  %294 = fmul <8 x double> %282, %293
  %295 = fadd <8 x double> %268, %294
  %296 = fmul <8 x double> %284, %293
  %297 = fadd <8 x double> %271, %296
  %298 = fmul <8 x double> %284, %288
  %299 = fmul <8 x double> %284, %298
  %300 = fadd <8 x double> %270, %299
  %301 = add nuw nsw i64 %272, 1
  %302 = icmp eq i64 %301, %208
  br i1 %302, label %215, label %266

303:                                              ; preds = %343, %215
  %304 = phi <8 x double> [ %254, %215 ], [ %414, %343 ]
  %305 = phi <8 x double> [ %252, %215 ], [ %410, %343 ]
  %306 = phi <8 x double> [ %251, %215 ], [ %418, %343 ]
  %307 = phi <8 x double> [ %250, %215 ], [ %394, %343 ]
  %308 = phi <8 x double> [ %246, %215 ], [ %402, %343 ]
  %309 = phi <8 x double> [ %249, %215 ], [ %406, %343 ]
  %310 = phi <8 x double> [ %241, %215 ], [ %392, %343 ]
  %311 = phi <8 x double> [ %244, %215 ], [ %398, %343 ]
  %312 = phi <8 x double> [ %239, %215 ], [ %390, %343 ]
  %313 = getelementptr inbounds double, ptr %140, i64 %161
  %314 = load <8 x double>, ptr %313, align 8
  %315 = fadd <8 x double> %312, %314
  store <8 x double> %315, ptr %313, align 8
  %316 = getelementptr inbounds double, ptr %141, i64 %161
  %317 = load <8 x double>, ptr %316, align 8
  %318 = fadd <8 x double> %311, %317
  store <8 x double> %318, ptr %316, align 8
  %319 = getelementptr inbounds double, ptr %142, i64 %161
  %320 = load <8 x double>, ptr %319, align 8
  %321 = fadd <8 x double> %308, %320
  store <8 x double> %321, ptr %319, align 8
  %322 = getelementptr inbounds double, ptr %143, i64 %161
  %323 = load <8 x double>, ptr %322, align 8
  %324 = fadd <8 x double> %306, %323
  store <8 x double> %324, ptr %322, align 8
  %325 = getelementptr inbounds double, ptr %140, i64 %221
  %326 = load <8 x double>, ptr %325, align 8
  %327 = fadd <8 x double> %310, %326
  store <8 x double> %327, ptr %325, align 8
  %328 = getelementptr inbounds double, ptr %141, i64 %221
  %329 = load <8 x double>, ptr %328, align 8
  %330 = fadd <8 x double> %309, %329
  store <8 x double> %330, ptr %328, align 8
  %331 = getelementptr inbounds double, ptr %142, i64 %221
  %332 = load <8 x double>, ptr %331, align 8
  %333 = fadd <8 x double> %305, %332
  store <8 x double> %333, ptr %331, align 8
  %334 = or i64 %161, 2
  %335 = getelementptr inbounds double, ptr %140, i64 %334
  %336 = load <8 x double>, ptr %335, align 8
  %337 = fadd <8 x double> %307, %336
  store <8 x double> %337, ptr %335, align 8
  %338 = getelementptr inbounds double, ptr %141, i64 %334
  %339 = load <8 x double>, ptr %338, align 8
  %340 = fadd <8 x double> %304, %339
  store <8 x double> %340, ptr %338, align 8
  %341 = add nuw nsw i64 %161, 8
  %342 = icmp slt i64 %341, %139
  br i1 %342, label %160, label %156

343:                                              ; preds = %343, %260
  %344 = phi <8 x double> [ %239, %260 ], [ %390, %343 ]
  %345 = phi <8 x double> [ %244, %260 ], [ %398, %343 ]
  %346 = phi <8 x double> [ %241, %260 ], [ %392, %343 ]
  %347 = phi <8 x double> [ %249, %260 ], [ %406, %343 ]
  %348 = phi <8 x double> [ %246, %260 ], [ %402, %343 ]
  %349 = phi <8 x double> [ %250, %260 ], [ %394, %343 ]
  %350 = phi <8 x double> [ %251, %260 ], [ %418, %343 ]
  %351 = phi <8 x double> [ %252, %260 ], [ %410, %343 ]
  %352 = phi <8 x double> [ %254, %260 ], [ %414, %343 ]
  %353 = phi i64 [ 0, %260 ], [ %419, %343 ]
  %354 = mul nsw i64 %353, %139
  %355 = add nsw i64 %354, %161
  %356 = getelementptr inbounds double, ptr %261, i64 %355
  %357 = load <8 x double>, ptr %356, align 8
  %358 = getelementptr inbounds double, ptr %262, i64 %355
  %359 = load <8 x double>, ptr %358, align 8
  %360 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %359
  %361 = getelementptr inbounds double, ptr %263, i64 %355
  %362 = load <8 x double>, ptr %361, align 8
  %363 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %362
  %364 = getelementptr inbounds double, ptr %264, i64 %355
  %365 = load <8 x double>, ptr %364, align 8
  %366 = add nsw i64 %355, 1
  %367 = getelementptr inbounds double, ptr %264, i64 %366
  %368 = load <8 x double>, ptr %367, align 8
  %369 = getelementptr inbounds double, ptr %265, i64 %355
  %370 = load <8 x double>, ptr %369, align 8
  %371 = fsub <8 x double> %368, %370
  %372 = getelementptr inbounds double, ptr %265, i64 %366
  %373 = load <8 x double>, ptr %372, align 8
  %374 = fmul <8 x double> %255, %357
  %375 = fadd <8 x double> %374, %365
  %376 = fmul <8 x double> %360, %375
  %377 = fsub <8 x double> %374, %365
  %378 = fmul <8 x double> %363, %377
  %379 = fmul <8 x double> %256, %357
  %380 = fsub <8 x double> %379, %371
  %381 = fmul <8 x double> %360, %380
  %382 = fadd <8 x double> %379, %371
  %383 = fmul <8 x double> %363, %382
  %384 = fmul <8 x double> %257, %357
  %385 = fsub <8 x double> %384, %373
  %386 = fmul <8 x double> %360, %385
  %387 = fadd <8 x double> %384, %373
  %388 = fmul <8 x double> %363, %387
  %389 = fadd <8 x double> %376, %378
  %390 = fsub <8 x double> %344, %389
  %391 = fadd <8 x double> %381, %383
  %392 = fsub <8 x double> %346, %391
  %393 = fadd <8 x double> %386, %388
  %394 = fsub <8 x double> %349, %393
  %395 = fmul <8 x double> %376, %376
  %396 = fmul <8 x double> %378, %378
  %397 = fadd <8 x double> %395, %396
  %398 = fadd <8 x double> %345, %397
  %399 = fmul <8 x double> %376, %381
  %400 = fmul <8 x double> %378, %383
  %401 = fadd <8 x double> %399, %400
  %402 = fadd <8 x double> %348, %401
  %403 = fmul <8 x double> %381, %381
  %404 = fmul <8 x double> %383, %383
  %405 = fadd <8 x double> %403, %404
  %406 = fadd <8 x double> %347, %405
  %407 = fmul <8 x double> %381, %386
  %408 = fmul <8 x double> %383, %388
  %409 = fadd <8 x double> %407, %408
  %410 = fadd <8 x double> %351, %409
  %411 = fmul <8 x double> %386, %386
  %412 = fmul <8 x double> %388, %388
  %413 = fadd <8 x double> %411, %412
  %414 = fadd <8 x double> %352, %413
  %415 = fmul <8 x double> %376, %386
  %416 = fmul <8 x double> %378, %388
  %417 = fadd <8 x double> %415, %416
  %418 = fadd <8 x double> %350, %417
  %419 = add nuw nsw i64 %353, 1
  %420 = icmp eq i64 %419, %258
  br i1 %420, label %303, label %343

421:                                              ; preds = %470, %156
  %422 = phi i1 [ true, %156 ], [ false, %470 ]
  %423 = phi i64 [ 0, %156 ], [ 1, %470 ]
  %424 = select i1 %422, i64 0, i64 %157
  %425 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 15, i64 %423
  %426 = load double, ptr %425, align 8
  %427 = fcmp oeq double %426, 0.000000e+00
  br i1 %427, label %430, label %428

428:                                              ; preds = %421
  %429 = add nsw i64 %424, 1
  br label %470

430:                                              ; preds = %421
  %431 = getelementptr inbounds double, ptr %159, i64 %424
  %432 = load double, ptr %431, align 8
  %433 = fmul double %432, %432
  %434 = fmul double %432, %433
  %435 = load ptr, ptr %98, align 8
  %436 = getelementptr inbounds double, ptr %435, i64 %424
  %437 = load double, ptr %436, align 8
  %438 = fsub double 1.000000e+00, %437
  %439 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 17, i64 %423
  %440 = load double, ptr %439, align 8
  %441 = fmul double %127, %440
  %442 = fdiv double %441, %434
  %443 = fmul double %128, %440
  %444 = fmul double %432, %434
  %445 = fmul double %432, %444
  %446 = fdiv double %443, %445
  %447 = fmul double %437, %442
  %448 = getelementptr inbounds double, ptr %140, i64 %424
  %449 = load double, ptr %448, align 8
  %450 = fadd double %449, %447
  store double %450, ptr %448, align 8
  %451 = fmul double %438, %442
  %452 = add nsw i64 %424, 1
  %453 = getelementptr inbounds double, ptr %140, i64 %452
  %454 = load double, ptr %453, align 8
  %455 = fadd double %454, %451
  store double %455, ptr %453, align 8
  %456 = fmul double %437, %446
  %457 = fmul double %437, %456
  %458 = getelementptr inbounds double, ptr %141, i64 %424
  %459 = load double, ptr %458, align 8
  %460 = fadd double %457, %459
  store double %460, ptr %458, align 8
  %461 = fmul double %438, %456
  %462 = getelementptr inbounds double, ptr %142, i64 %424
  %463 = load double, ptr %462, align 8
  %464 = fadd double %461, %463
  store double %464, ptr %462, align 8
  %465 = fmul double %438, %446
  %466 = fmul double %438, %465
  %467 = getelementptr inbounds double, ptr %141, i64 %452
  %468 = load double, ptr %467, align 8
  %469 = fadd double %466, %468
  store double %469, ptr %467, align 8
  br label %470

470:                                              ; preds = %430, %428
  %471 = phi i64 [ %429, %428 ], [ %452, %430 ]
  %472 = getelementptr inbounds double, ptr %158, i64 %424
  %473 = load double, ptr %472, align 8
  %474 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 10, i64 %423
  %475 = load double, ptr %474, align 8
  %476 = fdiv double %473, %475
  %477 = fmul double %476, %476
  %478 = fneg double %476
  %479 = select i1 %422, double %478, double %476
  %480 = getelementptr inbounds double, ptr %140, i64 %424
  %481 = load double, ptr %480, align 8
  %482 = fadd double %481, %479
  store double %482, ptr %480, align 8
  %483 = select i1 %422, double %476, double %478
  %484 = getelementptr inbounds double, ptr %140, i64 %471
  %485 = load double, ptr %484, align 8
  %486 = fadd double %483, %485
  store double %486, ptr %484, align 8
  %487 = getelementptr inbounds double, ptr %141, i64 %424
  %488 = load double, ptr %487, align 8
  %489 = fadd double %477, %488
  store double %489, ptr %487, align 8
  %490 = getelementptr inbounds double, ptr %141, i64 %471
  %491 = load double, ptr %490, align 8
  %492 = fadd double %477, %491
  store double %492, ptr %490, align 8
  %493 = getelementptr inbounds double, ptr %142, i64 %424
  %494 = load double, ptr %493, align 8
  %495 = fsub double %494, %477
  store double %495, ptr %493, align 8
  br i1 %422, label %421, label %496

496:                                              ; preds = %470
  %497 = load double, ptr %105, align 8
  %498 = load double, ptr %106, align 8
  %499 = load double, ptr %140, align 8
  %500 = fmul double %497, %499
  %501 = getelementptr inbounds double, ptr %140, i64 1
  %502 = load double, ptr %501, align 8
  %503 = fadd double %502, %500
  store double %503, ptr %501, align 8
  %504 = fmul double %497, 2.000000e+00
  %505 = load double, ptr %142, align 8
  %506 = fmul double %504, %505
  %507 = fmul double %497, %497
  %508 = load double, ptr %141, align 8
  %509 = fmul double %507, %508
  %510 = fadd double %506, %509
  %511 = getelementptr inbounds double, ptr %141, i64 1
  %512 = load double, ptr %511, align 8
  %513 = fadd double %512, %510
  store double %513, ptr %511, align 8
  %514 = load double, ptr %143, align 8
  %515 = fmul double %497, %514
  %516 = getelementptr inbounds double, ptr %142, i64 1
  %517 = load double, ptr %516, align 8
  %518 = fadd double %517, %515
  store double %518, ptr %516, align 8
  %519 = getelementptr inbounds double, ptr %140, i64 %138
  %520 = load double, ptr %519, align 8
  %521 = fmul double %498, %520
  %522 = getelementptr inbounds double, ptr %140, i64 %157
  %523 = load double, ptr %522, align 8
  %524 = fadd double %523, %521
  store double %524, ptr %522, align 8
  %525 = fmul double %498, 2.000000e+00
  %526 = getelementptr inbounds double, ptr %142, i64 %157
  %527 = load double, ptr %526, align 8
  %528 = fmul double %525, %527
  %529 = fmul double %498, %498
  %530 = getelementptr inbounds double, ptr %141, i64 %138
  %531 = load double, ptr %530, align 8
  %532 = fmul double %529, %531
  %533 = fadd double %528, %532
  %534 = getelementptr inbounds double, ptr %141, i64 %157
  %535 = load double, ptr %534, align 8
  %536 = fadd double %535, %533
  store double %536, ptr %534, align 8
  %537 = add nsw i64 %138, -2
  %538 = getelementptr inbounds double, ptr %143, i64 %537
  %539 = load double, ptr %538, align 8
  %540 = fmul double %498, %539
  %541 = getelementptr inbounds double, ptr %142, i64 %537
  %542 = load double, ptr %541, align 8
  %543 = fadd double %542, %540
  store double %543, ptr %541, align 8
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %4)
  %544 = load ptr, ptr %8, align 8
  %545 = getelementptr inbounds double, ptr %544, i64 1
  %546 = load ptr, ptr %23, align 8
  %547 = getelementptr inbounds double, ptr %546, i64 1
  %548 = load ptr, ptr %25, align 8
  %549 = getelementptr inbounds double, ptr %548, i64 1
  %550 = load ptr, ptr %27, align 8
  %551 = getelementptr inbounds double, ptr %550, i64 1
  %552 = load ptr, ptr %29, align 8
  %553 = load ptr, ptr %31, align 8
  %554 = load ptr, ptr %33, align 8
  %555 = load ptr, ptr %35, align 8
  br i1 %129, label %557, label %698

556:                                              ; preds = %557
  br i1 %131, label %567, label %594

557:                                              ; preds = %496, %557
  %558 = phi i64 [ %564, %557 ], [ 0, %496 ]
  %559 = getelementptr inbounds double, ptr %547, i64 %558
  %560 = load double, ptr %559, align 8
  %561 = call double @llvm.sqrt.f64(double %560)
  %562 = fdiv double 1.000000e+00, %561
  %563 = getelementptr inbounds double, ptr %552, i64 %558
  store double %562, ptr %563, align 8
  %564 = add nuw nsw i64 %558, 1
  %565 = icmp eq i64 %564, %118
  br i1 %565, label %556, label %557

566:                                              ; preds = %567
  br i1 %132, label %580, label %594

567:                                              ; preds = %556, %567
  %568 = phi i64 [ %573, %567 ], [ 0, %556 ]
  %569 = getelementptr inbounds double, ptr %549, i64 %568
  %570 = load double, ptr %569, align 8
  %571 = getelementptr inbounds double, ptr %552, i64 %568
  %572 = load double, ptr %571, align 8
  %573 = add nuw nsw i64 %568, 1
  %574 = getelementptr inbounds double, ptr %552, i64 %573
  %575 = load double, ptr %574, align 8
  %576 = fmul double %572, %575
  %577 = fmul double %570, %576
  %578 = getelementptr inbounds double, ptr %553, i64 %573
  store double %577, ptr %578, align 8
  %579 = icmp eq i64 %573, %130
  br i1 %579, label %566, label %567

580:                                              ; preds = %566, %580
  %581 = phi i64 [ %592, %580 ], [ 0, %566 ]
  %582 = getelementptr inbounds double, ptr %551, i64 %581
  %583 = load double, ptr %582, align 8
  %584 = getelementptr inbounds double, ptr %552, i64 %581
  %585 = load double, ptr %584, align 8
  %586 = add nuw nsw i64 %581, 2
  %587 = getelementptr inbounds double, ptr %552, i64 %586
  %588 = load double, ptr %587, align 8
  %589 = fmul double %585, %588
  %590 = fmul double %583, %589
  %591 = getelementptr inbounds double, ptr %554, i64 %586
  store double %590, ptr %591, align 8
  %592 = add nuw nsw i64 %581, 1
  %593 = icmp eq i64 %581, %133
  br i1 %593, label %594, label %580

594:                                              ; preds = %580, %566, %556
  br label %595

595:                                              ; preds = %594, %644
  %596 = phi i64 [ %650, %644 ], [ 0, %594 ]
  %597 = getelementptr inbounds double, ptr %552, i64 %596
  %598 = load double, ptr %597, align 8
  %599 = getelementptr inbounds double, ptr %545, i64 %596
  %600 = load double, ptr %599, align 8
  %601 = fmul double %598, %600
  %602 = icmp ugt i64 %596, 1
  br i1 %602, label %603, label %623

603:                                              ; preds = %595
  %604 = getelementptr inbounds double, ptr %554, i64 %596
  %605 = load double, ptr %604, align 8
  %606 = add nsw i64 %596, -2
  %607 = getelementptr inbounds double, ptr %555, i64 %606
  %608 = load double, ptr %607, align 8
  %609 = fmul double %605, %608
  store double %609, ptr %604, align 8
  %610 = fmul double %605, %609
  %611 = fsub double 0x3FF000000000002D, %610
  %612 = getelementptr inbounds double, ptr %115, i64 %606
  %613 = load double, ptr %612, align 8
  %614 = fmul double %609, %613
  %615 = fsub double %601, %614
  %616 = add nsw i64 %596, -1
  %617 = getelementptr inbounds double, ptr %553, i64 %616
  %618 = load double, ptr %617, align 8
  %619 = fmul double %605, %618
  %620 = getelementptr inbounds double, ptr %553, i64 %596
  %621 = load double, ptr %620, align 8
  %622 = fsub double %621, %619
  store double %622, ptr %620, align 8
  br label %628

623:                                              ; preds = %595
  %624 = icmp eq i64 %596, 0
  br i1 %624, label %644, label %625

625:                                              ; preds = %623
  %626 = getelementptr inbounds double, ptr %553, i64 %596
  %627 = load double, ptr %626, align 8
  br label %628

628:                                              ; preds = %625, %603
  %629 = phi i64 [ 0, %625 ], [ %616, %603 ]
  %630 = phi double [ %627, %625 ], [ %622, %603 ]
  %631 = phi double [ %601, %625 ], [ %615, %603 ]
  %632 = phi double [ 0x3FF000000000002D, %625 ], [ %611, %603 ]
  %633 = getelementptr inbounds double, ptr %553, i64 %596
  %634 = getelementptr inbounds double, ptr %555, i64 %629
  %635 = load double, ptr %634, align 8
  %636 = fmul double %630, %635
  store double %636, ptr %633, align 8
  %637 = fmul double %630, %636
  %638 = fsub double %632, %637
  %639 = getelementptr inbounds double, ptr %115, i64 %629
  %640 = load double, ptr %639, align 8
  %641 = fmul double %636, %640
  %642 = fsub double %631, %641
  %643 = fcmp ogt double %638, 0.000000e+00
  br i1 %643, label %644, label %698

644:                                              ; preds = %628, %623
  %645 = phi double [ %642, %628 ], [ %601, %623 ]
  %646 = phi double [ %638, %628 ], [ 0x3FF000000000002D, %623 ]
  %647 = fdiv double 1.000000e+00, %646
  %648 = getelementptr inbounds double, ptr %555, i64 %596
  store double %647, ptr %648, align 8
  %649 = getelementptr inbounds double, ptr %115, i64 %596
  store double %645, ptr %649, align 8
  %650 = add nuw nsw i64 %596, 1
  %651 = icmp eq i64 %650, %118
  br i1 %651, label %652, label %595

652:                                              ; preds = %644, %679
  %653 = phi i64 [ %681, %679 ], [ %130, %644 ]
  %654 = getelementptr inbounds double, ptr %115, i64 %653
  %655 = load double, ptr %654, align 8
  %656 = getelementptr inbounds double, ptr %555, i64 %653
  %657 = load double, ptr %656, align 8
  %658 = fmul double %655, %657
  %659 = add nuw nsw i64 %653, 1
  %660 = icmp slt i64 %659, %118
  br i1 %660, label %661, label %668

661:                                              ; preds = %652
  %662 = getelementptr inbounds double, ptr %553, i64 %659
  %663 = load double, ptr %662, align 8
  %664 = getelementptr inbounds double, ptr %115, i64 %659
  %665 = load double, ptr %664, align 8
  %666 = fmul double %663, %665
  %667 = fsub double %658, %666
  br label %668

668:                                              ; preds = %661, %652
  %669 = phi double [ %667, %661 ], [ %658, %652 ]
  %670 = add nuw nsw i64 %653, 2
  %671 = icmp slt i64 %670, %118
  br i1 %671, label %672, label %679

672:                                              ; preds = %668
  %673 = getelementptr inbounds double, ptr %554, i64 %670
  %674 = load double, ptr %673, align 8
  %675 = getelementptr inbounds double, ptr %115, i64 %670
  %676 = load double, ptr %675, align 8
  %677 = fmul double %674, %676
  %678 = fsub double %669, %677
  br label %679

679:                                              ; preds = %672, %668
  %680 = phi double [ %678, %672 ], [ %669, %668 ]
  store double %680, ptr %654, align 8
  %681 = add nsw i64 %653, -1
  %682 = icmp sgt i64 %653, 0
  br i1 %682, label %652, label %683

683:                                              ; preds = %679, %683
  %684 = phi i64 [ %696, %683 ], [ 0, %679 ]
  %685 = phi double [ %695, %683 ], [ 0.000000e+00, %679 ]
  %686 = getelementptr inbounds double, ptr %552, i64 %684
  %687 = load double, ptr %686, align 8
  %688 = fneg double %687
  %689 = getelementptr inbounds double, ptr %115, i64 %684
  %690 = load double, ptr %689, align 8
  %691 = fmul double %690, %688
  store double %691, ptr %689, align 8
  %692 = getelementptr inbounds double, ptr %545, i64 %684
  %693 = load double, ptr %692, align 8
  %694 = fmul double %691, %693
  %695 = fsub double %685, %694
  %696 = add nuw nsw i64 %684, 1
  %697 = icmp eq i64 %696, %118
  br i1 %697, label %698, label %683

698:                                              ; preds = %628, %683, %496
  %699 = phi double [ 0.000000e+00, %496 ], [ %695, %683 ], [ 0x7FF8000000000000, %628 ]
  %700 = call double @llvm.fabs.f64(double %699) #10
  %701 = fcmp ueq double %700, 0x7FF0000000000000
  br i1 %701, label %744, label %702

702:                                              ; preds = %698
  %703 = load double, ptr %107, align 8
  %704 = fcmp olt double %699, %703
  br i1 %704, label %744, label %705

705:                                              ; preds = %702, %733
  %706 = phi double [ %734, %733 ], [ 1.000000e+00, %702 ]
  br i1 %129, label %712, label %709

707:                                              ; preds = %733
  %708 = call fastcc i32 @look(ptr noundef nonnull %0, ptr noundef %2, ptr noundef nonnull %7)
  br label %744

709:                                              ; preds = %712, %705
  %710 = call fastcc i32 @look(ptr noundef nonnull %0, ptr noundef %116, ptr noundef nonnull %7)
  %711 = icmp eq i32 %710, 0
  br i1 %711, label %733, label %723

712:                                              ; preds = %705, %712
  %713 = phi i64 [ %721, %712 ], [ 0, %705 ]
  %714 = getelementptr inbounds double, ptr %2, i64 %713
  %715 = load double, ptr %714, align 8
  %716 = getelementptr inbounds double, ptr %115, i64 %713
  %717 = load double, ptr %716, align 8
  %718 = fmul double %706, %717
  %719 = fadd double %715, %718
  %720 = getelementptr inbounds double, ptr %116, i64 %713
  store double %719, ptr %720, align 8
  %721 = add nuw nsw i64 %713, 1
  %722 = icmp eq i64 %721, %118
  br i1 %722, label %709, label %712

723:                                              ; preds = %709
  %724 = load double, ptr %89, align 8
  %725 = fmul double %114, %724
  %726 = load double, ptr %92, align 8
  %727 = fsub double %725, %726
  %728 = load double, ptr %108, align 8
  %729 = fmul double %706, %728
  %730 = fmul double %699, %729
  %731 = fsub double %137, %730
  %732 = fcmp ugt double %727, %731
  br i1 %732, label %733, label %736

733:                                              ; preds = %723, %709
  %734 = fmul double %706, 5.000000e-01
  %735 = fcmp ugt double %734, 1.000000e-09
  br i1 %735, label %705, label %707

736:                                              ; preds = %723
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %2, ptr align 8 %116, i64 %134, i1 false)
  %737 = fsub double %137, %727
  %738 = load double, ptr %107, align 8
  %739 = fcmp olt double %737, %738
  %740 = add nuw nsw i64 %136, 1
  br i1 %739, label %744, label %741

741:                                              ; preds = %736
  %742 = load i64, ptr %93, align 8
  %743 = icmp slt i64 %740, %742
  br i1 %743, label %135, label %744

744:                                              ; preds = %698, %702, %741, %736, %111, %707
  %745 = phi i64 [ %136, %707 ], [ 0, %111 ], [ %136, %698 ], [ %136, %702 ], [ %740, %741 ], [ %740, %736 ]
  %746 = add nsw i64 %745, %113
  %747 = load double, ptr %1, align 8
  %748 = fdiv double %747, %114
  %749 = load double, ptr %109, align 8
  %750 = load double, ptr %89, align 8
  %751 = fmul double %749, %750
  %752 = fcmp olt double %748, %751
  br i1 %752, label %756, label %753

753:                                              ; preds = %744
  %754 = load double, ptr %110, align 8
  %755 = fmul double %114, %754
  br label %111

756:                                              ; preds = %744, %81
  %757 = phi i64 [ -1, %81 ], [ %746, %744 ]
  call void @free(ptr noundef %57) #8
  br label %758

758:                                              ; preds = %59, %756
  %759 = phi i64 [ %757, %756 ], [ -2, %59 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %10) #8
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #8
  call void @llvm.lifetime.end.p0(i64 64, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 112, ptr nonnull %7) #8
  ret i64 %759
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

define internal fastcc i32 @look(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef %2) unnamed_addr #2 {
  %4 = load i64, ptr %0, align 8
  %5 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 3
  %6 = load i64, ptr %5, align 8
  %7 = load ptr, ptr %2, align 8
  %8 = getelementptr inbounds double, ptr %7, i64 1
  %9 = add nsw i64 %4, -1
  %10 = shl i64 %9, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %8, ptr align 8 %1, i64 %10, i1 false)
  %11 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 16
  %12 = load double, ptr %11, align 8
  %13 = load double, ptr %1, align 8
  %14 = fmul double %12, %13
  %15 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 15
  %16 = load double, ptr %15, align 8
  %17 = fadd double %14, %16
  store double %17, ptr %7, align 8
  %18 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 16, i64 1
  %19 = load double, ptr %18, align 8
  %20 = add nsw i64 %4, -2
  %21 = getelementptr inbounds double, ptr %1, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = fmul double %19, %22
  %24 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 15, i64 1
  %25 = load double, ptr %24, align 8
  %26 = fadd double %23, %25
  %27 = getelementptr inbounds double, ptr %7, i64 %4
  store double %26, ptr %27, align 8
  %28 = icmp slt i64 %4, 0
  br i1 %28, label %32, label %35

29:                                               ; preds = %35
  %30 = add nuw i64 %36, 1
  %31 = icmp eq i64 %36, %4
  br i1 %31, label %32, label %35

32:                                               ; preds = %29, %3
  %33 = add nsw i64 %6, 7
  %34 = icmp slt i64 %4, %33
  br i1 %34, label %47, label %40

35:                                               ; preds = %3, %29
  %36 = phi i64 [ %30, %29 ], [ 0, %3 ]
  %37 = getelementptr inbounds double, ptr %7, i64 %36
  %38 = load double, ptr %37, align 8
  %39 = fcmp ogt double %38, 0.000000e+00
  br i1 %39, label %29, label %458

40:                                               ; preds = %47, %32
  %41 = icmp sgt i64 %6, 0
  br i1 %41, label %42, label %52

42:                                               ; preds = %40
  %43 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 5
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 1
  %46 = load ptr, ptr %45, align 8
  br label %103

47:                                               ; preds = %32, %47
  %48 = phi i64 [ %49, %47 ], [ %4, %32 ]
  %49 = add nsw i64 %48, 1
  %50 = getelementptr inbounds double, ptr %7, i64 %49
  store double 1.000000e+00, ptr %50, align 8
  %51 = icmp eq i64 %49, %33
  br i1 %51, label %40, label %47

52:                                               ; preds = %103, %40
  %53 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 18
  %54 = load double, ptr %53, align 8
  %55 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 6
  %56 = load ptr, ptr %55, align 8
  %57 = load double, ptr %56, align 8
  %58 = load double, ptr %8, align 8
  %59 = load double, ptr %7, align 8
  %60 = fsub double %58, %59
  %61 = fmul double %57, %60
  %62 = fsub double %54, %61
  %63 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 10
  store double %62, ptr %63, align 8
  %64 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 18, i64 1
  %65 = load double, ptr %64, align 8
  %66 = getelementptr inbounds double, ptr %56, i64 %9
  %67 = load double, ptr %66, align 8
  %68 = load double, ptr %27, align 8
  %69 = getelementptr inbounds double, ptr %7, i64 %9
  %70 = load double, ptr %69, align 8
  %71 = fsub double %68, %70
  %72 = fmul double %67, %71
  %73 = fadd double %65, %72
  %74 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 10, i64 1
  store double %73, ptr %74, align 8
  %75 = fcmp ogt double %62, 0.000000e+00
  %76 = fcmp ogt double %73, 0.000000e+00
  %77 = select i1 %75, i1 %76, i1 false
  br i1 %77, label %78, label %458

78:                                               ; preds = %52
  br i1 %41, label %79, label %381

79:                                               ; preds = %78
  %80 = insertelement <8 x i64> poison, i64 %9, i64 0
  %81 = shufflevector <8 x i64> %80, <8 x i64> poison, <8 x i32> zeroinitializer
  %82 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 7
  %83 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 5
  %84 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 8
  %85 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 4
  %86 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 5
  %87 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 1
  %88 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 9
  %89 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 10
  %90 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 11
  %91 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 6
  %92 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 7
  %93 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 1
  %94 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 4
  %95 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 2
  %96 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 3
  %97 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 2
  %98 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 12
  %99 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 13
  %100 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 14
  %101 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 8
  %102 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 9
  br label %119

103:                                              ; preds = %42, %103
  %104 = phi i64 [ 0, %42 ], [ %111, %103 ]
  %105 = getelementptr inbounds double, ptr %44, i64 %104
  %106 = load double, ptr %105, align 8
  %107 = getelementptr inbounds double, ptr %7, i64 %104
  %108 = load double, ptr %107, align 8
  %109 = fmul double %106, %108
  %110 = fsub double 1.000000e+00, %106
  %111 = add nuw nsw i64 %104, 1
  %112 = getelementptr inbounds double, ptr %7, i64 %111
  %113 = load double, ptr %112, align 8
  %114 = fmul double %110, %113
  %115 = fadd double %109, %114
  %116 = tail call double @llvm.sqrt.f64(double %115)
  %117 = getelementptr inbounds double, ptr %46, i64 %104
  store double %116, ptr %117, align 8
  %118 = icmp eq i64 %111, %6
  br i1 %118, label %52, label %103

119:                                              ; preds = %79, %375
  %120 = phi <8 x i64> [ zeroinitializer, %79 ], [ %378, %375 ]
  %121 = phi i64 [ 0, %79 ], [ %379, %375 ]
  %122 = phi <8 x double> [ zeroinitializer, %79 ], [ %272, %375 ]
  %123 = phi <8 x double> [ zeroinitializer, %79 ], [ %377, %375 ]
  %124 = insertelement <8 x i64> poison, i64 %121, i64 0
  %125 = shufflevector <8 x i64> %124, <8 x i64> poison, <8 x i32> zeroinitializer
  %126 = or <8 x i64> %125, <i64 0, i64 1, i64 2, i64 3, i64 4, i64 5, i64 6, i64 7>
  %127 = icmp slt <8 x i64> %126, %81
  %128 = sext <8 x i1> %127 to <8 x i64>
  %129 = getelementptr inbounds double, ptr %7, i64 %121
  %130 = load <8 x double>, ptr %129, align 8
  %131 = or i64 %121, 1
  %132 = getelementptr inbounds double, ptr %7, i64 %131
  %133 = load <8 x double>, ptr %132, align 8
  %134 = or i64 %121, 2
  %135 = getelementptr inbounds double, ptr %7, i64 %134
  %136 = load <8 x double>, ptr %135, align 8
  %137 = load ptr, ptr %82, align 8
  %138 = getelementptr inbounds double, ptr %137, i64 %121
  %139 = load <8 x double>, ptr %138, align 8
  %140 = load ptr, ptr %83, align 8
  %141 = getelementptr inbounds double, ptr %140, i64 %121
  %142 = load <8 x double>, ptr %141, align 8
  %143 = fmul <8 x double> %130, %142
  %144 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %142
  %145 = fmul <8 x double> %133, %144
  %146 = fadd <8 x double> %143, %145
  %147 = fsub <8 x double> %139, %146
  %148 = load ptr, ptr %84, align 8
  %149 = getelementptr inbounds double, ptr %148, i64 %121
  %150 = load <8 x double>, ptr %149, align 8
  %151 = fsub <8 x double> %150, %130
  %152 = load ptr, ptr %85, align 8
  %153 = getelementptr inbounds double, ptr %152, i64 %121
  store <8 x double> %147, ptr %153, align 8
  %154 = load ptr, ptr %86, align 8
  %155 = getelementptr inbounds double, ptr %154, i64 %121
  store <8 x double> %151, ptr %155, align 8
  %156 = fcmp une <8 x double> %147, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %157 = select <8 x i1> %156, <8 x double> %147, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %158 = fcmp une <8 x double> %151, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %159 = select <8 x i1> %158, <8 x double> %151, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %160 = fmul <8 x double> %159, %157
  %161 = fcmp ogt <8 x double> %157, zeroinitializer
  %162 = fcmp ogt <8 x double> %159, zeroinitializer
  %163 = and <8 x i1> %161, %162
  %164 = fcmp ogt <8 x double> %160, <double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000>
  %165 = and <8 x i1> %163, %164
  %166 = fcmp olt <8 x double> %160, <double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000>
  %167 = and <8 x i1> %165, %166
  %168 = bitcast <8 x double> %160 to <8 x i64>
  %169 = ashr <8 x i64> %168, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %170 = and <8 x i64> %168, <i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495>
  %171 = or <8 x i64> %170, <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>
  %172 = bitcast <8 x i64> %171 to <8 x double>
  %173 = fmul <8 x double> %130, %172
  %174 = fcmp ogt <8 x double> %130, zeroinitializer
  %175 = fcmp ogt <8 x double> %173, <double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000>
  %176 = and <8 x i1> %175, %174
  %177 = fcmp olt <8 x double> %173, <double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000>
  %178 = and <8 x i1> %176, %177
  %179 = select <8 x i1> %178, <8 x i1> %167, <8 x i1> zeroinitializer
  %180 = xor <8 x i1> %179, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %181 = sext <8 x i1> %180 to <8 x i64>
  %182 = bitcast <8 x double> %173 to <8 x i64>
  %183 = ashr <8 x i64> %182, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %184 = add nsw <8 x i64> %169, <i64 -2046, i64 -2046, i64 -2046, i64 -2046, i64 -2046, i64 -2046, i64 -2046, i64 -2046>
  %185 = add nsw <8 x i64> %184, %183
  %186 = and <8 x i64> %182, <i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495>
  %187 = or <8 x i64> %186, <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>
  %188 = load i64, ptr %87, align 8
  %189 = icmp sgt i64 %188, 0
  br i1 %189, label %203, label %190

190:                                              ; preds = %203, %119
  %191 = phi <8 x i64> [ %185, %119 ], [ %243, %203 ]
  %192 = phi <8 x i64> [ %181, %119 ], [ %239, %203 ]
  %193 = phi <8 x i64> [ %187, %119 ], [ %246, %203 ]
  br label %194

194:                                              ; preds = %190, %194
  %195 = phi i32 [ %199, %194 ], [ 0, %190 ]
  %196 = phi i64 [ %198, %194 ], [ 0, %190 ]
  %197 = extractelement <8 x i64> %192, i32 %195
  %198 = or i64 %197, %196
  %199 = add nuw nsw i32 %195, 1
  %200 = icmp eq i32 %199, 8
  br i1 %200, label %201, label %194

201:                                              ; preds = %194
  %202 = icmp eq i64 %198, 0
  br i1 %202, label %249, label %458

203:                                              ; preds = %119, %203
  %204 = phi <8 x i64> [ %246, %203 ], [ %187, %119 ]
  %205 = phi i64 [ %244, %203 ], [ 0, %119 ]
  %206 = phi <8 x i64> [ %239, %203 ], [ %181, %119 ]
  %207 = phi <8 x i64> [ %243, %203 ], [ %185, %119 ]
  %208 = mul nsw i64 %205, %6
  %209 = add nsw i64 %208, %121
  %210 = load ptr, ptr %88, align 8
  %211 = getelementptr inbounds double, ptr %210, i64 %209
  %212 = load <8 x double>, ptr %211, align 8
  %213 = fmul <8 x double> %130, %212
  %214 = load ptr, ptr %89, align 8
  %215 = getelementptr inbounds double, ptr %214, i64 %209
  %216 = load <8 x double>, ptr %215, align 8
  %217 = fmul <8 x double> %133, %216
  %218 = fadd <8 x double> %213, %217
  %219 = load ptr, ptr %90, align 8
  %220 = getelementptr inbounds double, ptr %219, i64 %209
  %221 = load <8 x double>, ptr %220, align 8
  %222 = fadd <8 x double> %218, %221
  %223 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %222
  %224 = fadd <8 x double> %222, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %225 = load ptr, ptr %91, align 8
  %226 = getelementptr inbounds double, ptr %225, i64 %209
  store <8 x double> %223, ptr %226, align 8
  %227 = load ptr, ptr %92, align 8
  %228 = getelementptr inbounds double, ptr %227, i64 %209
  store <8 x double> %224, ptr %228, align 8
  %229 = bitcast <8 x i64> %204 to <8 x double>
  %230 = fmul <8 x double> %223, %224
  %231 = fmul <8 x double> %230, %229
  %232 = fcmp ogt <8 x double> %223, zeroinitializer
  %233 = fcmp ogt <8 x double> %224, zeroinitializer
  %234 = and <8 x i1> %233, %232
  %235 = fcmp ogt <8 x double> %231, <double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000>
  %236 = and <8 x i1> %234, %235
  %237 = fcmp olt <8 x double> %231, <double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000>
  %238 = and <8 x i1> %236, %237
  %239 = select <8 x i1> %238, <8 x i64> %206, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %240 = bitcast <8 x double> %231 to <8 x i64>
  %241 = ashr <8 x i64> %240, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %242 = add <8 x i64> %207, <i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023>
  %243 = add <8 x i64> %242, %241
  %244 = add nuw nsw i64 %205, 1
  %245 = and <8 x i64> %240, <i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495>
  %246 = or <8 x i64> %245, <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>
  %247 = load i64, ptr %87, align 8
  %248 = icmp slt i64 %244, %247
  br i1 %248, label %203, label %190

249:                                              ; preds = %201
  %250 = load ptr, ptr %93, align 8
  %251 = getelementptr inbounds double, ptr %250, i64 %121
  %252 = load <8 x double>, ptr %251, align 8
  %253 = getelementptr inbounds double, ptr %250, i64 %131
  %254 = load <8 x double>, ptr %253, align 8
  %255 = fadd <8 x double> %252, %254
  %256 = load ptr, ptr %94, align 8
  %257 = getelementptr inbounds double, ptr %256, i64 %121
  %258 = load <8 x double>, ptr %257, align 8
  %259 = fmul <8 x double> %258, <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %260 = fdiv <8 x double> %259, %255
  %261 = load ptr, ptr %95, align 8
  %262 = getelementptr inbounds double, ptr %261, i64 %121
  store <8 x double> %260, ptr %262, align 8
  %263 = fneg <8 x double> %260
  %264 = fdiv <8 x double> %263, %255
  %265 = bitcast <8 x double> %264 to <8 x i64>
  %266 = and <8 x i64> %265, %128
  %267 = load ptr, ptr %96, align 8
  %268 = getelementptr inbounds double, ptr %267, i64 %121
  store <8 x i64> %266, ptr %268, align 8
  %269 = bitcast <8 x double> %260 to <8 x i64>
  %270 = and <8 x i64> %269, %128
  %271 = bitcast <8 x i64> %270 to <8 x double>
  %272 = fadd <8 x double> %122, %271
  %273 = load i64, ptr %97, align 8
  %274 = icmp sgt i64 %273, 0
  br i1 %274, label %275, label %278

275:                                              ; preds = %249
  %276 = select <8 x i1> %127, <8 x i64> zeroinitializer, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>
  %277 = select <8 x i1> %127, <8 x i64> zeroinitializer, <8 x i64> <i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312>
  br label %291

278:                                              ; preds = %291, %249
  %279 = phi <8 x i64> [ %193, %249 ], [ %354, %291 ]
  %280 = phi <8 x i64> [ %191, %249 ], [ %352, %291 ]
  %281 = phi <8 x i64> [ %192, %249 ], [ %348, %291 ]
  br label %282

282:                                              ; preds = %278, %282
  %283 = phi i32 [ %287, %282 ], [ 0, %278 ]
  %284 = phi i64 [ %286, %282 ], [ 0, %278 ]
  %285 = extractelement <8 x i64> %281, i32 %283
  %286 = or i64 %285, %284
  %287 = add nuw nsw i32 %283, 1
  %288 = icmp eq i32 %287, 8
  br i1 %288, label %289, label %282

289:                                              ; preds = %282
  %290 = icmp eq i64 %286, 0
  br i1 %290, label %358, label %458

291:                                              ; preds = %275, %291
  %292 = phi i64 [ 0, %275 ], [ %355, %291 ]
  %293 = phi <8 x i64> [ %192, %275 ], [ %348, %291 ]
  %294 = phi <8 x i64> [ %191, %275 ], [ %352, %291 ]
  %295 = phi <8 x i64> [ %193, %275 ], [ %354, %291 ]
  %296 = mul nsw i64 %292, %6
  %297 = add nsw i64 %296, %121
  %298 = load ptr, ptr %98, align 8
  %299 = add nsw i64 %297, 1
  %300 = getelementptr inbounds double, ptr %298, i64 %299
  %301 = load <8 x double>, ptr %300, align 8
  %302 = fmul <8 x double> %133, %301
  %303 = load ptr, ptr %99, align 8
  %304 = getelementptr inbounds double, ptr %303, i64 %299
  %305 = load <8 x double>, ptr %304, align 8
  %306 = fmul <8 x double> %136, %305
  %307 = fadd <8 x double> %302, %306
  %308 = getelementptr inbounds double, ptr %298, i64 %297
  %309 = load <8 x double>, ptr %308, align 8
  %310 = fmul <8 x double> %130, %309
  %311 = getelementptr inbounds double, ptr %303, i64 %297
  %312 = load <8 x double>, ptr %311, align 8
  %313 = fmul <8 x double> %133, %312
  %314 = fadd <8 x double> %310, %313
  %315 = fsub <8 x double> %307, %314
  %316 = load ptr, ptr %100, align 8
  %317 = getelementptr inbounds double, ptr %316, i64 %297
  %318 = load <8 x double>, ptr %317, align 8
  %319 = fmul <8 x double> %260, %318
  %320 = fsub <8 x double> %319, %315
  %321 = bitcast <8 x double> %320 to <8 x i64>
  %322 = and <8 x i64> %321, %128
  %323 = or <8 x i64> %322, %276
  %324 = fadd <8 x double> %319, %315
  %325 = bitcast <8 x double> %324 to <8 x i64>
  %326 = and <8 x i64> %325, %128
  %327 = or <8 x i64> %326, %276
  %328 = and <8 x i64> %323, %128
  %329 = or <8 x i64> %328, %277
  %330 = load ptr, ptr %101, align 8
  %331 = getelementptr inbounds double, ptr %330, i64 %297
  store <8 x i64> %329, ptr %331, align 8
  %332 = and <8 x i64> %327, %128
  %333 = or <8 x i64> %332, %277
  %334 = load ptr, ptr %102, align 8
  %335 = getelementptr inbounds double, ptr %334, i64 %297
  store <8 x i64> %333, ptr %335, align 8
  %336 = bitcast <8 x i64> %295 to <8 x double>
  %337 = bitcast <8 x i64> %323 to <8 x double>
  %338 = bitcast <8 x i64> %327 to <8 x double>
  %339 = fmul <8 x double> %337, %338
  %340 = fmul <8 x double> %339, %336
  %341 = fcmp ogt <8 x double> %337, zeroinitializer
  %342 = fcmp ogt <8 x double> %338, zeroinitializer
  %343 = and <8 x i1> %342, %341
  %344 = fcmp ogt <8 x double> %340, <double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000>
  %345 = and <8 x i1> %343, %344
  %346 = fcmp olt <8 x double> %340, <double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000>
  %347 = and <8 x i1> %345, %346
  %348 = select <8 x i1> %347, <8 x i64> %293, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %349 = bitcast <8 x double> %340 to <8 x i64>
  %350 = ashr <8 x i64> %349, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %351 = add <8 x i64> %294, <i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023>
  %352 = add <8 x i64> %351, %350
  %353 = and <8 x i64> %349, <i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495>
  %354 = or <8 x i64> %353, <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>
  %355 = add nuw nsw i64 %292, 1
  %356 = load i64, ptr %97, align 8
  %357 = icmp slt i64 %355, %356
  br i1 %357, label %291, label %278

358:                                              ; preds = %289
  %359 = bitcast <8 x i64> %279 to <8 x double>
  %360 = fadd <8 x double> %359, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %361 = fadd <8 x double> %359, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %362 = fdiv <8 x double> %360, %361
  %363 = fmul <8 x double> %362, %362
  br label %364

364:                                              ; preds = %358, %364
  %365 = phi i64 [ 0, %358 ], [ %373, %364 ]
  %366 = phi <8 x double> [ zeroinitializer, %358 ], [ %372, %364 ]
  %367 = fmul <8 x double> %363, %366
  %368 = getelementptr inbounds [18 x double], ptr @ODD, i64 0, i64 %365
  %369 = load double, ptr %368, align 8
  %370 = insertelement <8 x double> poison, double %369, i64 0
  %371 = shufflevector <8 x double> %370, <8 x double> poison, <8 x i32> zeroinitializer
  %372 = fadd <8 x double> %367, %371
  %373 = add nuw nsw i64 %365, 1
  %374 = icmp eq i64 %373, 18
  br i1 %374, label %375, label %364

375:                                              ; preds = %364
  %376 = fmul <8 x double> %362, %372
  %377 = fadd <8 x double> %123, %376
  %378 = add <8 x i64> %280, %120
  %379 = add nuw nsw i64 %121, 8
  %380 = icmp slt i64 %379, %6
  br i1 %380, label %119, label %381

381:                                              ; preds = %375, %78
  %382 = phi <8 x double> [ zeroinitializer, %78 ], [ %377, %375 ]
  %383 = phi <8 x i64> [ zeroinitializer, %78 ], [ %378, %375 ]
  %384 = phi <8 x double> [ zeroinitializer, %78 ], [ %272, %375 ]
  br label %423

385:                                              ; preds = %423
  %386 = sitofp i64 %427 to double
  %387 = fmul double %386, 0x3FE62E42FEFA39EF
  %388 = extractelement <8 x double> %382, i64 0
  %389 = extractelement <8 x double> %382, i64 1
  %390 = fadd double %388, %389
  %391 = extractelement <8 x double> %382, i64 2
  %392 = extractelement <8 x double> %382, i64 3
  %393 = fadd double %391, %392
  %394 = fadd double %390, %393
  %395 = extractelement <8 x double> %382, i64 4
  %396 = extractelement <8 x double> %382, i64 5
  %397 = fadd double %395, %396
  %398 = extractelement <8 x double> %382, i64 6
  %399 = extractelement <8 x double> %382, i64 7
  %400 = fadd double %398, %399
  %401 = fadd double %397, %400
  %402 = fadd double %394, %401
  %403 = fmul double %402, 2.000000e+00
  %404 = fadd double %403, %387
  %405 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 12
  store double %404, ptr %405, align 8
  %406 = extractelement <8 x double> %384, i64 0
  %407 = extractelement <8 x double> %384, i64 1
  %408 = fadd double %406, %407
  %409 = extractelement <8 x double> %384, i64 2
  %410 = extractelement <8 x double> %384, i64 3
  %411 = fadd double %409, %410
  %412 = fadd double %408, %411
  %413 = extractelement <8 x double> %384, i64 4
  %414 = extractelement <8 x double> %384, i64 5
  %415 = fadd double %413, %414
  %416 = extractelement <8 x double> %384, i64 6
  %417 = extractelement <8 x double> %384, i64 7
  %418 = fadd double %416, %417
  %419 = fadd double %415, %418
  %420 = fadd double %412, %419
  %421 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 11
  store double %420, ptr %421, align 8
  %422 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 1
  br label %430

423:                                              ; preds = %381, %423
  %424 = phi i32 [ %428, %423 ], [ 0, %381 ]
  %425 = phi i64 [ %427, %423 ], [ 0, %381 ]
  %426 = extractelement <8 x i64> %383, i32 %424
  %427 = add nsw i64 %426, %425
  %428 = add nuw nsw i32 %424, 1
  %429 = icmp eq i32 %428, 8
  br i1 %429, label %385, label %423

430:                                              ; preds = %385, %456
  %431 = phi double [ %404, %385 ], [ %457, %456 ]
  %432 = phi double [ %420, %385 ], [ %449, %456 ]
  %433 = phi i1 [ true, %385 ], [ false, %456 ]
  %434 = phi i64 [ 0, %385 ], [ 1, %456 ]
  %435 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 15, i64 %434
  %436 = load double, ptr %435, align 8
  %437 = fcmp oeq double %436, 0.000000e+00
  br i1 %437, label %438, label %448

438:                                              ; preds = %430
  %439 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 17, i64 %434
  %440 = load double, ptr %439, align 8
  %441 = fmul double %440, 3.000000e+00
  %442 = load ptr, ptr %422, align 8
  %443 = select i1 %433, i64 0, i64 %9
  %444 = getelementptr inbounds double, ptr %442, i64 %443
  %445 = load double, ptr %444, align 8
  %446 = fdiv double %441, %445
  %447 = fadd double %432, %446
  store double %447, ptr %421, align 8
  br label %448

448:                                              ; preds = %438, %430
  %449 = phi double [ %447, %438 ], [ %432, %430 ]
  %450 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 10, i64 %434
  %451 = load double, ptr %450, align 8
  %452 = fcmp olt double %451, 0x7FF0000000000000
  br i1 %452, label %453, label %456

453:                                              ; preds = %448
  %454 = tail call double @llvm.log.f64(double %451)
  %455 = fadd double %454, %431
  store double %455, ptr %405, align 8
  br label %456

456:                                              ; preds = %448, %453
  %457 = phi double [ %431, %448 ], [ %455, %453 ]
  br i1 %433, label %430, label %458

458:                                              ; preds = %35, %289, %201, %456, %52
  %459 = phi i32 [ 0, %52 ], [ 1, %456 ], [ 0, %201 ], [ 0, %289 ], [ 0, %35 ]
  ret i32 %459
}

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

declare void @free(ptr allocptr nocapture noundef) local_unnamed_addr #3

define dso_local i64 @manipplan_enter(ptr nocapture noundef readonly %0, ptr nocapture noundef %1, double noundef %2, i64 noundef %3) local_unnamed_addr #0 {
  %5 = alloca [16 x ptr], align 16
  %6 = alloca [4 x ptr], align 16
  %7 = alloca %struct.State, align 8
  %8 = alloca %struct.Model, align 8
  %9 = alloca ptr, align 8
  %10 = alloca ptr, align 8
  call void @llvm.lifetime.start.p0(i64 112, ptr nonnull %7) #8
  call void @llvm.lifetime.start.p0(i64 64, ptr nonnull %8) #8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %9) #8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %10) #8
  call void @llvm.lifetime.start.p0(i64 128, ptr nonnull %5) #8
  store ptr %7, ptr %5, align 16
  %11 = getelementptr inbounds ptr, ptr %5, i64 1
  %12 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 1
  store ptr %12, ptr %11, align 8
  %13 = getelementptr inbounds ptr, ptr %5, i64 2
  %14 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 2
  store ptr %14, ptr %13, align 16
  %15 = getelementptr inbounds ptr, ptr %5, i64 3
  %16 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 3
  store ptr %16, ptr %15, align 8
  %17 = getelementptr inbounds ptr, ptr %5, i64 4
  %18 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 4
  store ptr %18, ptr %17, align 16
  %19 = getelementptr inbounds ptr, ptr %5, i64 5
  %20 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 5
  store ptr %20, ptr %19, align 8
  %21 = getelementptr inbounds ptr, ptr %5, i64 6
  store ptr %8, ptr %21, align 16
  %22 = getelementptr inbounds ptr, ptr %5, i64 7
  %23 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 1
  store ptr %23, ptr %22, align 8
  %24 = getelementptr inbounds ptr, ptr %5, i64 8
  %25 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 2
  store ptr %25, ptr %24, align 16
  %26 = getelementptr inbounds ptr, ptr %5, i64 9
  %27 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 3
  store ptr %27, ptr %26, align 8
  %28 = getelementptr inbounds ptr, ptr %5, i64 10
  %29 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 4
  store ptr %29, ptr %28, align 16
  %30 = getelementptr inbounds ptr, ptr %5, i64 11
  %31 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 5
  store ptr %31, ptr %30, align 8
  %32 = getelementptr inbounds ptr, ptr %5, i64 12
  %33 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 6
  store ptr %33, ptr %32, align 16
  %34 = getelementptr inbounds ptr, ptr %5, i64 13
  %35 = getelementptr inbounds %struct.Model, ptr %8, i64 0, i32 7
  store ptr %35, ptr %34, align 8
  %36 = getelementptr inbounds ptr, ptr %5, i64 14
  store ptr %9, ptr %36, align 16
  %37 = getelementptr inbounds ptr, ptr %5, i64 15
  store ptr %10, ptr %37, align 8
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %6) #8
  %38 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 6
  store ptr %38, ptr %6, align 16
  %39 = getelementptr inbounds ptr, ptr %6, i64 1
  %40 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 7
  store ptr %40, ptr %39, align 8
  %41 = getelementptr inbounds ptr, ptr %6, i64 2
  %42 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 8
  store ptr %42, ptr %41, align 16
  %43 = getelementptr inbounds ptr, ptr %6, i64 3
  %44 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 9
  store ptr %44, ptr %43, align 8
  %45 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 3
  %46 = load i64, ptr %45, align 8
  %47 = add nsw i64 %46, 16
  %48 = shl nsw i64 %47, 4
  %49 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 1
  %50 = load i64, ptr %49, align 8
  %51 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 2
  %52 = load i64, ptr %51, align 8
  %53 = add nsw i64 %52, %50
  %54 = shl i64 %46, 1
  %55 = mul i64 %54, %53
  %56 = add nsw i64 %55, %48
  %57 = call noalias ptr @calloc(i64 noundef %56, i64 noundef 8) #9
  %58 = icmp eq ptr %57, null
  br i1 %58, label %59, label %60

59:                                               ; preds = %4
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %6) #8
  call void @llvm.lifetime.end.p0(i64 128, ptr nonnull %5) #8
  br label %104

60:                                               ; preds = %4, %60
  %61 = phi i64 [ %66, %60 ], [ 0, %4 ]
  %62 = phi ptr [ %67, %60 ], [ %57, %4 ]
  %63 = getelementptr inbounds double, ptr %62, i64 8
  %64 = getelementptr inbounds [16 x ptr], ptr %5, i64 0, i64 %61
  %65 = load ptr, ptr %64, align 8
  store ptr %63, ptr %65, align 8
  %66 = add nuw nsw i64 %61, 1
  %67 = getelementptr inbounds double, ptr %62, i64 %47
  %68 = icmp eq i64 %66, 16
  br i1 %68, label %69, label %60

69:                                               ; preds = %60, %69
  %70 = phi i64 [ %79, %69 ], [ 0, %60 ]
  %71 = phi ptr [ %78, %69 ], [ %67, %60 ]
  %72 = getelementptr inbounds [4 x ptr], ptr %6, i64 0, i64 %70
  %73 = load ptr, ptr %72, align 8
  store ptr %71, ptr %73, align 8
  %74 = icmp ult i64 %70, 2
  %75 = select i1 %74, ptr %49, ptr %51
  %76 = load i64, ptr %75, align 8
  %77 = mul nsw i64 %76, %46
  %78 = getelementptr inbounds double, ptr %71, i64 %77
  %79 = add nuw nsw i64 %70, 1
  %80 = icmp eq i64 %79, 4
  br i1 %80, label %81, label %69

81:                                               ; preds = %69
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %6) #8
  call void @llvm.lifetime.end.p0(i64 128, ptr nonnull %5) #8
  %82 = icmp sgt i64 %3, 0
  br i1 %82, label %83, label %102

83:                                               ; preds = %81, %92
  %84 = phi i64 [ %93, %92 ], [ 0, %81 ]
  %85 = call fastcc i32 @look(ptr noundef %0, ptr noundef %1, ptr noundef nonnull %7)
  %86 = icmp eq i32 %85, 0
  br i1 %86, label %87, label %102

87:                                               ; preds = %83
  %88 = load i64, ptr %0, align 8
  %89 = icmp sgt i64 %88, 1
  br i1 %89, label %90, label %92

90:                                               ; preds = %87
  %91 = add i64 %88, -2
  br label %95

92:                                               ; preds = %95, %87
  %93 = add nuw nsw i64 %84, 1
  %94 = icmp eq i64 %93, %3
  br i1 %94, label %102, label %83

95:                                               ; preds = %90, %95
  %96 = phi i64 [ %100, %95 ], [ 0, %90 ]
  %97 = getelementptr inbounds double, ptr %1, i64 %96
  %98 = load double, ptr %97, align 8
  %99 = fmul double %98, %2
  store double %99, ptr %97, align 8
  %100 = add nuw nsw i64 %96, 1
  %101 = icmp eq i64 %96, %91
  br i1 %101, label %92, label %95

102:                                              ; preds = %83, %92, %81
  %103 = phi i64 [ -1, %81 ], [ -1, %92 ], [ %84, %83 ]
  call void @free(ptr noundef %57) #8
  br label %104

104:                                              ; preds = %59, %102
  %105 = phi i64 [ %103, %102 ], [ -2, %59 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %10) #8
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #8
  call void @llvm.lifetime.end.p0(i64 64, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 112, ptr nonnull %7) #8
  ret i64 %105
}

declare noalias noundef ptr @calloc(i64 noundef, i64 noundef) local_unnamed_addr #4

declare void @llvm.memcpy.p0.p0.i64(ptr noalias nocapture writeonly, ptr noalias nocapture readonly, i64, i1 immarg) #5

declare double @llvm.sqrt.f64(double) #6

declare double @llvm.log.f64(double) #6

declare double @llvm.fabs.f64(double) #6

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #7

attributes #0 = { nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #3 = { mustprogress nounwind willreturn allockind("free") memory(argmem: readwrite, inaccessiblemem: readwrite) "alloc-family"="malloc" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { mustprogress nofree nounwind willreturn allockind("alloc,zeroed") allocsize(0,1) memory(inaccessiblemem: readwrite) "alloc-family"="malloc" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #5 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #6 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #7 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #8 = { nounwind }
attributes #9 = { nounwind allocsize(0,1) }
attributes #10 = { memory(none) }


