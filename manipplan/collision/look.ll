; look.c 4188b8ffc43031a4d4aaf3585d716ae427abf0fdba723a8be67e3b3f921d2293: written by make kernel

%struct.Look = type { i64, i64, i64, ptr, ptr, i64, i64, ptr, double, double, double, double, i64, ptr, ptr, ptr, ptr, i64, ptr, ptr, ptr, i64, ptr, ptr }
%struct.Dips = type { i64, ptr, ptr, double, ptr, ptr, double, double, i64 }
%struct.Bracket = type { double, double, double, double, double, double, double, double, i64 }
%struct.Found = type { double, double, i64, i64 }

define dso_local i64 @manipplan_look(ptr nocapture noundef readonly %0, ptr noundef %1, double noundef %2, ptr noundef %3) local_unnamed_addr #0 {
  %5 = load i64, ptr %1, align 8
  switch i64 %5, label %6 [
    i64 0, label %12
    i64 1, label %9
  ]

6:                                                ; preds = %4
  %7 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 21
  %8 = load i64, ptr %7, align 8
  br label %446

9:                                                ; preds = %4
  %10 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  %11 = load i64, ptr %10, align 8
  br label %87

12:                                               ; preds = %4
  %13 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 5
  %14 = load i64, ptr %13, align 8
  %15 = icmp sgt i64 %14, 0
  br i1 %15, label %16, label %23

16:                                               ; preds = %12
  %17 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 8
  %18 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 6
  %19 = load i64, ptr %18, align 8
  %20 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 11
  %21 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 16
  %22 = load ptr, ptr %21, align 8
  br label %57

23:                                               ; preds = %57, %12
  %24 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 2
  %25 = load ptr, ptr %24, align 8
  %26 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 1
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 7
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 3
  %31 = load double, ptr %30, align 8
  %32 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 15
  %33 = load ptr, ptr %32, align 8
  %34 = tail call i64 %25(ptr noundef %27, ptr noundef %29, i64 noundef %14, double noundef %31, ptr noundef %33) #6
  %35 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 4
  %36 = load ptr, ptr %35, align 8
  %37 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 4
  %38 = load ptr, ptr %37, align 8
  %39 = load ptr, ptr %32, align 8
  %40 = load i64, ptr %13, align 8
  %41 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 16
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 17
  %44 = load i64, ptr %43, align 8
  %45 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 18
  %46 = load ptr, ptr %45, align 8
  %47 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %48 = load ptr, ptr %47, align 8
  %49 = tail call i64 %36(ptr noundef %38, ptr noundef %39, i64 noundef %40, ptr noundef %42, i64 noundef %44, ptr noundef %46, ptr noundef %48) #6
  %50 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  store i64 %49, ptr %50, align 8
  %51 = icmp slt i64 %49, 1
  %52 = load i64, ptr %43, align 8
  %53 = icmp sgt i64 %49, %52
  %54 = select i1 %51, i1 true, i1 %53
  br i1 %54, label %82, label %55

55:                                               ; preds = %23
  %56 = load ptr, ptr %47, align 8
  br label %72

57:                                               ; preds = %57, %16
  %58 = phi i64 [ 0, %16 ], [ %70, %57 ]
  %59 = load double, ptr %17, align 8
  %60 = srem i64 %58, %19
  %61 = icmp eq i64 %60, 0
  %62 = load double, ptr %20, align 8
  %63 = fcmp olt double %62, %2
  %64 = select i1 %61, i1 %63, i1 false
  %65 = select i1 %64, double %2, double %62
  %66 = fadd double %59, %65
  %67 = fcmp ogt double %66, 0.000000e+00
  %68 = select i1 %67, double %66, double 0.000000e+00
  %69 = getelementptr inbounds double, ptr %22, i64 %58
  store double %68, ptr %69, align 8
  %70 = add nuw nsw i64 %58, 1
  %71 = icmp eq i64 %70, %14
  br i1 %71, label %23, label %57

72:                                               ; preds = %72, %55
  %73 = phi i64 [ 0, %55 ], [ %80, %72 ]
  %74 = phi i32 [ 1, %55 ], [ %79, %72 ]
  %75 = getelementptr inbounds double, ptr %56, i64 %73
  %76 = load double, ptr %75, align 8
  %77 = fcmp ord double %76, 0.000000e+00
  %78 = zext i1 %77 to i32
  %79 = and i32 %74, %78
  %80 = add nuw nsw i64 %73, 1
  %81 = icmp eq i64 %80, %49
  br i1 %81, label %82, label %72

82:                                               ; preds = %72, %23
  %83 = phi i32 [ 1, %23 ], [ %79, %72 ]
  %84 = icmp sgt i64 %49, %52
  br i1 %84, label %665, label %85

85:                                               ; preds = %82
  store i64 1, ptr %1, align 8
  %86 = icmp eq i32 %83, 0
  br i1 %86, label %665, label %87

87:                                               ; preds = %9, %85
  %88 = phi i64 [ %11, %9 ], [ %49, %85 ]
  %89 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  %90 = icmp sgt i64 %88, 0
  br i1 %90, label %92, label %91

91:                                               ; preds = %87
  store i64 0, ptr %89, align 8
  br label %180

92:                                               ; preds = %87
  %93 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %94 = load ptr, ptr %93, align 8
  %95 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 16
  %96 = load ptr, ptr %95, align 8
  %97 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 18
  %98 = load ptr, ptr %97, align 8
  %99 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 2
  %100 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 6
  br label %103

101:                                              ; preds = %125
  store i64 %127, ptr %89, align 8
  %102 = icmp sgt i64 %127, 0
  br i1 %102, label %130, label %180

