; body_motion.c c85415875ba3166233108c8a8c368917909548ad2312821af7f0fe9afae1aa49: written by make kernel

%struct.Arm = type { i64, ptr, ptr, ptr, ptr, ptr, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr }

@place.still = internal unnamed_addr constant [12 x double] [double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00], align 16

define dso_local void @manipplan_motion(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, ptr nocapture noundef readonly %5, ptr nocapture noundef readonly %6, i64 noundef %7, ptr nocapture noundef %8, ptr noundef writeonly %9) local_unnamed_addr #0 {
  %11 = alloca [9 x double], align 16
  %12 = alloca [9 x double], align 16
  %13 = alloca [65 x [12 x double]], align 16
  %14 = alloca [65 x [3 x double]], align 16
  %15 = alloca [8 x [3 x double]], align 16
  %16 = alloca [64 x i64], align 16
  call void @llvm.lifetime.start.p0(i64 6240, ptr nonnull %13) #4
  call void @llvm.lifetime.start.p0(i64 1560, ptr nonnull %14) #4
  call void @llvm.lifetime.start.p0(i64 192, ptr nonnull %15) #4
  %17 = load i64, ptr %0, align 8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %16) #4
  %18 = icmp sgt i64 %7, 0
  br i1 %18, label %19, label %51

19:                                               ; preds = %10
  %20 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 10
  %21 = load ptr, ptr %20, align 8
  %22 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 7
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 12
  %25 = load ptr, ptr %24, align 8
  %26 = add nsw i64 %17, 1
  %27 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 13
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 4
  %30 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 3
  %31 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 1
  %32 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 5
  %33 = getelementptr inbounds double, ptr %12, i64 1
  %34 = getelementptr inbounds double, ptr %12, i64 2
  %35 = getelementptr inbounds double, ptr %12, i64 3
  %36 = getelementptr inbounds double, ptr %12, i64 4
  %37 = getelementptr inbounds double, ptr %12, i64 5
  %38 = getelementptr inbounds double, ptr %12, i64 6
  %39 = getelementptr inbounds double, ptr %12, i64 7
  %40 = getelementptr inbounds double, ptr %12, i64 8
  %41 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 6
  %42 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 14
  %43 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 11
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 2
  %46 = load ptr, ptr %45, align 8
  %47 = load ptr, ptr %42, align 8
  %48 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 8
  %49 = getelementptr inbounds %struct.Arm, ptr %0, i64 0, i32 9
  %50 = icmp eq ptr %9, null
  br label %52

51:                                               ; preds = %566, %10
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %16) #4
  call void @llvm.lifetime.end.p0(i64 192, ptr nonnull %15) #4
  call void @llvm.lifetime.end.p0(i64 1560, ptr nonnull %14) #4
  call void @llvm.lifetime.end.p0(i64 6240, ptr nonnull %13) #4
  ret void

52:                                               ; preds = %19, %566
  %53 = phi i64 [ -1, %19 ], [ %275, %566 ]
  %54 = phi i64 [ 0, %19 ], [ %567, %566 ]
  %55 = getelementptr inbounds i64, ptr %6, i64 %54
  %56 = load i64, ptr %55, align 8
  %57 = getelementptr inbounds i64, ptr %21, i64 %56
  %58 = load i64, ptr %57, align 8
  %59 = getelementptr inbounds i64, ptr %23, i64 %58
  %60 = load i64, ptr %59, align 8
  %61 = mul nsw i64 %58, %26
  %62 = getelementptr inbounds double, ptr %25, i64 %61
  %63 = getelementptr inbounds double, ptr %28, i64 %61
  %64 = getelementptr inbounds i64, ptr %5, i64 %54
  %65 = load i64, ptr %64, align 8
  %66 = icmp eq i64 %65, %53
  br i1 %66, label %272, label %67

67:                                               ; preds = %52
  %68 = mul nsw i64 %65, %17
  %69 = getelementptr inbounds double, ptr %1, i64 %68
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(96) %13, ptr noundef nonnull align 16 dereferenceable(96) @place.still, i64 96, i1 false)
  %70 = load i64, ptr %0, align 8
  %71 = icmp sgt i64 %70, 0
  br i1 %71, label %72, label %257

