; barrier.c b40ace7201ce06572f910c51ce4b0c2a7a0badddf6016459fc19961bc57d9b84: written by make kernel

%struct.State = type { ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, [2 x double], double, double }
%struct.Model = type { ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr }
%struct.Motion = type { i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, [2 x double], [2 x double], [2 x double], [2 x double] }
%struct.Descent = type { double, double, double, double, double, double, double, i64 }

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
  br label %768

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
  br i1 %83, label %766, label %84

84:                                               ; preds = %81
  %85 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 1
  %86 = load double, ptr %85, align 8
  %87 = load double, ptr %1, align 8
  %88 = fmul double %86, %87
  %89 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 11
  %90 = load double, ptr %89, align 8
  %91 = fdiv double %88, %90
  %92 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 3
  %93 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 5
  %94 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 4
  %95 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 12
  %96 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 7
  %97 = getelementptr inbounds ptr, ptr %4, i64 1
  %98 = getelementptr inbounds ptr, ptr %4, i64 2
  %99 = getelementptr inbounds ptr, ptr %4, i64 3
  %100 = getelementptr inbounds ptr, ptr %4, i64 4
  %101 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 5
  %102 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 9
  %103 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 10
  %104 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 14
  %105 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 12
  %106 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 13
  %107 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 6
  %108 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 16
  %109 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 16, i64 1
  %110 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 6
  %111 = getelementptr inbounds %struct.Descent, ptr %1, i64 0, i32 2
  br label %112

112:                                              ; preds = %762, %84
  %113 = phi double [ %90, %84 ], [ %763, %762 ]
  %114 = phi double [ %87, %84 ], [ %753, %762 ]
  %115 = phi i64 [ 0, %84 ], [ %752, %762 ]
  %116 = phi double [ %91, %84 ], [ %765, %762 ]
  %117 = fdiv double %114, %116
  %118 = load double, ptr %92, align 8
  %119 = fmul double %118, %113
  %120 = fcmp olt double %117, %119
  %121 = select i1 %120, ptr %93, ptr %94
  %122 = load double, ptr %121, align 8
  %123 = load ptr, ptr %9, align 8
  %124 = load ptr, ptr %10, align 8
  %125 = load i64, ptr %0, align 8
  %126 = add i64 %125, -1
  %127 = load i64, ptr %96, align 8
  %128 = icmp sgt i64 %127, 0
  br i1 %128, label %129, label %750

129:                                              ; preds = %112
  %130 = fmul double %116, %113
  %131 = load double, ptr %95, align 8
  %132 = fsub double %130, %131
  %133 = insertelement <8 x double> poison, double %116, i64 0
  %134 = shufflevector <8 x double> %133, <8 x double> poison, <8 x i32> zeroinitializer
  %135 = fmul double %116, -1.500000e+00
  %136 = fmul double %116, 2.250000e+00
  %137 = icmp sgt i64 %125, 1
  %138 = add i64 %125, -2
  %139 = icmp sgt i64 %125, 2
  %140 = icmp sgt i64 %125, 3
  %141 = add nsw i64 %125, -4
  %142 = shl i64 %126, 3
  br label %143

143:                                              ; preds = %747, %129
  %144 = phi i64 [ 0, %129 ], [ %746, %747 ]
  %145 = phi double [ %132, %129 ], [ %734, %747 ]
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %4)
  %146 = load i64, ptr %0, align 8
  %147 = load i64, ptr %45, align 8
  %148 = load ptr, ptr %8, align 8
  %149 = load ptr, ptr %23, align 8
  %150 = load ptr, ptr %25, align 8
  %151 = load ptr, ptr %27, align 8
  store ptr %149, ptr %97, align 8
  store ptr %150, ptr %98, align 8
  store ptr %151, ptr %99, align 8
  store ptr null, ptr %100, align 8
  %152 = icmp eq ptr %148, null
  br i1 %152, label %156, label %153

153:                                              ; preds = %143
  %154 = shl i64 %147, 3
  %155 = add i64 %154, 64
  br label %158

156:                                              ; preds = %158, %143
  %157 = icmp sgt i64 %147, 0
  br i1 %157, label %168, label %164

158:                                              ; preds = %158, %153
  %159 = phi ptr [ %148, %153 ], [ %162, %158 ]
  %160 = phi ptr [ %4, %153 ], [ %161, %158 ]
  call void @llvm.memset.p0.i64(ptr nonnull align 8 %159, i8 0, i64 %155, i1 false)
  %161 = getelementptr inbounds ptr, ptr %160, i64 1
  %162 = load ptr, ptr %161, align 8
  %163 = icmp eq ptr %162, null
  br i1 %163, label %156, label %158

164:                                              ; preds = %311, %156
  %165 = add nsw i64 %146, -1
  %166 = load ptr, ptr %107, align 8
  %167 = load ptr, ptr %12, align 8
  br label %429