103:                                              ; preds = %125, %92
  %104 = phi i64 [ %88, %92 ], [ %126, %125 ]
  %105 = phi i64 [ 0, %92 ], [ %127, %125 ]
  %106 = phi i64 [ 0, %92 ], [ %128, %125 ]
  %107 = getelementptr inbounds double, ptr %94, i64 %106
  %108 = load double, ptr %107, align 8
  %109 = getelementptr inbounds i64, ptr %98, i64 %106
  %110 = load i64, ptr %109, align 8
  %111 = load i64, ptr %99, align 8
  %112 = sdiv i64 %110, %111
  %113 = getelementptr inbounds double, ptr %96, i64 %112
  %114 = load double, ptr %113, align 8
  %115 = fcmp ult double %108, %114
  br i1 %115, label %116, label %125

116:                                              ; preds = %103
  %117 = getelementptr inbounds i64, ptr %98, i64 %105
  store i64 %110, ptr %117, align 8
  %118 = load double, ptr %100, align 8
  %119 = fdiv double %108, %118
  %120 = tail call double @llvm.rint.f64(double %119)
  %121 = fmul double %118, %120
  %122 = add nsw i64 %105, 1
  %123 = getelementptr inbounds double, ptr %94, i64 %105
  store double %121, ptr %123, align 8
  %124 = load i64, ptr %89, align 8
  br label %125

125:                                              ; preds = %116, %103
  %126 = phi i64 [ %104, %103 ], [ %124, %116 ]
  %127 = phi i64 [ %105, %103 ], [ %122, %116 ]
  %128 = add nuw nsw i64 %106, 1
  %129 = icmp slt i64 %128, %126
  br i1 %129, label %103, label %101

130:                                              ; preds = %101, %175
  %131 = phi i64 [ %176, %175 ], [ 0, %101 ]
  %132 = getelementptr inbounds i64, ptr %98, i64 %131
  %133 = load i64, ptr %132, align 8
  %134 = load i64, ptr %99, align 8
  %135 = sdiv i64 %133, %134
  %136 = icmp slt i64 %131, %127
  br i1 %136, label %137, label %175

137:                                              ; preds = %130, %143
  %138 = phi i64 [ %144, %143 ], [ %131, %130 ]
  %139 = getelementptr inbounds i64, ptr %98, i64 %138
  %140 = load i64, ptr %139, align 8
  %141 = sdiv i64 %140, %134
  %142 = icmp eq i64 %141, %135
  br i1 %142, label %143, label %146

143:                                              ; preds = %137
  %144 = add i64 %138, 1
  %145 = icmp eq i64 %144, %127
  br i1 %145, label %146, label %137

146:                                              ; preds = %143, %137
  %147 = phi i64 [ %138, %137 ], [ %127, %143 ]
  %148 = add nsw i64 %131, 1
  %149 = icmp slt i64 %148, %147
  br i1 %149, label %150, label %175

150:                                              ; preds = %146, %169
  %151 = phi i64 [ %173, %169 ], [ %148, %146 ]
  %152 = getelementptr inbounds i64, ptr %98, i64 %151
  %153 = load i64, ptr %152, align 8
  %154 = getelementptr inbounds double, ptr %94, i64 %151
  %155 = load double, ptr %154, align 8
  %156 = icmp sgt i64 %151, %131
  br i1 %156, label %157, label %169

157:                                              ; preds = %150, %163
  %158 = phi i64 [ %159, %163 ], [ %151, %150 ]
  %159 = add nsw i64 %158, -1
  %160 = getelementptr inbounds i64, ptr %98, i64 %159
  %161 = load i64, ptr %160, align 8
  %162 = icmp sgt i64 %161, %153
  br i1 %162, label %163, label %169

163:                                              ; preds = %157
  %164 = getelementptr inbounds i64, ptr %98, i64 %158
  store i64 %161, ptr %164, align 8
  %165 = getelementptr inbounds double, ptr %94, i64 %159
  %166 = load double, ptr %165, align 8
  %167 = getelementptr inbounds double, ptr %94, i64 %158
  store double %166, ptr %167, align 8
  %168 = icmp sgt i64 %159, %131
  br i1 %168, label %157, label %169

169:                                              ; preds = %163, %157, %150
  %170 = phi i64 [ %151, %150 ], [ %131, %163 ], [ %158, %157 ]
  %171 = getelementptr inbounds i64, ptr %98, i64 %170
  store i64 %153, ptr %171, align 8
  %172 = getelementptr inbounds double, ptr %94, i64 %170
  store double %155, ptr %172, align 8
  %173 = add nsw i64 %151, 1
  %174 = icmp eq i64 %173, %147
  br i1 %174, label %175, label %150

175:                                              ; preds = %169, %146, %130
  %176 = phi i64 [ %147, %146 ], [ %131, %130 ], [ %147, %169 ]
  %177 = icmp slt i64 %176, %127
  br i1 %177, label %130, label %178

178:                                              ; preds = %175
  %179 = load i64, ptr %89, align 8
  br label %180

180:                                              ; preds = %178, %91, %101
  %181 = phi i64 [ %179, %178 ], [ 0, %91 ], [ %127, %101 ]
  %182 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 8
  %183 = load double, ptr %182, align 8
  %184 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 11
  %185 = load double, ptr %184, align 8
  %186 = fadd double %183, %185
  %187 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 5
  %188 = load i64, ptr %187, align 8
  %189 = add nsw i64 %188, -1
  %190 = sitofp i64 %189 to double
  %191 = fdiv double 1.000000e+00, %190
  %192 = icmp sgt i64 %181, 0
  br i1 %192, label %193, label %202

