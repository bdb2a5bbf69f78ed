; body_motion.c 3cc3fa4c1d33bd842cf584778bde4e040c55607ff46a2cc068d73cc87b2fb8f9: written by make kernel

%struct.Arm = type { i64, ptr, ptr, ptr, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

@place.still = internal unnamed_addr constant [12 x double] [double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00], align 16

define dso_local void @manipplan_motion(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, ptr nocapture noundef readonly %5, ptr nocapture noundef readonly %6, i64 noundef %7, ptr nocapture noundef writeonly %8, ptr noundef writeonly %9) local_unnamed_addr #0 {
  %11 = alloca [9 x double], align 16
  %12 = alloca [9 x double], align 16
  %13 = alloca [65 x [12 x double]], align 16
  %14 = alloca [65 x [3 x double]], align 16
  %15 = alloca [8 x [3 x double]], align 16
  call void @llvm.lifetime.start.p0(i64 6240, ptr nonnull %13) #5
  call void @llvm.lifetime.start.p0(i64 1560, ptr nonnull %14) #5
  %16 = load i64, ptr %0, align 8
  %17 = icmp sgt i64 %7, 0
  br i1 %17, label %18, label %48

18:                                               ; preds = %10
  %19 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 8
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 5
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 10
  %24 = load ptr, ptr %23, align 8
  %25 = add i64 %16, 1
  %26 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 11
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 2
  %29 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 1
  %30 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 3
  %31 = getelementptr inbounds double, ptr %12, i64 1
  %32 = getelementptr inbounds double, ptr %12, i64 2
  %33 = getelementptr inbounds double, ptr %12, i64 3
  %34 = getelementptr inbounds double, ptr %12, i64 4
  %35 = getelementptr inbounds double, ptr %12, i64 5
  %36 = getelementptr inbounds double, ptr %12, i64 6
  %37 = getelementptr inbounds double, ptr %12, i64 7
  %38 = getelementptr inbounds double, ptr %12, i64 8
  %39 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 4
  %40 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 12
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 6
  %43 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 7
  %44 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 9
  %45 = load ptr, ptr %44, align 8
  %46 = icmp eq ptr %9, null
  %47 = shl i64 %25, 3
  br label %49

48:                                               ; preds = %430, %10
  call void @llvm.lifetime.end.p0(i64 1560, ptr nonnull %14) #5
  call void @llvm.lifetime.end.p0(i64 6240, ptr nonnull %13) #5
  ret void

49:                                               ; preds = %18, %430
  %50 = phi i64 [ -1, %18 ], [ %261, %430 ]
  %51 = phi i64 [ 0, %18 ], [ %431, %430 ]
  %52 = getelementptr inbounds i64, ptr %6, i64 %51
  %53 = load i64, ptr %52, align 8
  %54 = getelementptr inbounds i64, ptr %20, i64 %53
  %55 = load i64, ptr %54, align 8
  %56 = getelementptr inbounds i64, ptr %22, i64 %55
  %57 = load i64, ptr %56, align 8
  %58 = mul nsw i64 %55, %25
  %59 = getelementptr inbounds double, ptr %24, i64 %58
  %60 = getelementptr inbounds double, ptr %27, i64 %58
  %61 = getelementptr inbounds i64, ptr %5, i64 %51
  %62 = load i64, ptr %61, align 8
  %63 = icmp eq i64 %62, %50
  br i1 %63, label %260, label %64

64:                                               ; preds = %49
  %65 = mul nsw i64 %62, %16
  %66 = getelementptr inbounds double, ptr %1, i64 %65
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(96) %13, ptr noundef nonnull align 16 dereferenceable(96) @place.still, i64 96, i1 false)
  %67 = load i64, ptr %0, align 8
  %68 = icmp sgt i64 %67, 0
  br i1 %68, label %69, label %251

69:                                               ; preds = %64
  %70 = load ptr, ptr %28, align 8
  %71 = load ptr, ptr %29, align 8
  %72 = load ptr, ptr %30, align 8
  br label %73

73:                                               ; preds = %249, %69
  %74 = phi i64 [ 0, %69 ], [ %112, %249 ]
  %75 = mul nuw nsw i64 %74, 12
  %76 = getelementptr inbounds double, ptr %71, i64 %75
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %11) #5
  %77 = getelementptr inbounds [12 x double], ptr %13, i64 %74
  br label %78