168:                                              ; preds = %156, %311
  %169 = phi i64 [ %349, %311 ], [ 0, %156 ]
  %170 = load ptr, ptr %7, align 8
  %171 = getelementptr inbounds double, ptr %170, i64 %169
  %172 = load <8 x double>, ptr %171, align 8
  %173 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %172
  %174 = load ptr, ptr %20, align 8
  %175 = getelementptr inbounds double, ptr %174, i64 %169
  %176 = load <8 x double>, ptr %175, align 8
  %177 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %176
  %178 = fsub <8 x double> %177, %173
  %179 = fmul <8 x double> %173, %173
  %180 = fmul <8 x double> %177, %177
  %181 = fadd <8 x double> %179, %180
  %182 = load ptr, ptr %12, align 8
  %183 = getelementptr inbounds double, ptr %182, i64 %169
  %184 = load <8 x double>, ptr %183, align 8
  %185 = load ptr, ptr %101, align 8
  %186 = getelementptr inbounds double, ptr %185, i64 %169
  %187 = load <8 x double>, ptr %186, align 8
  %188 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %187
  %189 = load ptr, ptr %18, align 8
  %190 = getelementptr inbounds double, ptr %189, i64 %169
  %191 = load <8 x double>, ptr %190, align 8
  %192 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %191
  %193 = fmul <8 x double> %192, %192
  %194 = load ptr, ptr %16, align 8
  %195 = add nsw i64 %169, -1
  %196 = getelementptr inbounds double, ptr %194, i64 %195
  %197 = load <8 x double>, ptr %196, align 8
  %198 = getelementptr inbounds double, ptr %194, i64 %169
  %199 = load <8 x double>, ptr %198, align 8
  %200 = fadd <8 x double> %197, %199
  %201 = fmul <8 x double> %134, %200
  %202 = fmul <8 x double> %184, <double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00, double 4.000000e+00>
  %203 = fmul <8 x double> %184, %202
  %204 = fmul <8 x double> %184, %203
  %205 = fdiv <8 x double> %201, %204
  %206 = fsub <8 x double> %193, %205
  %207 = fmul <8 x double> %188, %192
  %208 = fmul <8 x double> %188, %206
  %209 = fmul <8 x double> %188, %208
  %210 = fmul <8 x double> %187, %206
  %211 = fmul <8 x double> %188, %210
  %212 = fmul <8 x double> %187, %192
  %213 = fadd <8 x double> %178, %212
  %214 = fmul <8 x double> %187, %210
  %215 = fadd <8 x double> %181, %214
  %216 = load i64, ptr %49, align 8
  %217 = icmp sgt i64 %216, 0
  br i1 %217, label %218, label %223

218:                                              ; preds = %168
  %219 = load ptr, ptr %38, align 8
  %220 = load ptr, ptr %40, align 8
  %221 = load ptr, ptr %102, align 8
  %222 = load ptr, ptr %103, align 8
  br label %274

223:                                              ; preds = %274, %168
  %224 = phi <8 x double> [ %211, %168 ], [ %305, %274 ]
  %225 = phi <8 x double> [ %209, %168 ], [ %308, %274 ]
  %226 = phi <8 x double> [ %207, %168 ], [ %300, %274 ]
  %227 = phi <8 x double> [ %215, %168 ], [ %303, %274 ]
  %228 = phi <8 x double> [ %213, %168 ], [ %298, %274 ]
  %229 = or i64 %169, 1
  %230 = getelementptr inbounds double, ptr %182, i64 %229
  %231 = load <8 x double>, ptr %230, align 8
  %232 = getelementptr inbounds double, ptr %185, i64 %229
  %233 = load <8 x double>, ptr %232, align 8
  %234 = fmul <8 x double> %184, <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %235 = fdiv <8 x double> %187, %234
  %236 = fdiv <8 x double> %188, %234
  %237 = fmul <8 x double> %231, <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %238 = fdiv <8 x double> %233, %237
  %239 = fadd <8 x double> %236, %238
  %240 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %233
  %241 = fdiv <8 x double> %240, %237
  %242 = fmul <8 x double> %134, %199
  %243 = fmul <8 x double> %242, <double -2.000000e+00, double -2.000000e+00, double -2.000000e+00, double -2.000000e+00, double -2.000000e+00, double -2.000000e+00, double -2.000000e+00, double -2.000000e+00>
  %244 = fadd <8 x double> %184, %231
  %245 = fdiv <8 x double> %243, %244
  %246 = fmul <8 x double> %235, %242
  %247 = fadd <8 x double> %246, %228
  %248 = fmul <8 x double> %242, %239
  %249 = fadd <8 x double> %226, %248
  %250 = fmul <8 x double> %235, %245
  %251 = fmul <8 x double> %235, %250
  %252 = fadd <8 x double> %227, %251
  %253 = fmul <8 x double> %250, %239
  %254 = fadd <8 x double> %224, %253
  %255 = fmul <8 x double> %245, %239
  %256 = fmul <8 x double> %239, %255
  %257 = fadd <8 x double> %225, %256
  %258 = fmul <8 x double> %242, %241
  %259 = fmul <8 x double> %250, %241
  %260 = fmul <8 x double> %241, %255
  %261 = fmul <8 x double> %245, %241
  %262 = fmul <8 x double> %241, %261
  %263 = fmul <8 x double> %235, %199
  %264 = fmul <8 x double> %199, %239
  %265 = fmul <8 x double> %199, %241
  %266 = load i64, ptr %51, align 8
  %267 = icmp sgt i64 %266, 0
  br i1 %267, label %268, label %311