193:                                              ; preds = %180
  %194 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 18
  %195 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 2
  %196 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %197 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 10
  %198 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 7
  %199 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %200 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  %201 = load ptr, ptr %194, align 8
  br label %212

202:                                              ; preds = %325, %180
  %203 = phi i64 [ 0, %180 ], [ %328, %325 ]
  %204 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 12
  %205 = load i64, ptr %204, align 8
  %206 = icmp sgt i64 %205, 0
  br i1 %206, label %207, label %331

207:                                              ; preds = %202
  %208 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 13
  %209 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %210 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 14
  %211 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  br label %343

212:                                              ; preds = %325, %193
  %213 = phi i64 [ %181, %193 ], [ %326, %325 ]
  %214 = phi ptr [ %201, %193 ], [ %327, %325 ]
  %215 = phi i64 [ 0, %193 ], [ %328, %325 ]
  %216 = phi i64 [ 0, %193 ], [ %329, %325 ]
  %217 = phi i64 [ 0, %193 ], [ %274, %325 ]
  %218 = phi i64 [ 0, %193 ], [ %248, %325 ]
  %219 = getelementptr inbounds i64, ptr %214, i64 %216
  %220 = load i64, ptr %219, align 8
  %221 = load i64, ptr %195, align 8
  %222 = sdiv i64 %220, %221
  %223 = load i64, ptr %187, align 8
  %224 = add nsw i64 %223, -1
  %225 = load ptr, ptr %196, align 8
  %226 = getelementptr inbounds double, ptr %225, i64 %216
  %227 = load double, ptr %226, align 8
  %228 = tail call double @llvm.minnum.f64(double %227, double %186)
  %229 = icmp sgt i64 %222, 0
  br i1 %229, label %230, label %247

230:                                              ; preds = %212
  %231 = sub nsw i64 %220, %221
  %232 = icmp slt i64 %218, %216
  br i1 %232, label %233, label %247

233:                                              ; preds = %230, %238
  %234 = phi i64 [ %239, %238 ], [ %218, %230 ]
  %235 = getelementptr inbounds i64, ptr %214, i64 %234
  %236 = load i64, ptr %235, align 8
  %237 = icmp slt i64 %236, %231
  br i1 %237, label %238, label %241

238:                                              ; preds = %233
  %239 = add i64 %234, 1
  %240 = icmp eq i64 %239, %216
  br i1 %240, label %247, label %233

241:                                              ; preds = %233
  %242 = icmp eq i64 %236, %231
  br i1 %242, label %243, label %247

243:                                              ; preds = %241
  %244 = getelementptr inbounds double, ptr %225, i64 %234
  %245 = load double, ptr %244, align 8
  %246 = tail call double @llvm.minnum.f64(double %245, double %186)
  br label %247

247:                                              ; preds = %238, %243, %241, %230, %212
  %248 = phi i64 [ %218, %212 ], [ %234, %243 ], [ %234, %241 ], [ %218, %230 ], [ %216, %238 ]
  %249 = phi double [ 0xFFF0000000000000, %212 ], [ %246, %243 ], [ %186, %241 ], [ %186, %230 ], [ %186, %238 ]
  %250 = phi double [ 0x7FF0000000000000, %212 ], [ %246, %243 ], [ %186, %241 ], [ %186, %230 ], [ %186, %238 ]
  %251 = icmp slt i64 %222, %224
  br i1 %251, label %252, label %273

252:                                              ; preds = %247
  %253 = add nsw i64 %221, %220
  %254 = icmp slt i64 %217, %213
  br i1 %254, label %255, label %269

255:                                              ; preds = %252, %260
  %256 = phi i64 [ %261, %260 ], [ %217, %252 ]
  %257 = getelementptr inbounds i64, ptr %214, i64 %256
  %258 = load i64, ptr %257, align 8
  %259 = icmp slt i64 %258, %253
  br i1 %259, label %260, label %263

260:                                              ; preds = %255
  %261 = add i64 %256, 1
  %262 = icmp eq i64 %261, %213
  br i1 %262, label %269, label %255

263:                                              ; preds = %255
  %264 = icmp eq i64 %258, %253
  br i1 %264, label %265, label %269

265:                                              ; preds = %263
  %266 = getelementptr inbounds double, ptr %225, i64 %256
  %267 = load double, ptr %266, align 8
  %268 = tail call double @llvm.minnum.f64(double %267, double %186)
  br label %269

269:                                              ; preds = %260, %265, %263, %252
  %270 = phi i64 [ %256, %265 ], [ %256, %263 ], [ %217, %252 ], [ %213, %260 ]
  %271 = phi double [ %268, %265 ], [ %186, %263 ], [ %186, %252 ], [ %186, %260 ]
  %272 = tail call double @llvm.maxnum.f64(double %249, double %271)
  br label %273

273:                                              ; preds = %269, %247
  %274 = phi i64 [ %270, %269 ], [ %217, %247 ]
  %275 = phi double [ %272, %269 ], [ %249, %247 ]
  %276 = phi double [ %271, %269 ], [ 0x7FF0000000000000, %247 ]
  %277 = fcmp oge double %250, %228
  %278 = fcmp ogt double %276, %228
  %279 = select i1 %277, i1 %278, i1 false
  br i1 %279, label %280, label %325

280:                                              ; preds = %273
  %281 = fsub double %275, %228
  %282 = fsub double %228, %281
  %283 = load double, ptr %182, align 8
  %284 = load double, ptr %197, align 8
  %285 = fadd double %283, %284
  %286 = fcmp olt double %282, %285
  br i1 %286, label %287, label %325