78:                                               ; preds = %89, %73
  %79 = phi i64 [ 0, %73 ], [ %90, %89 ]
  %80 = mul nuw nsw i64 %79, 3
  %81 = getelementptr inbounds double, ptr %77, i64 %80
  %82 = add nuw nsw i64 %80, 1
  %83 = getelementptr inbounds double, ptr %77, i64 %82
  %84 = add nuw nsw i64 %80, 2
  %85 = getelementptr inbounds double, ptr %77, i64 %84
  %86 = load double, ptr %81, align 8
  %87 = load double, ptr %83, align 8
  %88 = load double, ptr %85, align 8
  br label %92

89:                                               ; preds = %92
  %90 = add nuw nsw i64 %79, 1
  %91 = icmp eq i64 %90, 3
  br i1 %91, label %111, label %78

92:                                               ; preds = %92, %78
  %93 = phi i64 [ 0, %78 ], [ %109, %92 ]
  %94 = getelementptr inbounds double, ptr %76, i64 %93
  %95 = load double, ptr %94, align 8
  %96 = fmul double %86, %95
  %97 = add nuw nsw i64 %93, 3
  %98 = getelementptr inbounds double, ptr %76, i64 %97
  %99 = load double, ptr %98, align 8
  %100 = fmul double %87, %99
  %101 = fadd double %96, %100
  %102 = add nuw nsw i64 %93, 6
  %103 = getelementptr inbounds double, ptr %76, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = fmul double %88, %104
  %106 = fadd double %101, %105
  %107 = add nuw nsw i64 %93, %80
  %108 = getelementptr inbounds double, ptr %11, i64 %107
  store double %106, ptr %108, align 8
  %109 = add nuw nsw i64 %93, 1
  %110 = icmp eq i64 %109, 3
  br i1 %110, label %89, label %92

111:                                              ; preds = %89
  %112 = add nuw nsw i64 %74, 1
  %113 = getelementptr inbounds [12 x double], ptr %13, i64 %112
  %114 = getelementptr inbounds double, ptr %76, i64 9
  %115 = getelementptr inbounds double, ptr %113, i64 9
  %116 = getelementptr inbounds double, ptr %114, i64 1
  %117 = getelementptr inbounds double, ptr %114, i64 2
  %118 = load double, ptr %114, align 8
  %119 = load double, ptr %116, align 8
  %120 = load double, ptr %117, align 8
  br label %121

121:                                              ; preds = %121, %111
  %122 = phi i64 [ 0, %111 ], [ %140, %121 ]
  %123 = mul nuw nsw i64 %122, 3
  %124 = getelementptr inbounds double, ptr %77, i64 %123
  %125 = load double, ptr %124, align 8
  %126 = fmul double %125, %118
  %127 = getelementptr inbounds double, ptr %124, i64 1
  %128 = load double, ptr %127, align 8
  %129 = fmul double %128, %119
  %130 = fadd double %126, %129
  %131 = getelementptr inbounds double, ptr %124, i64 2
  %132 = load double, ptr %131, align 8
  %133 = fmul double %132, %120
  %134 = fadd double %130, %133
  %135 = add nuw nsw i64 %122, 9
  %136 = getelementptr inbounds double, ptr %77, i64 %135
  %137 = load double, ptr %136, align 8
  %138 = fadd double %137, %134
  %139 = getelementptr inbounds double, ptr %115, i64 %122
  store double %138, ptr %139, align 8
  %140 = add nuw nsw i64 %122, 1
  %141 = icmp eq i64 %140, 3
  br i1 %141, label %142, label %121

142:                                              ; preds = %121
  %143 = mul nsw i64 %74, 3
  %144 = getelementptr inbounds double, ptr %70, i64 %143
  %145 = getelementptr inbounds double, ptr %144, i64 1
  %146 = getelementptr inbounds double, ptr %144, i64 2
  %147 = load double, ptr %144, align 8
  %148 = load double, ptr %145, align 8
  %149 = load double, ptr %146, align 8
  br label %154

150:                                              ; preds = %154
  %151 = getelementptr inbounds i64, ptr %72, i64 %74
  %152 = load i64, ptr %151, align 8
  %153 = icmp eq i64 %152, 0
  br i1 %153, label %185, label %171