72:                                               ; preds = %67
  %73 = load ptr, ptr %29, align 8
  %74 = load ptr, ptr %30, align 8
  %75 = load ptr, ptr %31, align 8
  %76 = load ptr, ptr %32, align 8
  br label %77

77:                                               ; preds = %255, %72
  %78 = phi i64 [ 0, %72 ], [ %118, %255 ]
  %79 = mul nuw nsw i64 %78, 12
  %80 = getelementptr inbounds double, ptr %74, i64 %79
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %11) #4
  %81 = getelementptr inbounds i64, ptr %75, i64 %78
  %82 = load i64, ptr %81, align 8
  %83 = getelementptr inbounds [12 x double], ptr %13, i64 %82
  br label %84

84:                                               ; preds = %95, %77
  %85 = phi i64 [ 0, %77 ], [ %96, %95 ]
  %86 = mul nuw nsw i64 %85, 3
  %87 = getelementptr inbounds double, ptr %83, i64 %86
  %88 = add nuw nsw i64 %86, 1
  %89 = getelementptr inbounds double, ptr %83, i64 %88
  %90 = add nuw nsw i64 %86, 2
  %91 = getelementptr inbounds double, ptr %83, i64 %90
  %92 = load double, ptr %87, align 8
  %93 = load double, ptr %89, align 8
  %94 = load double, ptr %91, align 8
  br label %98

95:                                               ; preds = %98
  %96 = add nuw nsw i64 %85, 1
  %97 = icmp eq i64 %96, 3
  br i1 %97, label %117, label %84

98:                                               ; preds = %98, %84
  %99 = phi i64 [ 0, %84 ], [ %115, %98 ]
  %100 = getelementptr inbounds double, ptr %80, i64 %99
  %101 = load double, ptr %100, align 8
  %102 = fmul double %92, %101
  %103 = add nuw nsw i64 %99, 3
  %104 = getelementptr inbounds double, ptr %80, i64 %103
  %105 = load double, ptr %104, align 8
  %106 = fmul double %93, %105
  %107 = fadd double %102, %106
  %108 = add nuw nsw i64 %99, 6
  %109 = getelementptr inbounds double, ptr %80, i64 %108
  %110 = load double, ptr %109, align 8
  %111 = fmul double %94, %110
  %112 = fadd double %107, %111
  %113 = add nuw nsw i64 %99, %86
  %114 = getelementptr inbounds double, ptr %11, i64 %113
  store double %112, ptr %114, align 8
  %115 = add nuw nsw i64 %99, 1
  %116 = icmp eq i64 %115, 3
  br i1 %116, label %95, label %98

117:                                              ; preds = %95
  %118 = add nuw nsw i64 %78, 1
  %119 = getelementptr inbounds [12 x double], ptr %13, i64 %118
  %120 = getelementptr inbounds double, ptr %80, i64 9
  %121 = getelementptr inbounds double, ptr %119, i64 9
  %122 = getelementptr inbounds double, ptr %120, i64 1
  %123 = getelementptr inbounds double, ptr %120, i64 2
  %124 = load double, ptr %120, align 8
  %125 = load double, ptr %122, align 8
  %126 = load double, ptr %123, align 8
  br label %127

127:                                              ; preds = %127, %117
  %128 = phi i64 [ 0, %117 ], [ %146, %127 ]
  %129 = mul nuw nsw i64 %128, 3
  %130 = getelementptr inbounds double, ptr %83, i64 %129
  %131 = load double, ptr %130, align 8
  %132 = fmul double %131, %124
  %133 = getelementptr inbounds double, ptr %130, i64 1
  %134 = load double, ptr %133, align 8
  %135 = fmul double %134, %125
  %136 = fadd double %132, %135
  %137 = getelementptr inbounds double, ptr %130, i64 2
  %138 = load double, ptr %137, align 8
  %139 = fmul double %138, %126
  %140 = fadd double %136, %139
  %141 = add nuw nsw i64 %128, 9
  %142 = getelementptr inbounds double, ptr %83, i64 %141
  %143 = load double, ptr %142, align 8
  %144 = fadd double %143, %140
  %145 = getelementptr inbounds double, ptr %121, i64 %128
  store double %144, ptr %145, align 8
  %146 = add nuw nsw i64 %128, 1
  %147 = icmp eq i64 %146, 3
  br i1 %147, label %148, label %127

