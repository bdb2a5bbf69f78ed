; barrier.c d362fcb24d1cfa017be5738b6e911accd60f409e5a5bf50ecbf287b3f29e6f93: written by make kernel

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
  br i1 %39, label %29, label %464

40:                                               ; preds = %47, %32
  %41 = icmp sgt i64 %6, 0
  br i1 %41, label %42, label %52

42:                                               ; preds = %40
  %43 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 5
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 1
  %46 = load ptr, ptr %45, align 8
  br label %78

47:                                               ; preds = %32, %47
  %48 = phi i64 [ %49, %47 ], [ %4, %32 ]
  %49 = add nsw i64 %48, 1
  %50 = getelementptr inbounds double, ptr %7, i64 %49
  store double 1.000000e+00, ptr %50, align 8
  %51 = icmp eq i64 %49, %33
  br i1 %51, label %40, label %47

52:                                               ; preds = %78, %40
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
  br i1 %77, label %119, label %464

78:                                               ; preds = %42, %78
  %79 = phi i64 [ 0, %42 ], [ %86, %78 ]
  %80 = getelementptr inbounds double, ptr %44, i64 %79
  %81 = load double, ptr %80, align 8
  %82 = getelementptr inbounds double, ptr %7, i64 %79
  %83 = load double, ptr %82, align 8
  %84 = fmul double %81, %83
  %85 = fsub double 1.000000e+00, %81
  %86 = add nuw nsw i64 %79, 1
  %87 = getelementptr inbounds double, ptr %7, i64 %86
  %88 = load double, ptr %87, align 8
  %89 = fmul double %85, %88
  %90 = fadd double %84, %89
  %91 = tail call double @llvm.sqrt.f64(double %90)
  %92 = getelementptr inbounds double, ptr %46, i64 %79
  store double %91, ptr %92, align 8
  %93 = icmp eq i64 %86, %6
  br i1 %93, label %52, label %78

94:                                               ; preds = %119
  br i1 %41, label %95, label %396

95:                                               ; preds = %94
  %96 = insertelement <8 x i64> poison, i64 %9, i64 0
  %97 = shufflevector <8 x i64> %96, <8 x i64> poison, <8 x i32> zeroinitializer
  %98 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 7
  %99 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 5
  %100 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 8
  %101 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 4
  %102 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 5
  %103 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 1
  %104 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 9
  %105 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 10
  %106 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 11
  %107 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 6
  %108 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 7
  %109 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 1
  %110 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 4
  %111 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 2
  %112 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 3
  %113 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 2
  %114 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 12
  %115 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 13
  %116 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 14
  %117 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 8
  %118 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 9
  br label %129

119:                                              ; preds = %52, %119
  %120 = phi i1 [ false, %119 ], [ true, %52 ]
  %121 = phi i64 [ 1, %119 ], [ 0, %52 ]
  %122 = phi <8 x double> [ %128, %119 ], [ <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %52 ]
  %123 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 10, i64 %121
  %124 = load double, ptr %123, align 8
  %125 = fcmp olt double %124, 0x7FF0000000000000
  %126 = trunc i64 %121 to i32
  %127 = insertelement <8 x double> %122, double %124, i32 %126
  %128 = select i1 %125, <8 x double> %127, <8 x double> %122
  br i1 %120, label %119, label %94