154:                                              ; preds = %154, %142
  %155 = phi i64 [ 0, %142 ], [ %169, %154 ]
  %156 = mul nuw nsw i64 %155, 3
  %157 = getelementptr inbounds double, ptr %11, i64 %156
  %158 = load double, ptr %157, align 8
  %159 = fmul double %158, %147
  %160 = getelementptr inbounds double, ptr %157, i64 1
  %161 = load double, ptr %160, align 8
  %162 = fmul double %161, %148
  %163 = fadd double %159, %162
  %164 = getelementptr inbounds double, ptr %157, i64 2
  %165 = load double, ptr %164, align 8
  %166 = fmul double %165, %149
  %167 = fadd double %163, %166
  %168 = getelementptr inbounds [3 x double], ptr %14, i64 %112, i64 %155
  store double %167, ptr %168, align 8
  %169 = add nuw nsw i64 %155, 1
  %170 = icmp eq i64 %169, 3
  br i1 %170, label %150, label %154

171:                                              ; preds = %150
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(72) %113, ptr noundef nonnull align 16 dereferenceable(72) %11, i64 72, i1 false)
  %172 = getelementptr inbounds double, ptr %66, i64 %74
  %173 = load double, ptr %172, align 8
  br label %174

174:                                              ; preds = %174, %171
  %175 = phi i64 [ 0, %171 ], [ %183, %174 ]
  %176 = getelementptr inbounds [3 x double], ptr %14, i64 %112, i64 %175
  %177 = load double, ptr %176, align 8
  %178 = fmul double %173, %177
  %179 = add nuw nsw i64 %175, 9
  %180 = getelementptr inbounds double, ptr %113, i64 %179
  %181 = load double, ptr %180, align 8
  %182 = fadd double %181, %178
  store double %182, ptr %180, align 8
  %183 = add nuw nsw i64 %175, 1
  %184 = icmp eq i64 %183, 3
  br i1 %184, label %249, label %174

185:                                              ; preds = %150
  %186 = getelementptr inbounds double, ptr %66, i64 %74
  %187 = load double, ptr %186, align 8
  %188 = tail call double @llvm.sin.f64(double %187)
  %189 = tail call double @llvm.cos.f64(double %187)
  %190 = fsub double 1.000000e+00, %189
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %12) #5
  %191 = fmul double %147, %190
  %192 = fmul double %147, %191
  %193 = fadd double %189, %192
  store double %193, ptr %12, align 16
  %194 = fmul double %148, %191
  %195 = fmul double %149, %188
  %196 = fsub double %194, %195
  store double %196, ptr %31, align 8
  %197 = fmul double %149, %191
  %198 = fmul double %148, %188
  %199 = fadd double %198, %197
  store double %199, ptr %32, align 16
  %200 = fmul double %148, %190
  %201 = fmul double %147, %200
  %202 = fadd double %195, %201
  store double %202, ptr %33, align 8
  %203 = fmul double %148, %200
  %204 = fadd double %189, %203
  store double %204, ptr %34, align 16
  %205 = fmul double %149, %200
  %206 = fmul double %147, %188
  %207 = fsub double %205, %206
  store double %207, ptr %35, align 8
  %208 = fmul double %149, %190
  %209 = fmul double %147, %208
  %210 = fsub double %209, %198
  store double %210, ptr %36, align 16
  %211 = fmul double %148, %208
  %212 = fadd double %206, %211
  store double %212, ptr %37, align 8
  %213 = fmul double %149, %208
  %214 = fadd double %189, %213
  store double %214, ptr %38, align 16
  br label %215

215:                                              ; preds = %226, %185
  %216 = phi i64 [ 0, %185 ], [ %227, %226 ]
  %217 = mul nuw nsw i64 %216, 3
  %218 = getelementptr inbounds double, ptr %11, i64 %217
  %219 = add nuw nsw i64 %217, 1
  %220 = getelementptr inbounds double, ptr %11, i64 %219
  %221 = add nuw nsw i64 %217, 2
  %222 = getelementptr inbounds double, ptr %11, i64 %221
  %223 = load double, ptr %218, align 8
  %224 = load double, ptr %220, align 8
  %225 = load double, ptr %222, align 8
  br label %229

226:                                              ; preds = %229
  %227 = add nuw nsw i64 %216, 1
  %228 = icmp eq i64 %227, 3
  br i1 %228, label %248, label %215