148:                                              ; preds = %127
  %149 = mul nsw i64 %78, 3
  %150 = getelementptr inbounds double, ptr %73, i64 %149
  %151 = getelementptr inbounds double, ptr %150, i64 1
  %152 = getelementptr inbounds double, ptr %150, i64 2
  %153 = load double, ptr %150, align 8
  %154 = load double, ptr %151, align 8
  %155 = load double, ptr %152, align 8
  br label %160

156:                                              ; preds = %160
  %157 = getelementptr inbounds i64, ptr %76, i64 %78
  %158 = load i64, ptr %157, align 8
  %159 = icmp eq i64 %158, 0
  br i1 %159, label %191, label %177

160:                                              ; preds = %160, %148
  %161 = phi i64 [ 0, %148 ], [ %175, %160 ]
  %162 = mul nuw nsw i64 %161, 3
  %163 = getelementptr inbounds double, ptr %11, i64 %162
  %164 = load double, ptr %163, align 8
  %165 = fmul double %164, %153
  %166 = getelementptr inbounds double, ptr %163, i64 1
  %167 = load double, ptr %166, align 8
  %168 = fmul double %167, %154
  %169 = fadd double %165, %168
  %170 = getelementptr inbounds double, ptr %163, i64 2
  %171 = load double, ptr %170, align 8
  %172 = fmul double %171, %155
  %173 = fadd double %169, %172
  %174 = getelementptr inbounds [3 x double], ptr %14, i64 %118, i64 %161
  store double %173, ptr %174, align 8
  %175 = add nuw nsw i64 %161, 1
  %176 = icmp eq i64 %175, 3
  br i1 %176, label %156, label %160

177:                                              ; preds = %156
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(72) %119, ptr noundef nonnull align 16 dereferenceable(72) %11, i64 72, i1 false)
  %178 = getelementptr inbounds double, ptr %69, i64 %78
  %179 = load double, ptr %178, align 8
  br label %180

180:                                              ; preds = %180, %177
  %181 = phi i64 [ 0, %177 ], [ %189, %180 ]
  %182 = getelementptr inbounds [3 x double], ptr %14, i64 %118, i64 %181
  %183 = load double, ptr %182, align 8
  %184 = fmul double %179, %183
  %185 = add nuw nsw i64 %181, 9
  %186 = getelementptr inbounds double, ptr %119, i64 %185
  %187 = load double, ptr %186, align 8
  %188 = fadd double %187, %184
  store double %188, ptr %186, align 8
  %189 = add nuw nsw i64 %181, 1
  %190 = icmp eq i64 %189, 3
  br i1 %190, label %255, label %180

191:                                              ; preds = %156
  %192 = getelementptr inbounds double, ptr %69, i64 %78
  %193 = load double, ptr %192, align 8
  %194 = tail call double @llvm.sin.f64(double %193)
  %195 = tail call double @llvm.cos.f64(double %193)
  %196 = fsub double 1.000000e+00, %195
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %12) #4
  %197 = fmul double %153, %196
  %198 = fmul double %153, %197
  %199 = fadd double %195, %198
  store double %199, ptr %12, align 16
  %200 = fmul double %154, %197
  %201 = fmul double %155, %194
  %202 = fsub double %200, %201
  store double %202, ptr %33, align 8
  %203 = fmul double %155, %197
  %204 = fmul double %154, %194
  %205 = fadd double %204, %203
  store double %205, ptr %34, align 16
  %206 = fmul double %154, %196
  %207 = fmul double %153, %206
  %208 = fadd double %201, %207
  store double %208, ptr %35, align 8
  %209 = fmul double %154, %206
  %210 = fadd double %195, %209
  store double %210, ptr %36, align 16
  %211 = fmul double %155, %206
  %212 = fmul double %153, %194
  %213 = fsub double %211, %212
  store double %213, ptr %37, align 8
  %214 = fmul double %155, %196
  %215 = fmul double %153, %214
  %216 = fsub double %215, %204
  store double %216, ptr %38, align 16
  %217 = fmul double %154, %214
  %218 = fadd double %212, %217
  store double %218, ptr %39, align 8
  %219 = fmul double %155, %214
  %220 = fadd double %195, %219
  store double %220, ptr %40, align 16
  br label %221