287:                                              ; preds = %280
  %288 = load ptr, ptr %198, align 8
  %289 = add nsw i64 %222, -1
  %290 = select i1 %229, i64 %289, i64 0
  %291 = getelementptr inbounds double, ptr %288, i64 %290
  %292 = load double, ptr %291, align 8
  %293 = getelementptr inbounds double, ptr %288, i64 %222
  %294 = load double, ptr %293, align 8
  %295 = add nsw i64 %222, 1
  %296 = select i1 %251, i64 %295, i64 %224
  %297 = getelementptr inbounds double, ptr %288, i64 %296
  %298 = load double, ptr %297, align 8
  %299 = icmp eq i64 %222, 0
  %300 = fcmp olt double %250, %186
  %301 = select i1 %300, double %250, double 0x7FF8000000000000
  %302 = select i1 %299, double %228, double %301
  %303 = icmp eq i64 %222, %224
  %304 = fcmp olt double %276, %186
  %305 = select i1 %304, double %276, double 0x7FF8000000000000
  %306 = select i1 %303, double %228, double %305
  %307 = load ptr, ptr %199, align 8
  %308 = getelementptr inbounds %struct.Bracket, ptr %307, i64 %215
  store double %292, ptr %308, align 8
  %309 = getelementptr inbounds i8, ptr %308, i64 8
  store double %294, ptr %309, align 8
  %310 = getelementptr inbounds i8, ptr %308, i64 16
  store double %298, ptr %310, align 8
  %311 = getelementptr inbounds i8, ptr %308, i64 24
  store double %302, ptr %311, align 8
  %312 = getelementptr inbounds i8, ptr %308, i64 32
  store double %228, ptr %312, align 8
  %313 = getelementptr inbounds i8, ptr %308, i64 40
  store double %306, ptr %313, align 8
  %314 = getelementptr inbounds i8, ptr %308, i64 48
  store double 0x7FF8000000000000, ptr %314, align 8
  %315 = getelementptr inbounds i8, ptr %308, i64 56
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %315, i8 0, i64 16, i1 false)
  %316 = load ptr, ptr %194, align 8
  %317 = getelementptr inbounds i64, ptr %316, i64 %216
  %318 = load i64, ptr %317, align 8
  %319 = load i64, ptr %195, align 8
  %320 = srem i64 %318, %319
  %321 = load ptr, ptr %200, align 8
  %322 = add nsw i64 %215, 1
  %323 = getelementptr inbounds i64, ptr %321, i64 %215
  store i64 %320, ptr %323, align 8
  %324 = load i64, ptr %89, align 8
  br label %325

325:                                              ; preds = %287, %280, %273
  %326 = phi i64 [ %324, %287 ], [ %213, %280 ], [ %213, %273 ]
  %327 = phi ptr [ %316, %287 ], [ %214, %280 ], [ %214, %273 ]
  %328 = phi i64 [ %322, %287 ], [ %215, %280 ], [ %215, %273 ]
  %329 = add nuw nsw i64 %216, 1
  %330 = icmp slt i64 %329, %326
  br i1 %330, label %212, label %202

331:                                              ; preds = %343, %202
  %332 = phi i64 [ %203, %202 ], [ %366, %343 ]
  %333 = icmp sgt i64 %332, 0
  br i1 %333, label %336, label %334

334:                                              ; preds = %331
  %335 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 21
  store i64 %332, ptr %335, align 8
  store i64 2, ptr %1, align 8
  br label %394

336:                                              ; preds = %331
  %337 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 3
  %338 = load ptr, ptr %337, align 8
  %339 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  %340 = load ptr, ptr %339, align 8
  %341 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 23
  %342 = load ptr, ptr %341, align 8
  br label %371

343:                                              ; preds = %343, %207
  %344 = phi i64 [ %203, %207 ], [ %366, %343 ]
  %345 = phi i64 [ 0, %207 ], [ %368, %343 ]
  %346 = load ptr, ptr %208, align 8
  %347 = getelementptr inbounds double, ptr %346, i64 %345
  %348 = load double, ptr %347, align 8
  %349 = fsub double %348, %191
  %350 = tail call double @llvm.maxnum.f64(double %349, double 0.000000e+00)
  %351 = fadd double %191, %348
  %352 = tail call double @llvm.minnum.f64(double %351, double 1.000000e+00)
  %353 = load ptr, ptr %209, align 8
  %354 = getelementptr inbounds %struct.Bracket, ptr %353, i64 %344
  store double %350, ptr %354, align 8
  %355 = getelementptr inbounds i8, ptr %354, i64 8
  store double %348, ptr %355, align 8
  %356 = getelementptr inbounds i8, ptr %354, i64 16
  store double %352, ptr %356, align 8
  %357 = getelementptr inbounds i8, ptr %354, i64 24
  store double 0x7FF8000000000000, ptr %357, align 8
  %358 = getelementptr inbounds i8, ptr %354, i64 32
  store double 0x7FF8000000000000, ptr %358, align 8
  %359 = getelementptr inbounds i8, ptr %354, i64 40
  store double 0x7FF8000000000000, ptr %359, align 8
  %360 = getelementptr inbounds i8, ptr %354, i64 48
  store double 0x7FF8000000000000, ptr %360, align 8
  %361 = getelementptr inbounds i8, ptr %354, i64 56
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %361, i8 0, i64 16, i1 false)
  %362 = load ptr, ptr %210, align 8
  %363 = getelementptr inbounds i64, ptr %362, i64 %345
  %364 = load i64, ptr %363, align 8
  %365 = load ptr, ptr %211, align 8
  %366 = add nsw i64 %344, 1
  %367 = getelementptr inbounds i64, ptr %365, i64 %344
  store i64 %364, ptr %367, align 8
  %368 = add nuw nsw i64 %345, 1
  %369 = load i64, ptr %204, align 8
  %370 = icmp slt i64 %368, %369
  br i1 %370, label %343, label %331