268:                                              ; preds = %223
  %269 = load ptr, ptr %104, align 8
  %270 = load ptr, ptr %42, align 8
  %271 = load ptr, ptr %44, align 8
  %272 = load ptr, ptr %105, align 8
  %273 = load ptr, ptr %106, align 8
  br label %351

274:                                              ; preds = %274, %218
  %275 = phi <8 x double> [ %213, %218 ], [ %298, %274 ]
  %276 = phi <8 x double> [ %215, %218 ], [ %303, %274 ]
  %277 = phi <8 x double> [ %207, %218 ], [ %300, %274 ]
  %278 = phi <8 x double> [ %209, %218 ], [ %308, %274 ]
  %279 = phi <8 x double> [ %211, %218 ], [ %305, %274 ]
  %280 = phi i64 [ 0, %218 ], [ %309, %274 ]
  %281 = mul nsw i64 %280, %147
  %282 = add nsw i64 %281, %169
  %283 = getelementptr inbounds double, ptr %219, i64 %282
  %284 = load <8 x double>, ptr %283, align 8
  %285 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %284
  %286 = getelementptr inbounds double, ptr %220, i64 %282
  %287 = load <8 x double>, ptr %286, align 8
  %288 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %287
  %289 = getelementptr inbounds double, ptr %221, i64 %282
  %290 = load <8 x double>, ptr %289, align 8
  %291 = getelementptr inbounds double, ptr %222, i64 %282
  %292 = load <8 x double>, ptr %291, align 8
  %293 = fsub <8 x double> %285, %288
  %294 = fmul <8 x double> %285, %285
  %295 = fmul <8 x double> %288, %288
  %296 = fadd <8 x double> %294, %295
  %297 = fmul <8 x double> %290, %293
  %298 = fadd <8 x double> %275, %297
  %299 = fmul <8 x double> %293, %292
  %300 = fadd <8 x double> %277, %299
  %301 = fmul <8 x double> %290, %296
  %302 = fmul <8 x double> %290, %301
  %303 = fadd <8 x double> %276, %302
  %304 = fmul <8 x double> %292, %301
  %305 = fadd <8 x double> %279, %304
  %306 = fmul <8 x double> %292, %296
  %307 = fmul <8 x double> %292, %306
  %308 = fadd <8 x double> %278, %307
  %309 = add nuw nsw i64 %280, 1
  %310 = icmp eq i64 %309, %216
  br i1 %310, label %223, label %274

311:                                              ; preds = %351, %223
  %312 = phi <8 x double> [ %262, %223 ], [ %422, %351 ]
  %313 = phi <8 x double> [ %260, %223 ], [ %418, %351 ]
  %314 = phi <8 x double> [ %259, %223 ], [ %426, %351 ]
  %315 = phi <8 x double> [ %258, %223 ], [ %402, %351 ]
  %316 = phi <8 x double> [ %254, %223 ], [ %410, %351 ]
  %317 = phi <8 x double> [ %257, %223 ], [ %414, %351 ]
  %318 = phi <8 x double> [ %249, %223 ], [ %400, %351 ]
  %319 = phi <8 x double> [ %252, %223 ], [ %406, %351 ]
  %320 = phi <8 x double> [ %247, %223 ], [ %398, %351 ]
  %321 = getelementptr inbounds double, ptr %148, i64 %169
  %322 = load <8 x double>, ptr %321, align 8
  %323 = fadd <8 x double> %320, %322
  store <8 x double> %323, ptr %321, align 8
  %324 = getelementptr inbounds double, ptr %149, i64 %169
  %325 = load <8 x double>, ptr %324, align 8
  %326 = fadd <8 x double> %319, %325
  store <8 x double> %326, ptr %324, align 8
  %327 = getelementptr inbounds double, ptr %150, i64 %169
  %328 = load <8 x double>, ptr %327, align 8
  %329 = fadd <8 x double> %316, %328
  store <8 x double> %329, ptr %327, align 8
  %330 = getelementptr inbounds double, ptr %151, i64 %169
  %331 = load <8 x double>, ptr %330, align 8
  %332 = fadd <8 x double> %314, %331
  store <8 x double> %332, ptr %330, align 8
  %333 = getelementptr inbounds double, ptr %148, i64 %229
  %334 = load <8 x double>, ptr %333, align 8
  %335 = fadd <8 x double> %318, %334
  store <8 x double> %335, ptr %333, align 8
  %336 = getelementptr inbounds double, ptr %149, i64 %229
  %337 = load <8 x double>, ptr %336, align 8
  %338 = fadd <8 x double> %317, %337
  store <8 x double> %338, ptr %336, align 8
  %339 = getelementptr inbounds double, ptr %150, i64 %229
  %340 = load <8 x double>, ptr %339, align 8
  %341 = fadd <8 x double> %313, %340
  store <8 x double> %341, ptr %339, align 8
  %342 = or i64 %169, 2
  %343 = getelementptr inbounds double, ptr %148, i64 %342
  %344 = load <8 x double>, ptr %343, align 8
  %345 = fadd <8 x double> %315, %344
  store <8 x double> %345, ptr %343, align 8
  %346 = getelementptr inbounds double, ptr %149, i64 %342
  %347 = load <8 x double>, ptr %346, align 8
  %348 = fadd <8 x double> %312, %347
  store <8 x double> %348, ptr %346, align 8
  %349 = add nuw nsw i64 %169, 8
  %350 = icmp slt i64 %349, %147
  br i1 %350, label %168, label %164