221:                                              ; preds = %232, %191
  %222 = phi i64 [ 0, %191 ], [ %233, %232 ]
  %223 = mul nuw nsw i64 %222, 3
  %224 = getelementptr inbounds double, ptr %11, i64 %223
  %225 = add nuw nsw i64 %223, 1
  %226 = getelementptr inbounds double, ptr %11, i64 %225
  %227 = add nuw nsw i64 %223, 2
  %228 = getelementptr inbounds double, ptr %11, i64 %227
  %229 = load double, ptr %224, align 8
  %230 = load double, ptr %226, align 8
  %231 = load double, ptr %228, align 8
  br label %235

232:                                              ; preds = %235
  %233 = add nuw nsw i64 %222, 1
  %234 = icmp eq i64 %233, 3
  br i1 %234, label %254, label %221

235:                                              ; preds = %235, %221
  %236 = phi i64 [ 0, %221 ], [ %252, %235 ]
  %237 = getelementptr inbounds double, ptr %12, i64 %236
  %238 = load double, ptr %237, align 8
  %239 = fmul double %229, %238
  %240 = add nuw nsw i64 %236, 3
  %241 = getelementptr inbounds double, ptr %12, i64 %240
  %242 = load double, ptr %241, align 8
  %243 = fmul double %230, %242
  %244 = fadd double %239, %243
  %245 = add nuw nsw i64 %236, 6
  %246 = getelementptr inbounds double, ptr %12, i64 %245
  %247 = load double, ptr %246, align 8
  %248 = fmul double %231, %247
  %249 = fadd double %244, %248
  %250 = add nuw nsw i64 %236, %223
  %251 = getelementptr inbounds double, ptr %119, i64 %250
  store double %249, ptr %251, align 8
  %252 = add nuw nsw i64 %236, 1
  %253 = icmp eq i64 %252, 3
  br i1 %253, label %232, label %235

254:                                              ; preds = %232
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %12) #4
  br label %255

255:                                              ; preds = %180, %254
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %11) #4
  %256 = icmp eq i64 %118, %70
  br i1 %256, label %257, label %77

257:                                              ; preds = %255, %67
  %258 = load i64, ptr %41, align 8
  %259 = icmp sgt i64 %258, 0
  br i1 %259, label %260, label %272

260:                                              ; preds = %257, %260
  %261 = phi i64 [ %263, %260 ], [ 0, %257 ]
  %262 = getelementptr inbounds i64, ptr %47, i64 %261
  store i64 -1, ptr %262, align 8
  %263 = add nuw nsw i64 %261, 1
  %264 = load i64, ptr %41, align 8
  %265 = icmp slt i64 %263, %264
  br i1 %265, label %260, label %266

266:                                              ; preds = %260
  %267 = load i64, ptr %55, align 8
  %268 = getelementptr inbounds i64, ptr %21, i64 %267
  %269 = load i64, ptr %268, align 8
  %270 = getelementptr inbounds i64, ptr %23, i64 %269
  %271 = load i64, ptr %270, align 8
  br label %272

272:                                              ; preds = %266, %257, %52
  %273 = phi i64 [ %60, %52 ], [ %60, %257 ], [ %271, %266 ]
  %274 = phi i64 [ %56, %52 ], [ %56, %257 ], [ %267, %266 ]
  %275 = phi i64 [ %53, %52 ], [ %65, %257 ], [ %65, %266 ]
  %276 = load i64, ptr %0, align 8
  %277 = getelementptr inbounds i64, ptr %44, i64 %274
  %278 = load i64, ptr %277, align 8
  %279 = add nsw i64 %276, 1
  %280 = mul nsw i64 %273, %279
  %281 = add nsw i64 %278, %280
  %282 = getelementptr inbounds i64, ptr %46, i64 %281
  %283 = load i64, ptr %282, align 8
  %284 = icmp eq i64 %283, 0
  br i1 %284, label %285, label %287

285:                                              ; preds = %272
  %286 = load ptr, ptr %31, align 8
  br label %292

287:                                              ; preds = %292, %272
  %288 = phi i64 [ 0, %272 ], [ %295, %292 ]
  %289 = icmp slt i64 %273, 1
  br i1 %289, label %323, label %290

290:                                              ; preds = %287
  %291 = mul nsw i64 %278, %279
  br label %304