129:                                              ; preds = %95, %390
  %130 = phi <8 x i64> [ zeroinitializer, %95 ], [ %393, %390 ]
  %131 = phi i64 [ 0, %95 ], [ %394, %390 ]
  %132 = phi <8 x double> [ zeroinitializer, %95 ], [ %287, %390 ]
  %133 = phi <8 x double> [ zeroinitializer, %95 ], [ %392, %390 ]
  %134 = insertelement <8 x i64> poison, i64 %131, i64 0
  %135 = shufflevector <8 x i64> %134, <8 x i64> poison, <8 x i32> zeroinitializer
  %136 = or <8 x i64> %135, <i64 0, i64 1, i64 2, i64 3, i64 4, i64 5, i64 6, i64 7>
  %137 = icmp slt <8 x i64> %136, %97
  %138 = sext <8 x i1> %137 to <8 x i64>
  %139 = getelementptr inbounds double, ptr %7, i64 %131
  %140 = load <8 x double>, ptr %139, align 8
  %141 = or i64 %131, 1
  %142 = getelementptr inbounds double, ptr %7, i64 %141
  %143 = load <8 x double>, ptr %142, align 8
  %144 = or i64 %131, 2
  %145 = getelementptr inbounds double, ptr %7, i64 %144
  %146 = load <8 x double>, ptr %145, align 8
  %147 = load ptr, ptr %98, align 8
  %148 = getelementptr inbounds double, ptr %147, i64 %131
  %149 = load <8 x double>, ptr %148, align 8
  %150 = load ptr, ptr %99, align 8
  %151 = getelementptr inbounds double, ptr %150, i64 %131
  %152 = load <8 x double>, ptr %151, align 8
  %153 = fmul <8 x double> %140, %152
  %154 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %152
  %155 = fmul <8 x double> %143, %154
  %156 = fadd <8 x double> %153, %155
  %157 = fsub <8 x double> %149, %156
  %158 = load ptr, ptr %100, align 8
  %159 = getelementptr inbounds double, ptr %158, i64 %131
  %160 = load <8 x double>, ptr %159, align 8
  %161 = fsub <8 x double> %160, %140
  %162 = load ptr, ptr %101, align 8
  %163 = getelementptr inbounds double, ptr %162, i64 %131
  store <8 x double> %157, ptr %163, align 8
  %164 = load ptr, ptr %102, align 8
  %165 = getelementptr inbounds double, ptr %164, i64 %131
  store <8 x double> %161, ptr %165, align 8
  %166 = fcmp une <8 x double> %157, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %167 = select <8 x i1> %166, <8 x double> %157, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %168 = fcmp une <8 x double> %161, <double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000, double 0x7FF0000000000000>
  %169 = select <8 x i1> %168, <8 x double> %161, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %170 = fmul <8 x double> %169, %167
  %171 = fcmp ogt <8 x double> %167, zeroinitializer
  %172 = fcmp ogt <8 x double> %169, zeroinitializer
  %173 = and <8 x i1> %171, %172
  %174 = fcmp ogt <8 x double> %170, <double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000>
  %175 = and <8 x i1> %173, %174
  %176 = fcmp olt <8 x double> %170, <double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000>
  %177 = and <8 x i1> %175, %176
  %178 = bitcast <8 x double> %170 to <8 x i64>
  %179 = ashr <8 x i64> %178, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %180 = and <8 x i64> %178, <i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495>
  %181 = or <8 x i64> %180, <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>
  %182 = icmp eq i64 %131, 0
  %183 = bitcast <8 x i64> %181 to <8 x double>
  %184 = select i1 %182, <8 x double> %128, <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %185 = fmul <8 x double> %184, %140
  %186 = fmul <8 x double> %185, %183
  %187 = fcmp ogt <8 x double> %140, zeroinitializer
  %188 = fcmp ogt <8 x double> %184, zeroinitializer
  %189 = and <8 x i1> %187, %188
  %190 = fcmp ogt <8 x double> %186, <double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000>
  %191 = and <8 x i1> %189, %190
  %192 = fcmp olt <8 x double> %186, <double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000>
  %193 = and <8 x i1> %191, %192
  %194 = select <8 x i1> %193, <8 x i1> %177, <8 x i1> zeroinitializer
  %195 = xor <8 x i1> %194, <i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true, i1 true>
  %196 = sext <8 x i1> %195 to <8 x i64>
  %197 = bitcast <8 x double> %186 to <8 x i64>
  %198 = ashr <8 x i64> %197, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %199 = add nsw <8 x i64> %179, <i64 -2046, i64 -2046, i64 -2046, i64 -2046, i64 -2046, i64 -2046, i64 -2046, i64 -2046>
  %200 = add nsw <8 x i64> %199, %198
  %201 = and <8 x i64> %197, <i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495>
  %202 = or <8 x i64> %201, <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>
  %203 = load i64, ptr %103, align 8
  %204 = icmp sgt i64 %203, 0
  br i1 %204, label %218, label %205