351:                                              ; preds = %351, %268
  %352 = phi <8 x double> [ %247, %268 ], [ %398, %351 ]
  %353 = phi <8 x double> [ %252, %268 ], [ %406, %351 ]
  %354 = phi <8 x double> [ %249, %268 ], [ %400, %351 ]
  %355 = phi <8 x double> [ %257, %268 ], [ %414, %351 ]
  %356 = phi <8 x double> [ %254, %268 ], [ %410, %351 ]
  %357 = phi <8 x double> [ %258, %268 ], [ %402, %351 ]
  %358 = phi <8 x double> [ %259, %268 ], [ %426, %351 ]
  %359 = phi <8 x double> [ %260, %268 ], [ %418, %351 ]
  %360 = phi <8 x double> [ %262, %268 ], [ %422, %351 ]
  %361 = phi i64 [ 0, %268 ], [ %427, %351 ]
  %362 = mul nsw i64 %361, %147
  %363 = add nsw i64 %362, %169
  %364 = getelementptr inbounds double, ptr %269, i64 %363
  %365 = load <8 x double>, ptr %364, align 8
  %366 = getelementptr inbounds double, ptr %270, i64 %363
  %367 = load <8 x double>, ptr %366, align 8
  %368 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %367
  %369 = getelementptr inbounds double, ptr %271, i64 %363
  %370 = load <8 x double>, ptr %369, align 8
  %371 = fdiv <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %370
  %372 = getelementptr inbounds double, ptr %272, i64 %363
  %373 = load <8 x double>, ptr %372, align 8
  %374 = add nsw i64 %363, 1
  %375 = getelementptr inbounds double, ptr %272, i64 %374
  %376 = load <8 x double>, ptr %375, align 8
  %377 = getelementptr inbounds double, ptr %273, i64 %363
  %378 = load <8 x double>, ptr %377, align 8
  %379 = fsub <8 x double> %376, %378
  %380 = getelementptr inbounds double, ptr %273, i64 %374
  %381 = load <8 x double>, ptr %380, align 8
  %382 = fmul <8 x double> %263, %365
  %383 = fadd <8 x double> %382, %373
  %384 = fmul <8 x double> %368, %383
  %385 = fsub <8 x double> %382, %373
  %386 = fmul <8 x double> %371, %385
  %387 = fmul <8 x double> %264, %365
  %388 = fsub <8 x double> %387, %379
  %389 = fmul <8 x double> %368, %388
  %390 = fadd <8 x double> %387, %379
  %391 = fmul <8 x double> %371, %390
  %392 = fmul <8 x double> %265, %365
  %393 = fsub <8 x double> %392, %381
  %394 = fmul <8 x double> %368, %393
  %395 = fadd <8 x double> %392, %381
  %396 = fmul <8 x double> %371, %395
  %397 = fadd <8 x double> %384, %386
  %398 = fsub <8 x double> %352, %397
  %399 = fadd <8 x double> %389, %391
  %400 = fsub <8 x double> %354, %399
  %401 = fadd <8 x double> %394, %396
  %402 = fsub <8 x double> %357, %401
  %403 = fmul <8 x double> %384, %384
  %404 = fmul <8 x double> %386, %386
  %405 = fadd <8 x double> %403, %404
  %406 = fadd <8 x double> %353, %405
  %407 = fmul <8 x double> %384, %389
  %408 = fmul <8 x double> %386, %391
  %409 = fadd <8 x double> %407, %408
  %410 = fadd <8 x double> %356, %409
  %411 = fmul <8 x double> %389, %389
  %412 = fmul <8 x double> %391, %391
  %413 = fadd <8 x double> %411, %412
  %414 = fadd <8 x double> %355, %413
  %415 = fmul <8 x double> %389, %394
  %416 = fmul <8 x double> %391, %396
  %417 = fadd <8 x double> %415, %416
  %418 = fadd <8 x double> %359, %417
  %419 = fmul <8 x double> %394, %394
  %420 = fmul <8 x double> %396, %396
  %421 = fadd <8 x double> %419, %420
  %422 = fadd <8 x double> %360, %421
  %423 = fmul <8 x double> %384, %394
  %424 = fmul <8 x double> %386, %396
  %425 = fadd <8 x double> %423, %424
  %426 = fadd <8 x double> %358, %425
  %427 = add nuw nsw i64 %361, 1
  %428 = icmp eq i64 %427, %266
  br i1 %428, label %311, label %351