292:                                              ; preds = %292, %285
  %293 = phi i64 [ %278, %285 ], [ %299, %292 ]
  %294 = phi i64 [ 0, %285 ], [ %295, %292 ]
  %295 = add nuw nsw i64 %294, 1
  %296 = getelementptr inbounds i64, ptr %16, i64 %294
  store i64 %293, ptr %296, align 8
  %297 = add nsw i64 %293, -1
  %298 = getelementptr inbounds i64, ptr %286, i64 %297
  %299 = load i64, ptr %298, align 8
  %300 = add nsw i64 %299, %280
  %301 = getelementptr inbounds i64, ptr %46, i64 %300
  %302 = load i64, ptr %301, align 8
  %303 = icmp eq i64 %302, 0
  br i1 %303, label %292, label %287

304:                                              ; preds = %319, %290
  %305 = phi i64 [ 1, %290 ], [ %321, %319 ]
  %306 = phi i64 [ %288, %290 ], [ %320, %319 ]
  %307 = add nsw i64 %305, %280
  %308 = getelementptr inbounds i64, ptr %46, i64 %307
  %309 = load i64, ptr %308, align 8
  %310 = icmp eq i64 %309, 0
  br i1 %310, label %319, label %311

311:                                              ; preds = %304
  %312 = add nsw i64 %305, %291
  %313 = getelementptr inbounds i64, ptr %46, i64 %312
  %314 = load i64, ptr %313, align 8
  %315 = icmp eq i64 %314, 0
  br i1 %315, label %316, label %319

316:                                              ; preds = %311
  %317 = add nsw i64 %306, 1
  %318 = getelementptr inbounds i64, ptr %16, i64 %306
  store i64 %305, ptr %318, align 8
  br label %319

319:                                              ; preds = %316, %311, %304
  %320 = phi i64 [ %306, %311 ], [ %317, %316 ], [ %306, %304 ]
  %321 = add nuw i64 %305, 1
  %322 = icmp eq i64 %305, %273
  br i1 %322, label %323, label %304

323:                                              ; preds = %319, %287
  %324 = phi i64 [ %288, %287 ], [ %320, %319 ]
  %325 = getelementptr inbounds i64, ptr %47, i64 %58
  %326 = load i64, ptr %325, align 8
  %327 = icmp ne i64 %326, %275
  %328 = icmp ne i64 %288, 0
  %329 = select i1 %327, i1 true, i1 %328
  br i1 %329, label %330, label %369

330:                                              ; preds = %323
  %331 = getelementptr inbounds [65 x [12 x double]], ptr %13, i64 0, i64 %60
  %332 = load ptr, ptr %48, align 8
  %333 = shl nsw i64 %58, 3
  br label %334

334:                                              ; preds = %330, %366
  %335 = phi i64 [ 0, %330 ], [ %367, %366 ]
  %336 = add nuw nsw i64 %333, %335
  %337 = mul nsw i64 %336, 3
  %338 = getelementptr inbounds double, ptr %332, i64 %337
  %339 = getelementptr inbounds [8 x [3 x double]], ptr %15, i64 0, i64 %335
  %340 = getelementptr inbounds double, ptr %338, i64 1
  %341 = getelementptr inbounds double, ptr %338, i64 2
  %342 = load double, ptr %338, align 8
  %343 = load double, ptr %340, align 8
  %344 = load double, ptr %341, align 8
  br label %345

345:                                              ; preds = %345, %334
  %346 = phi i64 [ 0, %334 ], [ %364, %345 ]
  %347 = mul nuw nsw i64 %346, 3
  %348 = getelementptr inbounds double, ptr %331, i64 %347
  %349 = load double, ptr %348, align 8
  %350 = fmul double %349, %342
  %351 = getelementptr inbounds double, ptr %348, i64 1
  %352 = load double, ptr %351, align 8
  %353 = fmul double %352, %343
  %354 = fadd double %350, %353
  %355 = getelementptr inbounds double, ptr %348, i64 2
  %356 = load double, ptr %355, align 8
  %357 = fmul double %356, %344
  %358 = fadd double %354, %357
  %359 = add nuw nsw i64 %346, 9
  %360 = getelementptr inbounds double, ptr %331, i64 %359
  %361 = load double, ptr %360, align 8
  %362 = fadd double %361, %358
  %363 = getelementptr inbounds double, ptr %339, i64 %346
  store double %362, ptr %363, align 8
  %364 = add nuw nsw i64 %346, 1
  %365 = icmp eq i64 %364, 3
  br i1 %365, label %366, label %345