205:                                              ; preds = %218, %129
  %206 = phi <8 x i64> [ %200, %129 ], [ %258, %218 ]
  %207 = phi <8 x i64> [ %196, %129 ], [ %254, %218 ]
  %208 = phi <8 x i64> [ %202, %129 ], [ %261, %218 ]
  br label %209

209:                                              ; preds = %205, %209
  %210 = phi i32 [ %214, %209 ], [ 0, %205 ]
  %211 = phi i64 [ %213, %209 ], [ 0, %205 ]
  %212 = extractelement <8 x i64> %207, i32 %210
  %213 = or i64 %212, %211
  %214 = add nuw nsw i32 %210, 1
  %215 = icmp eq i32 %214, 8
  br i1 %215, label %216, label %209

216:                                              ; preds = %209
  %217 = icmp eq i64 %213, 0
  br i1 %217, label %264, label %464

218:                                              ; preds = %129, %218
  %219 = phi <8 x i64> [ %261, %218 ], [ %202, %129 ]
  %220 = phi i64 [ %259, %218 ], [ 0, %129 ]
  %221 = phi <8 x i64> [ %254, %218 ], [ %196, %129 ]
  %222 = phi <8 x i64> [ %258, %218 ], [ %200, %129 ]
  %223 = mul nsw i64 %220, %6
  %224 = add nsw i64 %223, %131
  %225 = load ptr, ptr %104, align 8
  %226 = getelementptr inbounds double, ptr %225, i64 %224
  %227 = load <8 x double>, ptr %226, align 8
  %228 = fmul <8 x double> %140, %227
  %229 = load ptr, ptr %105, align 8
  %230 = getelementptr inbounds double, ptr %229, i64 %224
  %231 = load <8 x double>, ptr %230, align 8
  %232 = fmul <8 x double> %143, %231
  %233 = fadd <8 x double> %228, %232
  %234 = load ptr, ptr %106, align 8
  %235 = getelementptr inbounds double, ptr %234, i64 %224
  %236 = load <8 x double>, ptr %235, align 8
  %237 = fadd <8 x double> %233, %236
  %238 = fsub <8 x double> <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>, %237
  %239 = fadd <8 x double> %237, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %240 = load ptr, ptr %107, align 8
  %241 = getelementptr inbounds double, ptr %240, i64 %224
  store <8 x double> %238, ptr %241, align 8
  %242 = load ptr, ptr %108, align 8
  %243 = getelementptr inbounds double, ptr %242, i64 %224
  store <8 x double> %239, ptr %243, align 8
  %244 = bitcast <8 x i64> %219 to <8 x double>
  %245 = fmul <8 x double> %238, %239
  %246 = fmul <8 x double> %245, %244
  %247 = fcmp ogt <8 x double> %238, zeroinitializer
  %248 = fcmp ogt <8 x double> %239, zeroinitializer
  %249 = and <8 x i1> %248, %247
  %250 = fcmp ogt <8 x double> %246, <double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000>
  %251 = and <8 x i1> %249, %250
  %252 = fcmp olt <8 x double> %246, <double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000>
  %253 = and <8 x i1> %251, %252
  %254 = select <8 x i1> %253, <8 x i64> %221, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %255 = bitcast <8 x double> %246 to <8 x i64>
  %256 = ashr <8 x i64> %255, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %257 = add <8 x i64> %222, <i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023>
  %258 = add <8 x i64> %257, %256
  %259 = add nuw nsw i64 %220, 1
  %260 = and <8 x i64> %255, <i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495>
  %261 = or <8 x i64> %260, <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>
  %262 = load i64, ptr %103, align 8
  %263 = icmp slt i64 %259, %262
  br i1 %263, label %218, label %205