429:                                              ; preds = %478, %164
  %430 = phi i1 [ true, %164 ], [ false, %478 ]
  %431 = phi i64 [ 0, %164 ], [ 1, %478 ]
  %432 = select i1 %430, i64 0, i64 %165
  %433 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 15, i64 %431
  %434 = load double, ptr %433, align 8
  %435 = fcmp oeq double %434, 0.000000e+00
  br i1 %435, label %438, label %436

436:                                              ; preds = %429
  %437 = add nsw i64 %432, 1
  br label %478

438:                                              ; preds = %429
  %439 = getelementptr inbounds double, ptr %167, i64 %432
  %440 = load double, ptr %439, align 8
  %441 = fmul double %440, %440
  %442 = fmul double %440, %441
  %443 = load ptr, ptr %101, align 8
  %444 = getelementptr inbounds double, ptr %443, i64 %432
  %445 = load double, ptr %444, align 8
  %446 = fsub double 1.000000e+00, %445
  %447 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 17, i64 %431
  %448 = load double, ptr %447, align 8
  %449 = fmul double %135, %448
  %450 = fdiv double %449, %442
  %451 = fmul double %136, %448
  %452 = fmul double %440, %442
  %453 = fmul double %440, %452
  %454 = fdiv double %451, %453
  %455 = fmul double %445, %450
  %456 = getelementptr inbounds double, ptr %148, i64 %432
  %457 = load double, ptr %456, align 8
  %458 = fadd double %457, %455
  store double %458, ptr %456, align 8
  %459 = fmul double %446, %450
  %460 = add nsw i64 %432, 1
  %461 = getelementptr inbounds double, ptr %148, i64 %460
  %462 = load double, ptr %461, align 8
  %463 = fadd double %462, %459
  store double %463, ptr %461, align 8
  %464 = fmul double %445, %454
  %465 = fmul double %445, %464
  %466 = getelementptr inbounds double, ptr %149, i64 %432
  %467 = load double, ptr %466, align 8
  %468 = fadd double %465, %467
  store double %468, ptr %466, align 8
  %469 = fmul double %446, %464
  %470 = getelementptr inbounds double, ptr %150, i64 %432
  %471 = load double, ptr %470, align 8
  %472 = fadd double %469, %471
  store double %472, ptr %470, align 8
  %473 = fmul double %446, %454
  %474 = fmul double %446, %473
  %475 = getelementptr inbounds double, ptr %149, i64 %460
  %476 = load double, ptr %475, align 8
  %477 = fadd double %474, %476
  store double %477, ptr %475, align 8
  br label %478

478:                                              ; preds = %438, %436
  %479 = phi i64 [ %437, %436 ], [ %460, %438 ]
  %480 = getelementptr inbounds double, ptr %166, i64 %432
  %481 = load double, ptr %480, align 8
  %482 = getelementptr inbounds %struct.State, ptr %7, i64 0, i32 10, i64 %431
  %483 = load double, ptr %482, align 8
  %484 = fdiv double %481, %483
  %485 = fmul double %484, %484
  %486 = fneg double %484
  %487 = select i1 %430, double %486, double %484
  %488 = getelementptr inbounds double, ptr %148, i64 %432
  %489 = load double, ptr %488, align 8
  %490 = fadd double %489, %487
  store double %490, ptr %488, align 8
  %491 = select i1 %430, double %484, double %486
  %492 = getelementptr inbounds double, ptr %148, i64 %479
  %493 = load double, ptr %492, align 8
  %494 = fadd double %491, %493
  store double %494, ptr %492, align 8
  %495 = getelementptr inbounds double, ptr %149, i64 %432
  %496 = load double, ptr %495, align 8
  %497 = fadd double %485, %496
  store double %497, ptr %495, align 8
  %498 = getelementptr inbounds double, ptr %149, i64 %479
  %499 = load double, ptr %498, align 8
  %500 = fadd double %485, %499
  store double %500, ptr %498, align 8
  %501 = getelementptr inbounds double, ptr %150, i64 %432
  %502 = load double, ptr %501, align 8
  %503 = fsub double %502, %485
  store double %503, ptr %501, align 8
  br i1 %430, label %429, label %504