371:                                              ; preds = %371, %336
  %372 = phi i64 [ 0, %336 ], [ %387, %371 ]
  %373 = getelementptr inbounds i64, ptr %340, i64 %372
  %374 = shl nuw nsw i64 %372, 1
  %375 = load i64, ptr %373, align 8
  %376 = shl nsw i64 %375, 1
  %377 = getelementptr inbounds i64, ptr %338, i64 %376
  %378 = load i64, ptr %377, align 8
  %379 = getelementptr inbounds i64, ptr %342, i64 %374
  store i64 %378, ptr %379, align 8
  %380 = load i64, ptr %373, align 8
  %381 = shl nsw i64 %380, 1
  %382 = or i64 %381, 1
  %383 = getelementptr inbounds i64, ptr %338, i64 %382
  %384 = load i64, ptr %383, align 8
  %385 = or i64 %374, 1
  %386 = getelementptr inbounds i64, ptr %342, i64 %385
  store i64 %384, ptr %386, align 8
  %387 = add nuw nsw i64 %372, 1
  %388 = icmp eq i64 %387, %332
  br i1 %388, label %389, label %371

389:                                              ; preds = %371
  %390 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 21
  store i64 %332, ptr %390, align 8
  store i64 2, ptr %1, align 8
  br i1 %333, label %391, label %394

391:                                              ; preds = %389
  %392 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %393 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 23
  br label %398

394:                                              ; preds = %334, %389
  %395 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  br label %585

396:                                              ; preds = %438
  %397 = icmp eq i64 %442, 0
  br i1 %397, label %446, label %665

398:                                              ; preds = %391, %438
  %399 = phi i64 [ 0, %391 ], [ %442, %438 ]
  %400 = phi i64 [ 0, %391 ], [ %443, %438 ]
  %401 = load ptr, ptr %392, align 8
  %402 = getelementptr inbounds %struct.Bracket, ptr %401, i64 %400
  %403 = load ptr, ptr %393, align 8
  %404 = shl nuw nsw i64 %400, 1
  %405 = getelementptr inbounds i64, ptr %403, i64 %404
  %406 = getelementptr inbounds %struct.Bracket, ptr %401, i64 %400, i32 4
  %407 = load double, ptr %406, align 8
  %408 = fcmp uno double %407, 0.000000e+00
  br i1 %408, label %409, label %413

409:                                              ; preds = %398
  %410 = getelementptr inbounds %struct.Bracket, ptr %401, i64 %400, i32 1
  %411 = load double, ptr %410, align 8
  %412 = tail call fastcc double @distance_at(ptr noundef %0, double noundef %411, ptr noundef %405)
  store double %412, ptr %406, align 8
  br label %413

413:                                              ; preds = %409, %398
  %414 = getelementptr inbounds %struct.Bracket, ptr %401, i64 %400, i32 3
  %415 = load double, ptr %414, align 8
  %416 = fcmp uno double %415, 0.000000e+00
  br i1 %416, label %417, label %420

417:                                              ; preds = %413
  %418 = load double, ptr %402, align 8
  %419 = tail call fastcc double @distance_at(ptr noundef %0, double noundef %418, ptr noundef %405)
  store double %419, ptr %414, align 8
  br label %420

420:                                              ; preds = %417, %413
  %421 = getelementptr inbounds %struct.Bracket, ptr %401, i64 %400, i32 5
  %422 = load double, ptr %421, align 8
  %423 = fcmp uno double %422, 0.000000e+00
  br i1 %423, label %424, label %428

424:                                              ; preds = %420
  %425 = getelementptr inbounds %struct.Bracket, ptr %401, i64 %400, i32 2
  %426 = load double, ptr %425, align 8
  %427 = tail call fastcc double @distance_at(ptr noundef %0, double noundef %426, ptr noundef %405)
  store double %427, ptr %421, align 8
  br label %428

428:                                              ; preds = %424, %420
  %429 = phi double [ %427, %424 ], [ %422, %420 ]
  %430 = load double, ptr %406, align 8
  %431 = fcmp uno double %430, 0.000000e+00
  br i1 %431, label %438, label %432

432:                                              ; preds = %428
  %433 = load double, ptr %414, align 8
  %434 = fcmp uno double %433, 0.000000e+00
  br i1 %434, label %438, label %435

435:                                              ; preds = %432
  %436 = fcmp ord double %429, 0.000000e+00
  %437 = zext i1 %436 to i32
  br label %438

438:                                              ; preds = %428, %432, %435
  %439 = phi i32 [ 0, %432 ], [ 0, %428 ], [ %437, %435 ]
  %440 = icmp eq i32 %439, 0
  %441 = zext i1 %440 to i64
  %442 = add nuw nsw i64 %399, %441
  %443 = add nuw nsw i64 %400, 1
  %444 = load i64, ptr %390, align 8
  %445 = icmp slt i64 %443, %444
  br i1 %445, label %398, label %396

446:                                              ; preds = %6, %396
  %447 = phi i64 [ %8, %6 ], [ %444, %396 ]
  %448 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 23
  %449 = load ptr, ptr %448, align 8
  %450 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %451 = load ptr, ptr %450, align 8
  %452 = icmp sgt i64 %447, 0
  br i1 %452, label %453, label %585

453:                                              ; preds = %446
  %454 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 8
  %455 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 7
  br label %456