366:                                              ; preds = %345
  %367 = add nuw nsw i64 %335, 1
  %368 = icmp eq i64 %367, 8
  br i1 %368, label %369, label %334

369:                                              ; preds = %366, %323
  br i1 %327, label %370, label %444

370:                                              ; preds = %369
  %371 = getelementptr inbounds double, ptr %62, i64 %60
  store double 0.000000e+00, ptr %371, align 8
  %372 = icmp sgt i64 %60, 0
  br i1 %372, label %373, label %377

373:                                              ; preds = %370
  %374 = mul nsw i64 %275, %17
  %375 = load ptr, ptr %32, align 8
  %376 = load ptr, ptr %31, align 8
  br label %378

377:                                              ; preds = %436, %370
  store i64 %275, ptr %325, align 8
  br label %444

378:                                              ; preds = %373, %436
  %379 = phi double [ 0.000000e+00, %373 ], [ %439, %436 ]
  %380 = phi i64 [ %60, %373 ], [ %441, %436 ]
  %381 = add nsw i64 %380, -1
  %382 = add i64 %381, %374
  %383 = getelementptr inbounds double, ptr %2, i64 %382
  %384 = load double, ptr %383, align 8
  %385 = getelementptr inbounds double, ptr %63, i64 %380
  store double 1.000000e+00, ptr %385, align 8
  %386 = getelementptr inbounds i64, ptr %375, i64 %381
  %387 = load i64, ptr %386, align 8
  %388 = icmp eq i64 %387, 0
  br i1 %388, label %389, label %436

389:                                              ; preds = %378
  %390 = getelementptr inbounds [12 x double], ptr %13, i64 %380, i64 9
  %391 = getelementptr inbounds [3 x double], ptr %14, i64 %380
  %392 = load double, ptr %390, align 8
  %393 = getelementptr inbounds [12 x double], ptr %13, i64 %380, i64 10
  %394 = load double, ptr %393, align 16
  %395 = getelementptr inbounds [12 x double], ptr %13, i64 %380, i64 11
  %396 = load double, ptr %395, align 8
  %397 = load double, ptr %391, align 8
  %398 = getelementptr inbounds double, ptr %391, i64 1
  %399 = load double, ptr %398, align 8
  %400 = getelementptr inbounds double, ptr %391, i64 2
  %401 = load double, ptr %400, align 8
  br label %402

402:                                              ; preds = %402, %389
  %403 = phi i64 [ 0, %389 ], [ %427, %402 ]
  %404 = phi double [ 0.000000e+00, %389 ], [ %426, %402 ]
  %405 = getelementptr inbounds [3 x double], ptr %15, i64 %403
  %406 = load double, ptr %405, align 8
  %407 = fsub double %406, %392
  %408 = getelementptr inbounds [3 x double], ptr %15, i64 %403, i64 1
  %409 = load double, ptr %408, align 8
  %410 = fsub double %409, %394
  %411 = getelementptr inbounds [3 x double], ptr %15, i64 %403, i64 2
  %412 = load double, ptr %411, align 8
  %413 = fsub double %412, %396
  %414 = fmul double %397, %407
  %415 = fmul double %399, %410
  %416 = fadd double %414, %415
  %417 = fmul double %401, %413
  %418 = fadd double %416, %417
  %419 = fmul double %407, %407
  %420 = fmul double %410, %410
  %421 = fadd double %419, %420
  %422 = fmul double %413, %413
  %423 = fadd double %421, %422
  %424 = fmul double %418, %418
  %425 = fsub double %423, %424
  %426 = tail call double @llvm.maxnum.f64(double %404, double %425)
  %427 = add nuw nsw i64 %403, 1
  %428 = icmp eq i64 %427, 8
  br i1 %428, label %429, label %402