504:                                              ; preds = %478
  %505 = load double, ptr %108, align 8
  %506 = load double, ptr %109, align 8
  %507 = load double, ptr %148, align 8
  %508 = fmul double %505, %507
  %509 = getelementptr inbounds double, ptr %148, i64 1
  %510 = load double, ptr %509, align 8
  %511 = fadd double %510, %508
  store double %511, ptr %509, align 8
  %512 = fmul double %505, 2.000000e+00
  %513 = load double, ptr %150, align 8
  %514 = fmul double %512, %513
  %515 = fmul double %505, %505
  %516 = load double, ptr %149, align 8
  %517 = fmul double %515, %516
  %518 = fadd double %514, %517
  %519 = getelementptr inbounds double, ptr %149, i64 1
  %520 = load double, ptr %519, align 8
  %521 = fadd double %520, %518
  store double %521, ptr %519, align 8
  %522 = load double, ptr %151, align 8
  %523 = fmul double %505, %522
  %524 = getelementptr inbounds double, ptr %150, i64 1
  %525 = load double, ptr %524, align 8
  %526 = fadd double %525, %523
  store double %526, ptr %524, align 8
  %527 = getelementptr inbounds double, ptr %148, i64 %146
  %528 = load double, ptr %527, align 8
  %529 = fmul double %506, %528
  %530 = getelementptr inbounds double, ptr %148, i64 %165
  %531 = load double, ptr %530, align 8
  %532 = fadd double %531, %529
  store double %532, ptr %530, align 8
  %533 = fmul double %506, 2.000000e+00
  %534 = getelementptr inbounds double, ptr %150, i64 %165
  %535 = load double, ptr %534, align 8
  %536 = fmul double %533, %535
  %537 = fmul double %506, %506
  %538 = getelementptr inbounds double, ptr %149, i64 %146
  %539 = load double, ptr %538, align 8
  %540 = fmul double %537, %539
  %541 = fadd double %536, %540
  %542 = getelementptr inbounds double, ptr %149, i64 %165
  %543 = load double, ptr %542, align 8
  %544 = fadd double %543, %541
  store double %544, ptr %542, align 8
  %545 = add nsw i64 %146, -2
  %546 = getelementptr inbounds double, ptr %151, i64 %545
  %547 = load double, ptr %546, align 8
  %548 = fmul double %506, %547
  %549 = getelementptr inbounds double, ptr %150, i64 %545
  %550 = load double, ptr %549, align 8
  %551 = fadd double %550, %548
  store double %551, ptr %549, align 8
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %4)
  %552 = load ptr, ptr %8, align 8
  %553 = getelementptr inbounds double, ptr %552, i64 1
  %554 = load ptr, ptr %23, align 8
  %555 = getelementptr inbounds double, ptr %554, i64 1
  %556 = load ptr, ptr %25, align 8
  %557 = getelementptr inbounds double, ptr %556, i64 1
  %558 = load ptr, ptr %27, align 8
  %559 = getelementptr inbounds double, ptr %558, i64 1
  %560 = load ptr, ptr %29, align 8
  %561 = load ptr, ptr %31, align 8
  %562 = load ptr, ptr %33, align 8
  %563 = load ptr, ptr %35, align 8
  br i1 %137, label %565, label %706

564:                                              ; preds = %565
  br i1 %139, label %575, label %602

565:                                              ; preds = %504, %565
  %566 = phi i64 [ %572, %565 ], [ 0, %504 ]
  %567 = getelementptr inbounds double, ptr %555, i64 %566
  %568 = load double, ptr %567, align 8
  %569 = call double @llvm.sqrt.f64(double %568)
  %570 = fdiv double 1.000000e+00, %569
  %571 = getelementptr inbounds double, ptr %560, i64 %566
  store double %570, ptr %571, align 8
  %572 = add nuw nsw i64 %566, 1
  %573 = icmp eq i64 %572, %126
  br i1 %573, label %564, label %565

574:                                              ; preds = %575
  br i1 %140, label %588, label %602

575:                                              ; preds = %564, %575
  %576 = phi i64 [ %581, %575 ], [ 0, %564 ]
  %577 = getelementptr inbounds double, ptr %557, i64 %576
  %578 = load double, ptr %577, align 8
  %579 = getelementptr inbounds double, ptr %560, i64 %576
  %580 = load double, ptr %579, align 8
  %581 = add nuw nsw i64 %576, 1
  %582 = getelementptr inbounds double, ptr %560, i64 %581
  %583 = load double, ptr %582, align 8
  %584 = fmul double %580, %583
  %585 = fmul double %578, %584
  %586 = getelementptr inbounds double, ptr %561, i64 %581
  store double %585, ptr %586, align 8
  %587 = icmp eq i64 %581, %138
  br i1 %587, label %574, label %575

588:                                              ; preds = %574, %588
  %589 = phi i64 [ %600, %588 ], [ 0, %574 ]
  %590 = getelementptr inbounds double, ptr %559, i64 %589
  %591 = load double, ptr %590, align 8
  %592 = getelementptr inbounds double, ptr %560, i64 %589
  %593 = load double, ptr %592, align 8
  %594 = add nuw nsw i64 %589, 2
  %595 = getelementptr inbounds double, ptr %560, i64 %594
  %596 = load double, ptr %595, align 8
  %597 = fmul double %593, %596
  %598 = fmul double %591, %597
  %599 = getelementptr inbounds double, ptr %562, i64 %594
  store double %598, ptr %599, align 8
  %600 = add nuw nsw i64 %589, 1
  %601 = icmp eq i64 %589, %141
  br i1 %601, label %602, label %588

602:                                              ; preds = %588, %574, %564
  br label %603