229:                                              ; preds = %229, %215
  %230 = phi i64 [ 0, %215 ], [ %246, %229 ]
  %231 = getelementptr inbounds double, ptr %12, i64 %230
  %232 = load double, ptr %231, align 8
  %233 = fmul double %223, %232
  %234 = add nuw nsw i64 %230, 3
  %235 = getelementptr inbounds double, ptr %12, i64 %234
  %236 = load double, ptr %235, align 8
  %237 = fmul double %224, %236
  %238 = fadd double %233, %237
  %239 = add nuw nsw i64 %230, 6
  %240 = getelementptr inbounds double, ptr %12, i64 %239
  %241 = load double, ptr %240, align 8
  %242 = fmul double %225, %241
  %243 = fadd double %238, %242
  %244 = add nuw nsw i64 %230, %217
  %245 = getelementptr inbounds double, ptr %113, i64 %244
  store double %243, ptr %245, align 8
  %246 = add nuw nsw i64 %230, 1
  %247 = icmp eq i64 %246, 3
  br i1 %247, label %226, label %229

248:                                              ; preds = %226
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %12) #5
  br label %249

249:                                              ; preds = %174, %248
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %11) #5
  %250 = icmp eq i64 %112, %67
  br i1 %250, label %251, label %73

251:                                              ; preds = %249, %64
  %252 = load i64, ptr %39, align 8
  %253 = icmp sgt i64 %252, 0
  br i1 %253, label %254, label %260

254:                                              ; preds = %251, %254
  %255 = phi i64 [ %257, %254 ], [ 0, %251 ]
  %256 = getelementptr inbounds i64, ptr %41, i64 %255
  store i64 -1, ptr %256, align 8
  %257 = add nuw nsw i64 %255, 1
  %258 = load i64, ptr %39, align 8
  %259 = icmp slt i64 %257, %258
  br i1 %259, label %254, label %260

260:                                              ; preds = %254, %251, %49
  %261 = phi i64 [ %50, %49 ], [ %62, %251 ], [ %62, %254 ]
  %262 = getelementptr inbounds i64, ptr %41, i64 %55
  %263 = load i64, ptr %262, align 8
  %264 = icmp eq i64 %263, %261
  br i1 %264, label %386, label %265

265:                                              ; preds = %260
  call void @llvm.lifetime.start.p0(i64 192, ptr nonnull %15) #5
  %266 = getelementptr inbounds [65 x [12 x double]], ptr %13, i64 0, i64 %57
  %267 = load ptr, ptr %42, align 8
  %268 = shl nsw i64 %55, 3
  br label %278

269:                                              ; preds = %310
  %270 = icmp sgt i64 %57, %16
  br i1 %270, label %313, label %271

271:                                              ; preds = %269
  %272 = mul i64 %47, %55
  %273 = shl i64 %57, 3
  %274 = add i64 %272, %273
  %275 = getelementptr i8, ptr %24, i64 %274
  %276 = sub i64 %25, %57
  %277 = shl nuw i64 %276, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %275, i8 0, i64 %277, i1 false)
  br label %313

278:                                              ; preds = %265, %310
  %279 = phi i64 [ 0, %265 ], [ %311, %310 ]
  %280 = add nuw nsw i64 %268, %279
  %281 = mul nsw i64 %280, 3
  %282 = getelementptr inbounds double, ptr %267, i64 %281
  %283 = getelementptr inbounds [8 x [3 x double]], ptr %15, i64 0, i64 %279
  %284 = getelementptr inbounds double, ptr %282, i64 1
  %285 = getelementptr inbounds double, ptr %282, i64 2
  %286 = load double, ptr %282, align 8
  %287 = load double, ptr %284, align 8
  %288 = load double, ptr %285, align 8
  br label %289