456:                                              ; preds = %579, %453
  %457 = phi i64 [ 0, %453 ], [ %580, %579 ]
  %458 = phi i64 [ 0, %453 ], [ %581, %579 ]
  %459 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458
  %460 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 6
  %461 = load double, ptr %460, align 8
  %462 = fcmp uno double %461, 0.000000e+00
  br i1 %462, label %463, label %466

463:                                              ; preds = %456
  %464 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 8
  %465 = load i64, ptr %464, align 8
  br label %491

466:                                              ; preds = %456
  %467 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 7
  %468 = load double, ptr %467, align 8
  %469 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 4
  %470 = load double, ptr %469, align 8
  %471 = fcmp ogt double %470, %468
  %472 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 1
  %473 = load double, ptr %472, align 8
  %474 = fcmp olt double %473, %461
  %475 = select i1 %471, double %473, double %461
  br i1 %471, label %477, label %476

476:                                              ; preds = %466
  br i1 %474, label %481, label %478

477:                                              ; preds = %466
  br i1 %474, label %478, label %481

478:                                              ; preds = %477, %476
  %479 = phi double [ %468, %476 ], [ %470, %477 ]
  store double %475, ptr %459, align 8
  %480 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 3
  store double %479, ptr %480, align 8
  br label %485

481:                                              ; preds = %477, %476
  %482 = phi double [ %468, %476 ], [ %470, %477 ]
  %483 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 2
  store double %475, ptr %483, align 8
  %484 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 5
  store double %482, ptr %484, align 8
  br label %485

485:                                              ; preds = %481, %478
  br i1 %471, label %486, label %487

486:                                              ; preds = %485
  store double %461, ptr %472, align 8
  store double %468, ptr %469, align 8
  br label %487

487:                                              ; preds = %486, %485
  %488 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 8
  %489 = load i64, ptr %488, align 8
  %490 = add nsw i64 %489, 1
  store i64 %490, ptr %488, align 8
  store double 0x7FF8000000000000, ptr %460, align 8
  br label %491

491:                                              ; preds = %487, %463
  %492 = phi i64 [ %465, %463 ], [ %490, %487 ]
  %493 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 8
  %494 = load i64, ptr %454, align 8
  %495 = icmp slt i64 %492, %494
  br i1 %495, label %496, label %579

496:                                              ; preds = %491
  %497 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 2
  %498 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 1
  %499 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 3
  %500 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 4
  %501 = getelementptr inbounds %struct.Bracket, ptr %451, i64 %458, i32 5
  %502 = shl nuw nsw i64 %458, 1
  %503 = getelementptr inbounds i64, ptr %449, i64 %502
  br label %504

504:                                              ; preds = %574, %496
  %505 = phi i64 [ %492, %496 ], [ %576, %574 ]
  %506 = load double, ptr %497, align 8
  %507 = load double, ptr %459, align 8
  %508 = fsub double %506, %507
  %509 = load double, ptr %455, align 8
  %510 = fcmp ult double %508, %509
  br i1 %510, label %579, label %511

511:                                              ; preds = %504
  %512 = load double, ptr %498, align 8
  %513 = fsub double %512, %507
  %514 = fsub double %506, %512
  %515 = fcmp ogt double %513, %514
  %516 = fmul double %513, -5.000000e-01
  %517 = fmul double %514, 5.000000e-01
  %518 = select i1 %515, double %516, double %517
  %519 = load double, ptr %499, align 8
  %520 = load double, ptr %500, align 8
  %521 = fsub double %519, %520
  %522 = fdiv double %521, %513
  %523 = load double, ptr %501, align 8
  %524 = fsub double %523, %520
  %525 = fdiv double %524, %514
  %526 = fmul double %514, %522
  %527 = fmul double %513, %525
  %528 = fsub double %526, %527
  %529 = fadd double %522, %525
  %530 = fmul double %529, 2.000000e+00
  %531 = fdiv double %528, %530
  %532 = tail call double @llvm.fabs.f64(double %531) #7
  %533 = fcmp one double %532, 0x7FF0000000000000
  %534 = fneg double %513
  %535 = fcmp ogt double %531, %534
  %536 = select i1 %533, i1 %535, i1 false
  %537 = fcmp olt double %531, %514
  %538 = select i1 %536, i1 %537, i1 false
  br i1 %538, label %539, label %543

539:                                              ; preds = %511
  %540 = srem i64 %505, 3
  %541 = icmp slt i64 %540, 2
  %542 = select i1 %541, double %531, double %518
  br label %543

543:                                              ; preds = %539, %511
  %544 = phi double [ %518, %511 ], [ %542, %539 ]
  %545 = fadd double %513, %514
  %546 = fmul double %545, 2.000000e-02
  %547 = fmul double %509, 2.500000e-01
  %548 = tail call double @llvm.maxnum.f64(double %546, double %547)
  %549 = tail call double @llvm.fabs.f64(double %544)
  %550 = fcmp olt double %549, %548
  %551 = tail call double @llvm.copysign.f64(double %548, double %518)
  %552 = select i1 %550, double %551, double %544
  %553 = fadd double %512, %552
  %554 = tail call double @llvm.maxnum.f64(double %553, double %507)
  %555 = tail call double @llvm.minnum.f64(double %554, double %506)
  %556 = tail call fastcc double @distance_at(ptr noundef nonnull %0, double noundef %555, ptr noundef %503)
  %557 = fcmp uno double %556, 0.000000e+00
  br i1 %557, label %558, label %560

558:                                              ; preds = %543
  store double %555, ptr %460, align 8
  %559 = add nsw i64 %457, 1
  br label %579