603:                                              ; preds = %602, %652
  %604 = phi i64 [ %658, %652 ], [ 0, %602 ]
  %605 = getelementptr inbounds double, ptr %560, i64 %604
  %606 = load double, ptr %605, align 8
  %607 = getelementptr inbounds double, ptr %553, i64 %604
  %608 = load double, ptr %607, align 8
  %609 = fmul double %606, %608
  %610 = icmp ugt i64 %604, 1
  br i1 %610, label %611, label %631

611:                                              ; preds = %603
  %612 = getelementptr inbounds double, ptr %562, i64 %604
  %613 = load double, ptr %612, align 8
  %614 = add nsw i64 %604, -2
  %615 = getelementptr inbounds double, ptr %563, i64 %614
  %616 = load double, ptr %615, align 8
  %617 = fmul double %613, %616
  store double %617, ptr %612, align 8
  %618 = fmul double %613, %617
  %619 = fsub double 0x3FF000000000002D, %618
  %620 = getelementptr inbounds double, ptr %123, i64 %614
  %621 = load double, ptr %620, align 8
  %622 = fmul double %617, %621
  %623 = fsub double %609, %622
  %624 = add nsw i64 %604, -1
  %625 = getelementptr inbounds double, ptr %561, i64 %624
  %626 = load double, ptr %625, align 8
  %627 = fmul double %613, %626
  %628 = getelementptr inbounds double, ptr %561, i64 %604
  %629 = load double, ptr %628, align 8
  %630 = fsub double %629, %627
  store double %630, ptr %628, align 8
  br label %636

631:                                              ; preds = %603
  %632 = icmp eq i64 %604, 0
  br i1 %632, label %652, label %633

633:                                              ; preds = %631
  %634 = getelementptr inbounds double, ptr %561, i64 %604
  %635 = load double, ptr %634, align 8
  br label %636

636:                                              ; preds = %633, %611
  %637 = phi i64 [ 0, %633 ], [ %624, %611 ]
  %638 = phi double [ %635, %633 ], [ %630, %611 ]
  %639 = phi double [ %609, %633 ], [ %623, %611 ]
  %640 = phi double [ 0x3FF000000000002D, %633 ], [ %619, %611 ]
  %641 = getelementptr inbounds double, ptr %561, i64 %604
  %642 = getelementptr inbounds double, ptr %563, i64 %637
  %643 = load double, ptr %642, align 8
  %644 = fmul double %638, %643
  store double %644, ptr %641, align 8
  %645 = fmul double %638, %644
  %646 = fsub double %640, %645
  %647 = getelementptr inbounds double, ptr %123, i64 %637
  %648 = load double, ptr %647, align 8
  %649 = fmul double %644, %648
  %650 = fsub double %639, %649
  %651 = fcmp ogt double %646, 0.000000e+00
  br i1 %651, label %652, label %706

652:                                              ; preds = %636, %631
  %653 = phi double [ %650, %636 ], [ %609, %631 ]
  %654 = phi double [ %646, %636 ], [ 0x3FF000000000002D, %631 ]
  %655 = fdiv double 1.000000e+00, %654
  %656 = getelementptr inbounds double, ptr %563, i64 %604
  store double %655, ptr %656, align 8
  %657 = getelementptr inbounds double, ptr %123, i64 %604
  store double %653, ptr %657, align 8
  %658 = add nuw nsw i64 %604, 1
  %659 = icmp eq i64 %658, %126
  br i1 %659, label %660, label %603

660:                                              ; preds = %652, %687
  %661 = phi i64 [ %689, %687 ], [ %138, %652 ]
  %662 = getelementptr inbounds double, ptr %123, i64 %661
  %663 = load double, ptr %662, align 8
  %664 = getelementptr inbounds double, ptr %563, i64 %661
  %665 = load double, ptr %664, align 8
  %666 = fmul double %663, %665
  %667 = add nuw nsw i64 %661, 1
  %668 = icmp slt i64 %667, %126
  br i1 %668, label %669, label %676

669:                                              ; preds = %660
  %670 = getelementptr inbounds double, ptr %561, i64 %667
  %671 = load double, ptr %670, align 8
  %672 = getelementptr inbounds double, ptr %123, i64 %667
  %673 = load double, ptr %672, align 8
  %674 = fmul double %671, %673
  %675 = fsub double %666, %674
  br label %676

676:                                              ; preds = %669, %660
  %677 = phi double [ %675, %669 ], [ %666, %660 ]
  %678 = add nuw nsw i64 %661, 2
  %679 = icmp slt i64 %678, %126
  br i1 %679, label %680, label %687

680:                                              ; preds = %676
  %681 = getelementptr inbounds double, ptr %562, i64 %678
  %682 = load double, ptr %681, align 8
  %683 = getelementptr inbounds double, ptr %123, i64 %678
  %684 = load double, ptr %683, align 8
  %685 = fmul double %682, %684
  %686 = fsub double %677, %685
  br label %687

687:                                              ; preds = %680, %676
  %688 = phi double [ %686, %680 ], [ %677, %676 ]
  store double %688, ptr %662, align 8
  %689 = add nsw i64 %661, -1
  %690 = icmp sgt i64 %661, 0
  br i1 %690, label %660, label %691