264:                                              ; preds = %216
  %265 = load ptr, ptr %109, align 8
  %266 = getelementptr inbounds double, ptr %265, i64 %131
  %267 = load <8 x double>, ptr %266, align 8
  %268 = getelementptr inbounds double, ptr %265, i64 %141
  %269 = load <8 x double>, ptr %268, align 8
  %270 = fadd <8 x double> %267, %269
  %271 = load ptr, ptr %110, align 8
  %272 = getelementptr inbounds double, ptr %271, i64 %131
  %273 = load <8 x double>, ptr %272, align 8
  %274 = fmul <8 x double> %273, <double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00, double 2.000000e+00>
  %275 = fdiv <8 x double> %274, %270
  %276 = load ptr, ptr %111, align 8
  %277 = getelementptr inbounds double, ptr %276, i64 %131
  store <8 x double> %275, ptr %277, align 8
  %278 = fneg <8 x double> %275
  %279 = fdiv <8 x double> %278, %270
  %280 = bitcast <8 x double> %279 to <8 x i64>
  %281 = and <8 x i64> %280, %138
  %282 = load ptr, ptr %112, align 8
  %283 = getelementptr inbounds double, ptr %282, i64 %131
  store <8 x i64> %281, ptr %283, align 8
  %284 = bitcast <8 x double> %275 to <8 x i64>
  %285 = and <8 x i64> %284, %138
  %286 = bitcast <8 x i64> %285 to <8 x double>
  %287 = fadd <8 x double> %132, %286
  %288 = load i64, ptr %113, align 8
  %289 = icmp sgt i64 %288, 0
  br i1 %289, label %290, label %293

290:                                              ; preds = %264
  %291 = select <8 x i1> %137, <8 x i64> zeroinitializer, <8 x i64> <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>
  %292 = select <8 x i1> %137, <8 x i64> zeroinitializer, <8 x i64> <i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312, i64 9218868437227405312>
  br label %306

293:                                              ; preds = %306, %264
  %294 = phi <8 x i64> [ %208, %264 ], [ %369, %306 ]
  %295 = phi <8 x i64> [ %206, %264 ], [ %367, %306 ]
  %296 = phi <8 x i64> [ %207, %264 ], [ %363, %306 ]
  br label %297

297:                                              ; preds = %293, %297
  %298 = phi i32 [ %302, %297 ], [ 0, %293 ]
  %299 = phi i64 [ %301, %297 ], [ 0, %293 ]
  %300 = extractelement <8 x i64> %296, i32 %298
  %301 = or i64 %300, %299
  %302 = add nuw nsw i32 %298, 1
  %303 = icmp eq i32 %302, 8
  br i1 %303, label %304, label %297

304:                                              ; preds = %297
  %305 = icmp eq i64 %301, 0
  br i1 %305, label %373, label %464