560:                                              ; preds = %543
  %561 = load double, ptr %500, align 8
  %562 = fcmp ogt double %561, %556
  %563 = load double, ptr %498, align 8
  %564 = fcmp olt double %563, %555
  %565 = select i1 %562, double %563, double %555
  br i1 %562, label %567, label %566

566:                                              ; preds = %560
  br i1 %564, label %570, label %568

567:                                              ; preds = %560
  br i1 %564, label %568, label %570

568:                                              ; preds = %567, %566
  %569 = phi double [ %556, %566 ], [ %561, %567 ]
  store double %565, ptr %459, align 8
  store double %569, ptr %499, align 8
  br label %572

570:                                              ; preds = %567, %566
  %571 = phi double [ %556, %566 ], [ %561, %567 ]
  store double %565, ptr %497, align 8
  store double %571, ptr %501, align 8
  br label %572

572:                                              ; preds = %570, %568
  br i1 %562, label %573, label %574

573:                                              ; preds = %572
  store double %555, ptr %498, align 8
  store double %556, ptr %500, align 8
  br label %574

574:                                              ; preds = %573, %572
  %575 = load i64, ptr %493, align 8
  %576 = add nsw i64 %575, 1
  store i64 %576, ptr %493, align 8
  %577 = load i64, ptr %454, align 8
  %578 = icmp slt i64 %576, %577
  br i1 %578, label %504, label %579

579:                                              ; preds = %574, %504, %558, %491
  %580 = phi i64 [ %559, %558 ], [ %457, %491 ], [ %457, %504 ], [ %457, %574 ]
  %581 = add nuw nsw i64 %458, 1
  %582 = icmp eq i64 %581, %447
  br i1 %582, label %583, label %456

583:                                              ; preds = %579
  %584 = icmp eq i64 %580, 0
  br i1 %584, label %585, label %665

585:                                              ; preds = %394, %446, %583
  %586 = phi ptr [ %450, %583 ], [ %395, %394 ], [ %450, %446 ]
  %587 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 21
  %588 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  %589 = load i64, ptr %588, align 8
  %590 = icmp sgt i64 %589, 0
  br i1 %590, label %591, label %599

591:                                              ; preds = %585
  %592 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 18
  %593 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 2
  %594 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %595 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 8
  %596 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 9
  %597 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 6
  %598 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 7
  br label %605

599:                                              ; preds = %639, %585
  %600 = phi i64 [ 0, %585 ], [ %641, %639 ]
  %601 = load i64, ptr %587, align 8
  %602 = icmp sgt i64 %601, 0
  br i1 %602, label %603, label %644

603:                                              ; preds = %599
  %604 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  br label %646

605:                                              ; preds = %591, %639
  %606 = phi i64 [ %589, %591 ], [ %640, %639 ]
  %607 = phi i64 [ 0, %591 ], [ %641, %639 ]
  %608 = phi i64 [ 0, %591 ], [ %642, %639 ]
  %609 = load ptr, ptr %592, align 8
  %610 = getelementptr inbounds i64, ptr %609, i64 %608
  %611 = load i64, ptr %610, align 8
  %612 = load i64, ptr %593, align 8
  %613 = sdiv i64 %611, %612
  %614 = srem i64 %611, %612
  %615 = load ptr, ptr %594, align 8
  %616 = getelementptr inbounds double, ptr %615, i64 %608
  %617 = load double, ptr %616, align 8
  %618 = load double, ptr %595, align 8
  %619 = load double, ptr %596, align 8
  %620 = fadd double %618, %619
  %621 = fcmp olt double %617, %620
  br i1 %621, label %629, label %622

622:                                              ; preds = %605
  %623 = load i64, ptr %597, align 8
  %624 = srem i64 %613, %623
  %625 = icmp eq i64 %624, 0
  %626 = fadd double %618, %2
  %627 = fcmp olt double %617, %626
  %628 = select i1 %625, i1 %627, i1 false
  br i1 %628, label %629, label %639

629:                                              ; preds = %622, %605
  %630 = load ptr, ptr %598, align 8
  %631 = getelementptr inbounds double, ptr %630, i64 %613
  %632 = load double, ptr %631, align 8
  %633 = add nsw i64 %607, 1
  %634 = getelementptr inbounds %struct.Found, ptr %3, i64 %607
  store double %617, ptr %634, align 8
  %635 = getelementptr inbounds i8, ptr %634, i64 8
  store double %632, ptr %635, align 8
  %636 = getelementptr inbounds i8, ptr %634, i64 16
  store i64 %614, ptr %636, align 8
  %637 = getelementptr inbounds i8, ptr %634, i64 24
  store i64 0, ptr %637, align 8
  %638 = load i64, ptr %588, align 8
  br label %639

639:                                              ; preds = %622, %629
  %640 = phi i64 [ %638, %629 ], [ %606, %622 ]
  %641 = phi i64 [ %633, %629 ], [ %607, %622 ]
  %642 = add nuw nsw i64 %608, 1
  %643 = icmp slt i64 %642, %640
  br i1 %643, label %605, label %599

644:                                              ; preds = %646, %599
  %645 = phi i64 [ %600, %599 ], [ %657, %646 ]
  tail call void @qsort(ptr noundef %3, i64 noundef %645, i64 noundef 32, ptr noundef nonnull @order) #6
  br label %665