289:                                              ; preds = %289, %278
  %290 = phi i64 [ 0, %278 ], [ %308, %289 ]
  %291 = mul nuw nsw i64 %290, 3
  %292 = getelementptr inbounds double, ptr %266, i64 %291
  %293 = load double, ptr %292, align 8
  %294 = fmul double %293, %286
  %295 = getelementptr inbounds double, ptr %292, i64 1
  %296 = load double, ptr %295, align 8
  %297 = fmul double %296, %287
  %298 = fadd double %294, %297
  %299 = getelementptr inbounds double, ptr %292, i64 2
  %300 = load double, ptr %299, align 8
  %301 = fmul double %300, %288
  %302 = fadd double %298, %301
  %303 = add nuw nsw i64 %290, 9
  %304 = getelementptr inbounds double, ptr %266, i64 %303
  %305 = load double, ptr %304, align 8
  %306 = fadd double %305, %302
  %307 = getelementptr inbounds double, ptr %283, i64 %290
  store double %306, ptr %307, align 8
  %308 = add nuw nsw i64 %290, 1
  %309 = icmp eq i64 %308, 3
  br i1 %309, label %310, label %289

310:                                              ; preds = %289
  %311 = add nuw nsw i64 %279, 1
  %312 = icmp eq i64 %311, 8
  br i1 %312, label %269, label %278

313:                                              ; preds = %271, %269
  %314 = icmp sgt i64 %57, 0
  br i1 %314, label %315, label %318

315:                                              ; preds = %313
  %316 = load ptr, ptr %30, align 8
  %317 = mul nsw i64 %261, %16
  br label %319

318:                                              ; preds = %375, %313
  store i64 %261, ptr %262, align 8
  call void @llvm.lifetime.end.p0(i64 192, ptr nonnull %15) #5
  br label %386

319:                                              ; preds = %315, %375
  %320 = phi i64 [ %57, %315 ], [ %322, %375 ]
  %321 = getelementptr inbounds double, ptr %60, i64 %320
  store double 1.000000e+00, ptr %321, align 8
  %322 = add nsw i64 %320, -1
  %323 = getelementptr inbounds i64, ptr %316, i64 %322
  %324 = load i64, ptr %323, align 8
  %325 = icmp eq i64 %324, 0
  br i1 %325, label %326, label %375

326:                                              ; preds = %319
  %327 = getelementptr inbounds [65 x [12 x double]], ptr %13, i64 0, i64 %320, i64 9
  %328 = getelementptr inbounds [65 x [3 x double]], ptr %14, i64 0, i64 %320
  %329 = load double, ptr %327, align 8
  %330 = getelementptr inbounds [65 x [12 x double]], ptr %13, i64 0, i64 %320, i64 10
  %331 = load double, ptr %330, align 16
  %332 = getelementptr inbounds [65 x [12 x double]], ptr %13, i64 0, i64 %320, i64 11
  %333 = load double, ptr %332, align 8
  %334 = load double, ptr %328, align 8
  %335 = getelementptr inbounds double, ptr %328, i64 1
  %336 = load double, ptr %335, align 8
  %337 = getelementptr inbounds double, ptr %328, i64 2
  %338 = load double, ptr %337, align 8
  br label %339

339:                                              ; preds = %339, %326
  %340 = phi i64 [ 0, %326 ], [ %364, %339 ]
  %341 = phi double [ 0.000000e+00, %326 ], [ %363, %339 ]
  %342 = getelementptr inbounds [3 x double], ptr %15, i64 %340
  %343 = load double, ptr %342, align 8
  %344 = fsub double %343, %329
  %345 = getelementptr inbounds [3 x double], ptr %15, i64 %340, i64 1
  %346 = load double, ptr %345, align 8
  %347 = fsub double %346, %331
  %348 = getelementptr inbounds [3 x double], ptr %15, i64 %340, i64 2
  %349 = load double, ptr %348, align 8
  %350 = fsub double %349, %333
  %351 = fmul double %334, %344
  %352 = fmul double %336, %347
  %353 = fadd double %351, %352
  %354 = fmul double %338, %350
  %355 = fadd double %353, %354
  %356 = fmul double %344, %344
  %357 = fmul double %347, %347
  %358 = fadd double %356, %357
  %359 = fmul double %350, %350
  %360 = fadd double %358, %359
  %361 = fmul double %355, %355
  %362 = fsub double %360, %361
  %363 = tail call double @llvm.maxnum.f64(double %341, double %362)
  %364 = add nuw nsw i64 %340, 1
  %365 = icmp eq i64 %364, 8
  br i1 %365, label %366, label %339