306:                                              ; preds = %290, %306
  %307 = phi i64 [ 0, %290 ], [ %370, %306 ]
  %308 = phi <8 x i64> [ %207, %290 ], [ %363, %306 ]
  %309 = phi <8 x i64> [ %206, %290 ], [ %367, %306 ]
  %310 = phi <8 x i64> [ %208, %290 ], [ %369, %306 ]
  %311 = mul nsw i64 %307, %6
  %312 = add nsw i64 %311, %131
  %313 = load ptr, ptr %114, align 8
  %314 = add nsw i64 %312, 1
  %315 = getelementptr inbounds double, ptr %313, i64 %314
  %316 = load <8 x double>, ptr %315, align 8
  %317 = fmul <8 x double> %143, %316
  %318 = load ptr, ptr %115, align 8
  %319 = getelementptr inbounds double, ptr %318, i64 %314
  %320 = load <8 x double>, ptr %319, align 8
  %321 = fmul <8 x double> %146, %320
  %322 = fadd <8 x double> %317, %321
  %323 = getelementptr inbounds double, ptr %313, i64 %312
  %324 = load <8 x double>, ptr %323, align 8
  %325 = fmul <8 x double> %140, %324
  %326 = getelementptr inbounds double, ptr %318, i64 %312
  %327 = load <8 x double>, ptr %326, align 8
  %328 = fmul <8 x double> %143, %327
  %329 = fadd <8 x double> %325, %328
  %330 = fsub <8 x double> %322, %329
  %331 = load ptr, ptr %116, align 8
  %332 = getelementptr inbounds double, ptr %331, i64 %312
  %333 = load <8 x double>, ptr %332, align 8
  %334 = fmul <8 x double> %275, %333
  %335 = fsub <8 x double> %334, %330
  %336 = bitcast <8 x double> %335 to <8 x i64>
  %337 = and <8 x i64> %336, %138
  %338 = or <8 x i64> %337, %291
  %339 = fadd <8 x double> %334, %330
  %340 = bitcast <8 x double> %339 to <8 x i64>
  %341 = and <8 x i64> %340, %138
  %342 = or <8 x i64> %341, %291
  %343 = and <8 x i64> %338, %138
  %344 = or <8 x i64> %343, %292
  %345 = load ptr, ptr %117, align 8
  %346 = getelementptr inbounds double, ptr %345, i64 %312
  store <8 x i64> %344, ptr %346, align 8
  %347 = and <8 x i64> %342, %138
  %348 = or <8 x i64> %347, %292
  %349 = load ptr, ptr %118, align 8
  %350 = getelementptr inbounds double, ptr %349, i64 %312
  store <8 x i64> %348, ptr %350, align 8
  %351 = bitcast <8 x i64> %310 to <8 x double>
  %352 = bitcast <8 x i64> %338 to <8 x double>
  %353 = bitcast <8 x i64> %342 to <8 x double>
  %354 = fmul <8 x double> %352, %353
  %355 = fmul <8 x double> %354, %351
  %356 = fcmp ogt <8 x double> %352, zeroinitializer
  %357 = fcmp ogt <8 x double> %353, zeroinitializer
  %358 = and <8 x i1> %357, %356
  %359 = fcmp ogt <8 x double> %355, <double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000, double 0x170000000000000>
  %360 = and <8 x i1> %358, %359
  %361 = fcmp olt <8 x double> %355, <double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000, double 0x7E70000000000000>
  %362 = and <8 x i1> %360, %361
  %363 = select <8 x i1> %362, <8 x i64> %308, <8 x i64> <i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1, i64 -1>
  %364 = bitcast <8 x double> %355 to <8 x i64>
  %365 = ashr <8 x i64> %364, <i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52, i64 52>
  %366 = add <8 x i64> %309, <i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023, i64 -1023>
  %367 = add <8 x i64> %366, %365
  %368 = and <8 x i64> %364, <i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495, i64 4503599627370495>
  %369 = or <8 x i64> %368, <i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408, i64 4607182418800017408>
  %370 = add nuw nsw i64 %307, 1
  %371 = load i64, ptr %113, align 8
  %372 = icmp slt i64 %370, %371
  br i1 %372, label %306, label %293

373:                                              ; preds = %304
  %374 = bitcast <8 x i64> %294 to <8 x double>
  %375 = fadd <8 x double> %374, <double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00, double -1.000000e+00>
  %376 = fadd <8 x double> %374, <double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00, double 1.000000e+00>
  %377 = fdiv <8 x double> %375, %376
  %378 = fmul <8 x double> %377, %377
  br label %379

379:                                              ; preds = %373, %379
  %380 = phi i64 [ 0, %373 ], [ %388, %379 ]
  %381 = phi <8 x double> [ zeroinitializer, %373 ], [ %387, %379 ]
  %382 = fmul <8 x double> %378, %381
  %383 = getelementptr inbounds [18 x double], ptr @ODD, i64 0, i64 %380
  %384 = load double, ptr %383, align 8
  %385 = insertelement <8 x double> poison, double %384, i64 0
  %386 = shufflevector <8 x double> %385, <8 x double> poison, <8 x i32> zeroinitializer
  %387 = fadd <8 x double> %382, %386
  %388 = add nuw nsw i64 %380, 1
  %389 = icmp eq i64 %388, 18
  br i1 %389, label %390, label %379

390:                                              ; preds = %379
  %391 = fmul <8 x double> %377, %387
  %392 = fadd <8 x double> %133, %391
  %393 = add <8 x i64> %295, %130
  %394 = add nuw nsw i64 %131, 8
  %395 = icmp slt i64 %394, %6
  br i1 %395, label %129, label %396