691:                                              ; preds = %687, %691
  %692 = phi i64 [ %704, %691 ], [ 0, %687 ]
  %693 = phi double [ %703, %691 ], [ 0.000000e+00, %687 ]
  %694 = getelementptr inbounds double, ptr %560, i64 %692
  %695 = load double, ptr %694, align 8
  %696 = fneg double %695
  %697 = getelementptr inbounds double, ptr %123, i64 %692
  %698 = load double, ptr %697, align 8
  %699 = fmul double %698, %696
  store double %699, ptr %697, align 8
  %700 = getelementptr inbounds double, ptr %553, i64 %692
  %701 = load double, ptr %700, align 8
  %702 = fmul double %699, %701
  %703 = fsub double %693, %702
  %704 = add nuw nsw i64 %692, 1
  %705 = icmp eq i64 %704, %126
  br i1 %705, label %706, label %691

706:                                              ; preds = %636, %691, %504
  %707 = phi double [ 0.000000e+00, %504 ], [ %703, %691 ], [ 0x7FF8000000000000, %636 ]
  %708 = call double @llvm.fabs.f64(double %707) #10
  %709 = fcmp ueq double %708, 0x7FF0000000000000
  %710 = fcmp olt double %707, %122
  %711 = select i1 %709, i1 true, i1 %710
  br i1 %711, label %750, label %712

712:                                              ; preds = %706, %740
  %713 = phi double [ %741, %740 ], [ 1.000000e+00, %706 ]
  br i1 %137, label %719, label %716

714:                                              ; preds = %740
  %715 = call fastcc i32 @look(ptr noundef nonnull %0, ptr noundef %2, ptr noundef nonnull %7)
  br label %750

716:                                              ; preds = %719, %712
  %717 = call fastcc i32 @look(ptr noundef nonnull %0, ptr noundef %124, ptr noundef nonnull %7)
  %718 = icmp eq i32 %717, 0
  br i1 %718, label %740, label %730

719:                                              ; preds = %712, %719
  %720 = phi i64 [ %728, %719 ], [ 0, %712 ]
  %721 = getelementptr inbounds double, ptr %2, i64 %720
  %722 = load double, ptr %721, align 8
  %723 = getelementptr inbounds double, ptr %123, i64 %720
  %724 = load double, ptr %723, align 8
  %725 = fmul double %713, %724
  %726 = fadd double %722, %725
  %727 = getelementptr inbounds double, ptr %124, i64 %720
  store double %726, ptr %727, align 8
  %728 = add nuw nsw i64 %720, 1
  %729 = icmp eq i64 %728, %126
  br i1 %729, label %716, label %719

730:                                              ; preds = %716
  %731 = load double, ptr %89, align 8
  %732 = fmul double %116, %731
  %733 = load double, ptr %95, align 8
  %734 = fsub double %732, %733
  %735 = load double, ptr %110, align 8
  %736 = fmul double %713, %735
  %737 = fmul double %707, %736
  %738 = fsub double %145, %737
  %739 = fcmp ugt double %734, %738
  br i1 %739, label %740, label %743

740:                                              ; preds = %730, %716
  %741 = fmul double %713, 5.000000e-01
  %742 = fcmp ugt double %741, 1.000000e-09
  br i1 %742, label %712, label %714

743:                                              ; preds = %730
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %2, ptr align 8 %124, i64 %142, i1 false)
  %744 = fsub double %145, %734
  %745 = fcmp olt double %744, %122
  %746 = add nuw nsw i64 %144, 1
  br i1 %745, label %750, label %747

747:                                              ; preds = %743
  %748 = load i64, ptr %96, align 8
  %749 = icmp slt i64 %746, %748
  br i1 %749, label %143, label %750

750:                                              ; preds = %706, %747, %743, %112, %714
  %751 = phi i64 [ %144, %714 ], [ 0, %112 ], [ %144, %706 ], [ %746, %747 ], [ %746, %743 ]
  %752 = add nsw i64 %751, %115
  %753 = load double, ptr %1, align 8
  br i1 %120, label %756, label %754

754:                                              ; preds = %750
  %755 = load double, ptr %89, align 8
  br label %762

756:                                              ; preds = %750
  %757 = fdiv double %753, %116
  %758 = load double, ptr %92, align 8
  %759 = load double, ptr %89, align 8
  %760 = fmul double %758, %759
  %761 = fcmp olt double %757, %760
  br i1 %761, label %766, label %762

762:                                              ; preds = %754, %756
  %763 = phi double [ %755, %754 ], [ %759, %756 ]
  %764 = load double, ptr %111, align 8
  %765 = fmul double %116, %764
  br label %112

766:                                              ; preds = %756, %81
  %767 = phi i64 [ -1, %81 ], [ %752, %756 ]
  call void @free(ptr noundef %57) #8
  br label %768

768:                                              ; preds = %59, %766
  %769 = phi i64 [ %767, %766 ], [ -2, %59 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %10) #8
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #8
  call void @llvm.lifetime.end.p0(i64 64, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 112, ptr nonnull %7) #8
  ret i64 %769
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