646:                                              ; preds = %603, %646
  %647 = phi i64 [ %600, %603 ], [ %657, %646 ]
  %648 = phi i64 [ 0, %603 ], [ %662, %646 ]
  %649 = load ptr, ptr %586, align 8
  %650 = getelementptr inbounds %struct.Bracket, ptr %649, i64 %648, i32 4
  %651 = load double, ptr %650, align 8
  %652 = getelementptr inbounds %struct.Bracket, ptr %649, i64 %648, i32 1
  %653 = load double, ptr %652, align 8
  %654 = load ptr, ptr %604, align 8
  %655 = getelementptr inbounds i64, ptr %654, i64 %648
  %656 = load i64, ptr %655, align 8
  %657 = add nsw i64 %647, 1
  %658 = getelementptr inbounds %struct.Found, ptr %3, i64 %647
  store double %651, ptr %658, align 8
  %659 = getelementptr inbounds i8, ptr %658, i64 8
  store double %653, ptr %659, align 8
  %660 = getelementptr inbounds i8, ptr %658, i64 16
  store i64 %656, ptr %660, align 8
  %661 = getelementptr inbounds i8, ptr %658, i64 24
  store i64 1, ptr %661, align 8
  %662 = add nuw nsw i64 %648, 1
  %663 = load i64, ptr %587, align 8
  %664 = icmp slt i64 %662, %663
  br i1 %664, label %646, label %644

665:                                              ; preds = %82, %583, %396, %85, %644
  %666 = phi i64 [ %645, %644 ], [ -1, %85 ], [ -1, %396 ], [ -1, %583 ], [ -2, %82 ]
  ret i64 %666
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

declare void @qsort(ptr noundef, i64 noundef, i64 noundef, ptr nocapture noundef) local_unnamed_addr #2

define internal i32 @order(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1) #3 {
  %3 = load double, ptr %0, align 8
  %4 = load double, ptr %1, align 8
  %5 = fcmp une double %3, %4
  br i1 %5, label %6, label %9

6:                                                ; preds = %2
  %7 = fcmp olt double %3, %4
  %8 = select i1 %7, i32 -1, i32 1
  br label %34

9:                                                ; preds = %2
  %10 = getelementptr inbounds %struct.Found, ptr %0, i64 0, i32 1
  %11 = load double, ptr %10, align 8
  %12 = getelementptr inbounds %struct.Found, ptr %1, i64 0, i32 1
  %13 = load double, ptr %12, align 8
  %14 = fcmp une double %11, %13
  br i1 %14, label %15, label %18

15:                                               ; preds = %9
  %16 = fcmp olt double %11, %13
  %17 = select i1 %16, i32 -1, i32 1
  br label %34

18:                                               ; preds = %9
  %19 = getelementptr inbounds %struct.Found, ptr %0, i64 0, i32 2
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr inbounds %struct.Found, ptr %1, i64 0, i32 2
  %22 = load i64, ptr %21, align 8
  %23 = icmp eq i64 %20, %22
  br i1 %23, label %27, label %24

24:                                               ; preds = %18
  %25 = icmp slt i64 %20, %22
  %26 = select i1 %25, i32 -1, i32 1
  br label %34

27:                                               ; preds = %18
  %28 = getelementptr inbounds %struct.Found, ptr %0, i64 0, i32 3
  %29 = load i64, ptr %28, align 8
  %30 = getelementptr inbounds %struct.Found, ptr %1, i64 0, i32 3
  %31 = load i64, ptr %30, align 8
  %32 = sub nsw i64 %29, %31
  %33 = trunc i64 %32 to i32
  br label %34

34:                                               ; preds = %27, %24, %15, %6
  %35 = phi i32 [ %8, %6 ], [ %17, %15 ], [ %26, %24 ], [ %33, %27 ]
  ret i32 %35
}

declare double @llvm.rint.f64(double) #4

declare double @llvm.minnum.f64(double, double) #4

declare double @llvm.maxnum.f64(double, double) #4

define internal fastcc double @distance_at(ptr nocapture noundef readonly %0, double noundef %1, ptr noundef %2) unnamed_addr #0 {
  %4 = alloca double, align 8
  %5 = alloca double, align 8
  %6 = alloca double, align 8
  %7 = alloca i64, align 8
  store double %1, ptr %4, align 8
  %8 = load i64, ptr %0, align 8
  %9 = alloca double, i64 %8, align 16
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %5) #6
  store double 0x7FF0000000000000, ptr %5, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %6) #6
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %7) #6
  %10 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 2
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 1
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 3
  %15 = load double, ptr %14, align 8
  %16 = call i64 %11(ptr noundef %13, ptr noundef nonnull %4, i64 noundef 1, double noundef %15, ptr noundef nonnull %9) #6
  %17 = icmp eq i64 %16, 0
  br i1 %17, label %18, label %29

18:                                               ; preds = %3
  %19 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 5
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 4
  %22 = load ptr, ptr %21, align 8
  call void %20(ptr noundef %22, ptr noundef nonnull %9, i64 noundef 1, ptr noundef %2, ptr noundef nonnull %5, ptr noundef nonnull %6, ptr noundef nonnull %7) #6
  %23 = load double, ptr %6, align 8
  %24 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 6
  %25 = load double, ptr %24, align 8
  %26 = fdiv double %23, %25
  %27 = call double @llvm.rint.f64(double %26)
  %28 = fmul double %25, %27
  br label %29

29:                                               ; preds = %3, %18
  %30 = phi double [ %28, %18 ], [ 0x7FF8000000000000, %3 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %7) #6
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %6) #6
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %5) #6
  ret double %30
}

declare double @llvm.fabs.f64(double) #4

declare double @llvm.copysign.f64(double, double) #4

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #5

attributes #0 = { nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { nofree "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #3 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: read) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #5 = { nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #6 = { nounwind }
attributes #7 = { memory(none) }