396:                                              ; preds = %390, %94
  %397 = phi <8 x double> [ zeroinitializer, %94 ], [ %392, %390 ]
  %398 = phi <8 x i64> [ zeroinitializer, %94 ], [ %393, %390 ]
  %399 = phi <8 x double> [ zeroinitializer, %94 ], [ %287, %390 ]
  br label %438

400:                                              ; preds = %438
  %401 = sitofp i64 %442 to double
  %402 = fmul double %401, 0x3FE62E42FEFA39EF
  %403 = extractelement <8 x double> %397, i64 0
  %404 = extractelement <8 x double> %397, i64 1
  %405 = fadd double %403, %404
  %406 = extractelement <8 x double> %397, i64 2
  %407 = extractelement <8 x double> %397, i64 3
  %408 = fadd double %406, %407
  %409 = fadd double %405, %408
  %410 = extractelement <8 x double> %397, i64 4
  %411 = extractelement <8 x double> %397, i64 5
  %412 = fadd double %410, %411
  %413 = extractelement <8 x double> %397, i64 6
  %414 = extractelement <8 x double> %397, i64 7
  %415 = fadd double %413, %414
  %416 = fadd double %412, %415
  %417 = fadd double %409, %416
  %418 = fmul double %417, 2.000000e+00
  %419 = fadd double %418, %402
  %420 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 12
  store double %419, ptr %420, align 8
  %421 = extractelement <8 x double> %399, i64 0
  %422 = extractelement <8 x double> %399, i64 1
  %423 = fadd double %421, %422
  %424 = extractelement <8 x double> %399, i64 2
  %425 = extractelement <8 x double> %399, i64 3
  %426 = fadd double %424, %425
  %427 = fadd double %423, %426
  %428 = extractelement <8 x double> %399, i64 4
  %429 = extractelement <8 x double> %399, i64 5
  %430 = fadd double %428, %429
  %431 = extractelement <8 x double> %399, i64 6
  %432 = extractelement <8 x double> %399, i64 7
  %433 = fadd double %431, %432
  %434 = fadd double %430, %433
  %435 = fadd double %427, %434
  %436 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 11
  store double %435, ptr %436, align 8
  %437 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 1
  br label %445

438:                                              ; preds = %396, %438
  %439 = phi i32 [ %443, %438 ], [ 0, %396 ]
  %440 = phi i64 [ %442, %438 ], [ 0, %396 ]
  %441 = extractelement <8 x i64> %398, i32 %439
  %442 = add nsw i64 %441, %440
  %443 = add nuw nsw i32 %439, 1
  %444 = icmp eq i32 %443, 8
  br i1 %444, label %400, label %438

445:                                              ; preds = %400, %462
  %446 = phi double [ %435, %400 ], [ %463, %462 ]
  %447 = phi i1 [ true, %400 ], [ false, %462 ]
  %448 = phi i64 [ 0, %400 ], [ 1, %462 ]
  %449 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 15, i64 %448
  %450 = load double, ptr %449, align 8
  %451 = fcmp oeq double %450, 0.000000e+00
  br i1 %451, label %452, label %462

452:                                              ; preds = %445
  %453 = getelementptr inbounds %struct.Motion, ptr %0, i64 0, i32 17, i64 %448
  %454 = load double, ptr %453, align 8
  %455 = fmul double %454, 3.000000e+00
  %456 = load ptr, ptr %437, align 8
  %457 = select i1 %447, i64 0, i64 %9
  %458 = getelementptr inbounds double, ptr %456, i64 %457
  %459 = load double, ptr %458, align 8
  %460 = fdiv double %455, %459
  %461 = fadd double %446, %460
  store double %461, ptr %436, align 8
  br label %462

462:                                              ; preds = %445, %452
  %463 = phi double [ %446, %445 ], [ %461, %452 ]
  br i1 %447, label %445, label %464

464:                                              ; preds = %35, %304, %216, %462, %52
  %465 = phi i32 [ 0, %52 ], [ 1, %462 ], [ 0, %216 ], [ 0, %304 ], [ 0, %35 ]
  ret i32 %465
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