366:                                              ; preds = %339
  %367 = tail call double @llvm.sqrt.f64(double %363)
  %368 = load ptr, ptr %43, align 8
  %369 = getelementptr inbounds double, ptr %368, i64 %55
  %370 = load double, ptr %369, align 8
  %371 = fadd double %367, %370
  %372 = getelementptr inbounds double, ptr %59, i64 %320
  %373 = load double, ptr %372, align 8
  %374 = fadd double %371, %373
  store double %374, ptr %321, align 8
  br label %375

375:                                              ; preds = %366, %319
  %376 = phi double [ %374, %366 ], [ 1.000000e+00, %319 ]
  %377 = getelementptr inbounds double, ptr %59, i64 %320
  %378 = load double, ptr %377, align 8
  %379 = add i64 %322, %317
  %380 = getelementptr inbounds double, ptr %2, i64 %379
  %381 = load double, ptr %380, align 8
  %382 = fmul double %381, %376
  %383 = fadd double %378, %382
  %384 = getelementptr inbounds double, ptr %59, i64 %322
  store double %383, ptr %384, align 8
  %385 = icmp sgt i64 %320, 1
  br i1 %385, label %319, label %318

386:                                              ; preds = %318, %260
  %387 = load i64, ptr %52, align 8
  %388 = getelementptr inbounds i64, ptr %45, i64 %387
  %389 = load i64, ptr %388, align 8
  %390 = getelementptr inbounds double, ptr %59, i64 %389
  %391 = load double, ptr %390, align 8
  %392 = getelementptr inbounds double, ptr %8, i64 %51
  store double %391, ptr %392, align 8
  br i1 %46, label %430, label %393

393:                                              ; preds = %386
  %394 = mul nsw i64 %261, %16
  %395 = getelementptr inbounds double, ptr %3, i64 %394
  %396 = getelementptr inbounds double, ptr %4, i64 %394
  %397 = getelementptr inbounds i64, ptr %20, i64 %387
  %398 = load i64, ptr %397, align 8
  %399 = getelementptr inbounds i64, ptr %22, i64 %398
  %400 = load i64, ptr %399, align 8
  %401 = icmp slt i64 %389, %400
  br i1 %401, label %402, label %427

402:                                              ; preds = %393
  %403 = load ptr, ptr %30, align 8
  br label %404

404:                                              ; preds = %404, %402
  %405 = phi double [ 0.000000e+00, %402 ], [ %424, %404 ]
  %406 = phi double [ 0.000000e+00, %402 ], [ %425, %404 ]
  %407 = phi i64 [ %389, %402 ], [ %408, %404 ]
  %408 = add nsw i64 %407, 1
  %409 = getelementptr inbounds double, ptr %395, i64 %407
  %410 = load double, ptr %409, align 8
  %411 = getelementptr inbounds i64, ptr %403, i64 %407
  %412 = load i64, ptr %411, align 8
  %413 = icmp eq i64 %412, 0
  %414 = select i1 %413, double %410, double 0.000000e+00
  %415 = getelementptr inbounds double, ptr %60, i64 %408
  %416 = load double, ptr %415, align 8
  %417 = fmul double %406, 2.000000e+00
  %418 = fadd double %417, %414
  %419 = fmul double %410, %418
  %420 = getelementptr inbounds double, ptr %396, i64 %407
  %421 = load double, ptr %420, align 8
  %422 = fadd double %421, %419
  %423 = fmul double %416, %422
  %424 = fadd double %405, %423
  %425 = fadd double %406, %414
  %426 = icmp eq i64 %408, %400
  br i1 %426, label %427, label %404

427:                                              ; preds = %404, %393
  %428 = phi double [ 0.000000e+00, %393 ], [ %424, %404 ]
  %429 = getelementptr inbounds double, ptr %9, i64 %51
  store double %428, ptr %429, align 8
  br label %430

430:                                              ; preds = %427, %386
  %431 = add nuw nsw i64 %51, 1
  %432 = icmp eq i64 %431, %7
  br i1 %432, label %48, label %49
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.memcpy.p0.p0.i64(ptr noalias nocapture writeonly, ptr noalias nocapture readonly, i64, i1 immarg) #2

declare double @llvm.sin.f64(double) #3

declare double @llvm.cos.f64(double) #3

declare double @llvm.maxnum.f64(double, double) #3

declare double @llvm.sqrt.f64(double) #3

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #4

attributes #0 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #3 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #4 = { nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #5 = { nounwind }