429:                                              ; preds = %402
  %430 = tail call double @llvm.sqrt.f64(double %426)
  %431 = load ptr, ptr %49, align 8
  %432 = getelementptr inbounds double, ptr %431, i64 %58
  %433 = load double, ptr %432, align 8
  %434 = fadd double %430, %433
  %435 = fadd double %379, %434
  store double %435, ptr %385, align 8
  br label %436

436:                                              ; preds = %378, %429
  %437 = phi double [ %435, %429 ], [ 1.000000e+00, %378 ]
  %438 = fmul double %384, %437
  %439 = fadd double %379, %438
  %440 = getelementptr inbounds i64, ptr %376, i64 %381
  %441 = load i64, ptr %440, align 8
  %442 = getelementptr inbounds double, ptr %62, i64 %441
  store double %439, ptr %442, align 8
  %443 = icmp sgt i64 %441, 0
  br i1 %443, label %378, label %377

444:                                              ; preds = %377, %369
  %445 = icmp eq i64 %324, %288
  br i1 %445, label %453, label %446

446:                                              ; preds = %444
  %447 = load ptr, ptr %31, align 8
  %448 = getelementptr inbounds [64 x i64], ptr %16, i64 0, i64 %288
  %449 = load i64, ptr %448, align 8
  %450 = add nsw i64 %449, -1
  %451 = getelementptr inbounds i64, ptr %447, i64 %450
  %452 = load i64, ptr %451, align 8
  br label %453

453:                                              ; preds = %444, %446
  %454 = phi i64 [ %452, %446 ], [ %60, %444 ]
  %455 = getelementptr inbounds double, ptr %62, i64 %454
  %456 = load double, ptr %455, align 8
  %457 = getelementptr inbounds double, ptr %8, i64 %54
  store double %456, ptr %457, align 8
  %458 = icmp sgt i64 %288, 0
  br i1 %458, label %459, label %462

459:                                              ; preds = %453
  %460 = mul nsw i64 %275, %17
  %461 = load ptr, ptr %32, align 8
  br label %463

462:                                              ; preds = %524, %453
  br i1 %50, label %566, label %530

463:                                              ; preds = %459, %524
  %464 = phi i64 [ %288, %459 ], [ %466, %524 ]
  %465 = phi double [ %456, %459 ], [ %528, %524 ]
  %466 = add nsw i64 %464, -1
  %467 = getelementptr inbounds [64 x i64], ptr %16, i64 0, i64 %466
  %468 = load i64, ptr %467, align 8
  %469 = add i64 %468, -1
  %470 = add i64 %469, %460
  %471 = getelementptr inbounds double, ptr %2, i64 %470
  %472 = load double, ptr %471, align 8
  %473 = getelementptr inbounds double, ptr %63, i64 %468
  store double 1.000000e+00, ptr %473, align 8
  %474 = getelementptr inbounds i64, ptr %461, i64 %469
  %475 = load i64, ptr %474, align 8
  %476 = icmp eq i64 %475, 0
  br i1 %476, label %477, label %524

477:                                              ; preds = %463
  %478 = getelementptr inbounds [12 x double], ptr %13, i64 %468, i64 9
  %479 = getelementptr inbounds [3 x double], ptr %14, i64 %468
  %480 = load double, ptr %478, align 8
  %481 = getelementptr inbounds [12 x double], ptr %13, i64 %468, i64 10
  %482 = load double, ptr %481, align 16
  %483 = getelementptr inbounds [12 x double], ptr %13, i64 %468, i64 11
  %484 = load double, ptr %483, align 8
  %485 = load double, ptr %479, align 8
  %486 = getelementptr inbounds double, ptr %479, i64 1
  %487 = load double, ptr %486, align 8
  %488 = getelementptr inbounds double, ptr %479, i64 2
  %489 = load double, ptr %488, align 8
  br label %490

490:                                              ; preds = %490, %477
  %491 = phi i64 [ 0, %477 ], [ %515, %490 ]
  %492 = phi double [ 0.000000e+00, %477 ], [ %514, %490 ]
  %493 = getelementptr inbounds [3 x double], ptr %15, i64 %491
  %494 = load double, ptr %493, align 8
  %495 = fsub double %494, %480
  %496 = getelementptr inbounds [3 x double], ptr %15, i64 %491, i64 1
  %497 = load double, ptr %496, align 8
  %498 = fsub double %497, %482
  %499 = getelementptr inbounds [3 x double], ptr %15, i64 %491, i64 2
  %500 = load double, ptr %499, align 8
  %501 = fsub double %500, %484
  %502 = fmul double %485, %495
  %503 = fmul double %487, %498
  %504 = fadd double %502, %503
  %505 = fmul double %489, %501
  %506 = fadd double %504, %505
  %507 = fmul double %495, %495
  %508 = fmul double %498, %498
  %509 = fadd double %507, %508
  %510 = fmul double %501, %501
  %511 = fadd double %509, %510
  %512 = fmul double %506, %506
  %513 = fsub double %511, %512
  %514 = tail call double @llvm.maxnum.f64(double %492, double %513)
  %515 = add nuw nsw i64 %491, 1
  %516 = icmp eq i64 %515, 8
  br i1 %516, label %517, label %490

517:                                              ; preds = %490
  %518 = tail call double @llvm.sqrt.f64(double %514)
  %519 = load ptr, ptr %49, align 8
  %520 = getelementptr inbounds double, ptr %519, i64 %58
  %521 = load double, ptr %520, align 8
  %522 = fadd double %518, %521
  %523 = fadd double %465, %522
  store double %523, ptr %473, align 8
  br label %524

524:                                              ; preds = %463, %517
  %525 = phi double [ %523, %517 ], [ 1.000000e+00, %463 ]
  %526 = fmul double %472, %525
  %527 = load double, ptr %457, align 8
  %528 = fadd double %527, %526
  store double %528, ptr %457, align 8
  %529 = icmp sgt i64 %464, 1
  br i1 %529, label %463, label %462

530:                                              ; preds = %462
  %531 = mul nsw i64 %275, %17
  %532 = getelementptr inbounds double, ptr %3, i64 %531
  %533 = getelementptr inbounds double, ptr %4, i64 %531
  %534 = icmp sgt i64 %324, 0
  br i1 %534, label %535, label %563

535:                                              ; preds = %530
  %536 = load ptr, ptr %32, align 8
  br label %537

537:                                              ; preds = %537, %535
  %538 = phi double [ 0.000000e+00, %535 ], [ %559, %537 ]
  %539 = phi double [ 0.000000e+00, %535 ], [ %560, %537 ]
  %540 = phi i64 [ 0, %535 ], [ %561, %537 ]
  %541 = getelementptr inbounds i64, ptr %16, i64 %540
  %542 = load i64, ptr %541, align 8
  %543 = add nsw i64 %542, -1
  %544 = getelementptr inbounds double, ptr %532, i64 %543
  %545 = load double, ptr %544, align 8
  %546 = getelementptr inbounds i64, ptr %536, i64 %543
  %547 = load i64, ptr %546, align 8
  %548 = icmp eq i64 %547, 0
  %549 = select i1 %548, double %545, double 0.000000e+00
  %550 = getelementptr inbounds double, ptr %63, i64 %542
  %551 = load double, ptr %550, align 8
  %552 = fmul double %539, 2.000000e+00
  %553 = fadd double %552, %549
  %554 = fmul double %545, %553
  %555 = getelementptr inbounds double, ptr %533, i64 %543
  %556 = load double, ptr %555, align 8
  %557 = fadd double %556, %554
  %558 = fmul double %551, %557
  %559 = fadd double %538, %558
  %560 = fadd double %539, %549
  %561 = add nuw nsw i64 %540, 1
  %562 = icmp eq i64 %561, %324
  br i1 %562, label %563, label %537

563:                                              ; preds = %537, %530
  %564 = phi double [ 0.000000e+00, %530 ], [ %559, %537 ]
  %565 = getelementptr inbounds double, ptr %9, i64 %54
  store double %564, ptr %565, align 8
  br label %566

566:                                              ; preds = %563, %462
  %567 = add nuw nsw i64 %54, 1
  %568 = icmp eq i64 %567, %7
  br i1 %568, label %51, label %52
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.memcpy.p0.p0.i64(ptr noalias nocapture writeonly, ptr noalias nocapture readonly, i64, i1 immarg) #2

declare double @llvm.sin.f64(double) #3

declare double @llvm.cos.f64(double) #3

declare double @llvm.maxnum.f64(double, double) #3

declare double @llvm.sqrt.f64(double) #3

attributes #0 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #3 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #4 = { nounwind }


