; look.c efc1a33b70bf2dc8d5c3f2413b5dcc37a8f31fa7730e3c8d26fef6067c0ef97c: written by make kernel

%struct.Look = type { i64, i64, i64, ptr, ptr, i64, i64, ptr, double, double, double, double, i64, ptr, ptr, ptr, ptr, i64, ptr, ptr, ptr, i64, i64, ptr }
%struct.Dips = type { i64, ptr, ptr, double, ptr, ptr, double, double, i64 }
%struct.Bracket = type { double, double, double, double, double, double, double, double, i64, i64 }
%struct.Found = type { double, double, i64, i64 }

define dso_local i64 @manipplan_look(ptr nocapture noundef readonly %0, ptr noundef %1, double noundef %2, ptr noundef %3) local_unnamed_addr #0 {
  %5 = alloca [22 x double], align 16
  %6 = alloca [22 x double], align 16
  %7 = load i64, ptr %1, align 8
  switch i64 %7, label %8 [
    i64 0, label %14
    i64 1, label %11
  ]

8:                                                ; preds = %4
  %9 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  %10 = load i64, ptr %9, align 8
  br label %447

11:                                               ; preds = %4
  %12 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  %13 = load i64, ptr %12, align 8
  br label %89

14:                                               ; preds = %4
  %15 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 5
  %16 = load i64, ptr %15, align 8
  %17 = icmp sgt i64 %16, 0
  br i1 %17, label %18, label %25

18:                                               ; preds = %14
  %19 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 8
  %20 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 6
  %21 = load i64, ptr %20, align 8
  %22 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 11
  %23 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 16
  %24 = load ptr, ptr %23, align 8
  br label %59

25:                                               ; preds = %59, %14
  %26 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 2
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 1
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 7
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 3
  %33 = load double, ptr %32, align 8
  %34 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 15
  %35 = load ptr, ptr %34, align 8
  %36 = tail call i64 %27(ptr noundef %29, ptr noundef %31, i64 noundef %16, double noundef %33, ptr noundef %35) #6
  %37 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 4
  %38 = load ptr, ptr %37, align 8
  %39 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 4
  %40 = load ptr, ptr %39, align 8
  %41 = load ptr, ptr %34, align 8
  %42 = load i64, ptr %15, align 8
  %43 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 16
  %44 = load ptr, ptr %43, align 8
  %45 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 17
  %46 = load i64, ptr %45, align 8
  %47 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 18
  %48 = load ptr, ptr %47, align 8
  %49 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %50 = load ptr, ptr %49, align 8
  %51 = tail call i64 %38(ptr noundef %40, ptr noundef %41, i64 noundef %42, ptr noundef %44, i64 noundef %46, ptr noundef %48, ptr noundef %50) #6
  %52 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  store i64 %51, ptr %52, align 8
  %53 = icmp slt i64 %51, 1
  %54 = load i64, ptr %45, align 8
  %55 = icmp sgt i64 %51, %54
  %56 = select i1 %53, i1 true, i1 %55
  br i1 %56, label %84, label %57

57:                                               ; preds = %25
  %58 = load ptr, ptr %49, align 8
  br label %74

59:                                               ; preds = %59, %18
  %60 = phi i64 [ 0, %18 ], [ %72, %59 ]
  %61 = load double, ptr %19, align 8
  %62 = srem i64 %60, %21
  %63 = icmp eq i64 %62, 0
  %64 = load double, ptr %22, align 8
  %65 = fcmp olt double %64, %2
  %66 = select i1 %63, i1 %65, i1 false
  %67 = select i1 %66, double %2, double %64
  %68 = fadd double %61, %67
  %69 = fcmp ogt double %68, 0.000000e+00
  %70 = select i1 %69, double %68, double 0.000000e+00
  %71 = getelementptr inbounds double, ptr %24, i64 %60
  store double %70, ptr %71, align 8
  %72 = add nuw nsw i64 %60, 1
  %73 = icmp eq i64 %72, %16
  br i1 %73, label %25, label %59

74:                                               ; preds = %74, %57
  %75 = phi i64 [ 0, %57 ], [ %82, %74 ]
  %76 = phi i32 [ 1, %57 ], [ %81, %74 ]
  %77 = getelementptr inbounds double, ptr %58, i64 %75
  %78 = load double, ptr %77, align 8
  %79 = fcmp ord double %78, 0.000000e+00
  %80 = zext i1 %79 to i32
  %81 = and i32 %76, %80
  %82 = add nuw nsw i64 %75, 1
  %83 = icmp eq i64 %82, %51
  br i1 %83, label %84, label %74

84:                                               ; preds = %74, %25
  %85 = phi i32 [ 1, %25 ], [ %81, %74 ]
  %86 = icmp sgt i64 %51, %54
  br i1 %86, label %663, label %87

87:                                               ; preds = %84
  store i64 1, ptr %1, align 8
  %88 = icmp eq i32 %85, 0
  br i1 %88, label %663, label %89

89:                                               ; preds = %11, %87
  %90 = phi i64 [ %13, %11 ], [ %51, %87 ]
  %91 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  %92 = icmp sgt i64 %90, 0
  br i1 %92, label %94, label %93

93:                                               ; preds = %89
  store i64 0, ptr %91, align 8
  br label %182

94:                                               ; preds = %89
  %95 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %96 = load ptr, ptr %95, align 8
  %97 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 16
  %98 = load ptr, ptr %97, align 8
  %99 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 18
  %100 = load ptr, ptr %99, align 8
  %101 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 2
  %102 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 6
  br label %105

103:                                              ; preds = %127
  store i64 %129, ptr %91, align 8
  %104 = icmp sgt i64 %129, 0
  br i1 %104, label %132, label %182

105:                                              ; preds = %127, %94
  %106 = phi i64 [ %90, %94 ], [ %128, %127 ]
  %107 = phi i64 [ 0, %94 ], [ %129, %127 ]
  %108 = phi i64 [ 0, %94 ], [ %130, %127 ]
  %109 = getelementptr inbounds double, ptr %96, i64 %108
  %110 = load double, ptr %109, align 8
  %111 = getelementptr inbounds i64, ptr %100, i64 %108
  %112 = load i64, ptr %111, align 8
  %113 = load i64, ptr %101, align 8
  %114 = sdiv i64 %112, %113
  %115 = getelementptr inbounds double, ptr %98, i64 %114
  %116 = load double, ptr %115, align 8
  %117 = fcmp ult double %110, %116
  br i1 %117, label %118, label %127

118:                                              ; preds = %105
  %119 = getelementptr inbounds i64, ptr %100, i64 %107
  store i64 %112, ptr %119, align 8
  %120 = load double, ptr %102, align 8
  %121 = fdiv double %110, %120
  %122 = tail call double @llvm.rint.f64(double %121)
  %123 = fmul double %120, %122
  %124 = add nsw i64 %107, 1
  %125 = getelementptr inbounds double, ptr %96, i64 %107
  store double %123, ptr %125, align 8
  %126 = load i64, ptr %91, align 8
  br label %127

127:                                              ; preds = %118, %105
  %128 = phi i64 [ %106, %105 ], [ %126, %118 ]
  %129 = phi i64 [ %107, %105 ], [ %124, %118 ]
  %130 = add nuw nsw i64 %108, 1
  %131 = icmp slt i64 %130, %128
  br i1 %131, label %105, label %103

132:                                              ; preds = %103, %177
  %133 = phi i64 [ %178, %177 ], [ 0, %103 ]
  %134 = getelementptr inbounds i64, ptr %100, i64 %133
  %135 = load i64, ptr %134, align 8
  %136 = load i64, ptr %101, align 8
  %137 = sdiv i64 %135, %136
  %138 = icmp slt i64 %133, %129
  br i1 %138, label %139, label %177

139:                                              ; preds = %132, %145
  %140 = phi i64 [ %146, %145 ], [ %133, %132 ]
  %141 = getelementptr inbounds i64, ptr %100, i64 %140
  %142 = load i64, ptr %141, align 8
  %143 = sdiv i64 %142, %136
  %144 = icmp eq i64 %143, %137
  br i1 %144, label %145, label %148

145:                                              ; preds = %139
  %146 = add i64 %140, 1
  %147 = icmp eq i64 %146, %129
  br i1 %147, label %148, label %139

148:                                              ; preds = %145, %139
  %149 = phi i64 [ %140, %139 ], [ %129, %145 ]
  %150 = add nsw i64 %133, 1
  %151 = icmp slt i64 %150, %149
  br i1 %151, label %152, label %177

152:                                              ; preds = %148, %171
  %153 = phi i64 [ %175, %171 ], [ %150, %148 ]
  %154 = getelementptr inbounds i64, ptr %100, i64 %153
  %155 = load i64, ptr %154, align 8
  %156 = getelementptr inbounds double, ptr %96, i64 %153
  %157 = load double, ptr %156, align 8
  %158 = icmp sgt i64 %153, %133
  br i1 %158, label %159, label %171

159:                                              ; preds = %152, %165
  %160 = phi i64 [ %161, %165 ], [ %153, %152 ]
  %161 = add nsw i64 %160, -1
  %162 = getelementptr inbounds i64, ptr %100, i64 %161
  %163 = load i64, ptr %162, align 8
  %164 = icmp sgt i64 %163, %155
  br i1 %164, label %165, label %171

165:                                              ; preds = %159
  %166 = getelementptr inbounds i64, ptr %100, i64 %160
  store i64 %163, ptr %166, align 8
  %167 = getelementptr inbounds double, ptr %96, i64 %161
  %168 = load double, ptr %167, align 8
  %169 = getelementptr inbounds double, ptr %96, i64 %160
  store double %168, ptr %169, align 8
  %170 = icmp sgt i64 %161, %133
  br i1 %170, label %159, label %171

171:                                              ; preds = %165, %159, %152
  %172 = phi i64 [ %153, %152 ], [ %133, %165 ], [ %160, %159 ]
  %173 = getelementptr inbounds i64, ptr %100, i64 %172
  store i64 %155, ptr %173, align 8
  %174 = getelementptr inbounds double, ptr %96, i64 %172
  store double %157, ptr %174, align 8
  %175 = add nsw i64 %153, 1
  %176 = icmp eq i64 %175, %149
  br i1 %176, label %177, label %152

177:                                              ; preds = %171, %148, %132
  %178 = phi i64 [ %149, %148 ], [ %133, %132 ], [ %149, %171 ]
  %179 = icmp slt i64 %178, %129
  br i1 %179, label %132, label %180

180:                                              ; preds = %177
  %181 = load i64, ptr %91, align 8
  br label %182

182:                                              ; preds = %180, %93, %103
  %183 = phi i64 [ %181, %180 ], [ 0, %93 ], [ %129, %103 ]
  %184 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 8
  %185 = load double, ptr %184, align 8
  %186 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 11
  %187 = load double, ptr %186, align 8
  %188 = fadd double %185, %187
  %189 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 5
  %190 = load i64, ptr %189, align 8
  %191 = add nsw i64 %190, -1
  %192 = sitofp i64 %191 to double
  %193 = fdiv double 1.000000e+00, %192
  %194 = icmp sgt i64 %183, 0
  br i1 %194, label %195, label %202

195:                                              ; preds = %182
  %196 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 18
  %197 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 2
  %198 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %199 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 10
  %200 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 7
  %201 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  br label %207

202:                                              ; preds = %315, %182
  %203 = phi i64 [ 0, %182 ], [ %317, %315 ]
  %204 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 21
  %205 = load i64, ptr %204, align 8
  %206 = icmp sgt i64 %203, %205
  br i1 %206, label %320, label %324

207:                                              ; preds = %315, %195
  %208 = phi i64 [ %183, %195 ], [ %316, %315 ]
  %209 = phi i64 [ 0, %195 ], [ %317, %315 ]
  %210 = phi i64 [ 0, %195 ], [ %318, %315 ]
  %211 = phi i64 [ 0, %195 ], [ %270, %315 ]
  %212 = phi i64 [ 0, %195 ], [ %244, %315 ]
  %213 = load ptr, ptr %196, align 8
  %214 = getelementptr inbounds i64, ptr %213, i64 %210
  %215 = load i64, ptr %214, align 8
  %216 = load i64, ptr %197, align 8
  %217 = sdiv i64 %215, %216
  %218 = srem i64 %215, %216
  %219 = load i64, ptr %189, align 8
  %220 = add nsw i64 %219, -1
  %221 = load ptr, ptr %198, align 8
  %222 = getelementptr inbounds double, ptr %221, i64 %210
  %223 = load double, ptr %222, align 8
  %224 = tail call double @llvm.minnum.f64(double %223, double %188)
  %225 = icmp sgt i64 %217, 0
  br i1 %225, label %226, label %243

226:                                              ; preds = %207
  %227 = sub nsw i64 %215, %216
  %228 = icmp slt i64 %212, %210
  br i1 %228, label %229, label %243

229:                                              ; preds = %226, %234
  %230 = phi i64 [ %235, %234 ], [ %212, %226 ]
  %231 = getelementptr inbounds i64, ptr %213, i64 %230
  %232 = load i64, ptr %231, align 8
  %233 = icmp slt i64 %232, %227
  br i1 %233, label %234, label %237

234:                                              ; preds = %229
  %235 = add i64 %230, 1
  %236 = icmp eq i64 %235, %210
  br i1 %236, label %243, label %229

237:                                              ; preds = %229
  %238 = icmp eq i64 %232, %227
  br i1 %238, label %239, label %243

239:                                              ; preds = %237
  %240 = getelementptr inbounds double, ptr %221, i64 %230
  %241 = load double, ptr %240, align 8
  %242 = tail call double @llvm.minnum.f64(double %241, double %188)
  br label %243

243:                                              ; preds = %234, %239, %237, %226, %207
  %244 = phi i64 [ %212, %207 ], [ %230, %239 ], [ %230, %237 ], [ %212, %226 ], [ %210, %234 ]
  %245 = phi double [ 0xFFF0000000000000, %207 ], [ %242, %239 ], [ %188, %237 ], [ %188, %226 ], [ %188, %234 ]
  %246 = phi double [ 0x7FF0000000000000, %207 ], [ %242, %239 ], [ %188, %237 ], [ %188, %226 ], [ %188, %234 ]
  %247 = icmp slt i64 %217, %220
  br i1 %247, label %248, label %269

248:                                              ; preds = %243
  %249 = add nsw i64 %216, %215
  %250 = icmp slt i64 %211, %208
  br i1 %250, label %251, label %265

251:                                              ; preds = %248, %256
  %252 = phi i64 [ %257, %256 ], [ %211, %248 ]
  %253 = getelementptr inbounds i64, ptr %213, i64 %252
  %254 = load i64, ptr %253, align 8
  %255 = icmp slt i64 %254, %249
  br i1 %255, label %256, label %259

256:                                              ; preds = %251
  %257 = add i64 %252, 1
  %258 = icmp eq i64 %257, %208
  br i1 %258, label %265, label %251

259:                                              ; preds = %251
  %260 = icmp eq i64 %254, %249
  br i1 %260, label %261, label %265

261:                                              ; preds = %259
  %262 = getelementptr inbounds double, ptr %221, i64 %252
  %263 = load double, ptr %262, align 8
  %264 = tail call double @llvm.minnum.f64(double %263, double %188)
  br label %265

265:                                              ; preds = %256, %261, %259, %248
  %266 = phi i64 [ %252, %261 ], [ %252, %259 ], [ %211, %248 ], [ %208, %256 ]
  %267 = phi double [ %264, %261 ], [ %188, %259 ], [ %188, %248 ], [ %188, %256 ]
  %268 = tail call double @llvm.maxnum.f64(double %245, double %267)
  br label %269

269:                                              ; preds = %265, %243
  %270 = phi i64 [ %266, %265 ], [ %211, %243 ]
  %271 = phi double [ %268, %265 ], [ %245, %243 ]
  %272 = phi double [ %267, %265 ], [ 0x7FF0000000000000, %243 ]
  %273 = fcmp oge double %246, %224
  %274 = fcmp ogt double %272, %224
  %275 = select i1 %273, i1 %274, i1 false
  br i1 %275, label %276, label %315

276:                                              ; preds = %269
  %277 = fsub double %271, %224
  %278 = fsub double %224, %277
  %279 = load double, ptr %184, align 8
  %280 = load double, ptr %199, align 8
  %281 = fadd double %279, %280
  %282 = fcmp olt double %278, %281
  br i1 %282, label %283, label %315

283:                                              ; preds = %276
  %284 = load ptr, ptr %200, align 8
  %285 = add nsw i64 %217, -1
  %286 = select i1 %225, i64 %285, i64 0
  %287 = getelementptr inbounds double, ptr %284, i64 %286
  %288 = load double, ptr %287, align 8
  %289 = getelementptr inbounds double, ptr %284, i64 %217
  %290 = load double, ptr %289, align 8
  %291 = add nsw i64 %217, 1
  %292 = select i1 %247, i64 %291, i64 %220
  %293 = getelementptr inbounds double, ptr %284, i64 %292
  %294 = load double, ptr %293, align 8
  %295 = icmp eq i64 %217, 0
  %296 = fcmp olt double %246, %188
  %297 = select i1 %296, double %246, double 0x7FF8000000000000
  %298 = select i1 %295, double %224, double %297
  %299 = icmp eq i64 %217, %220
  %300 = fcmp olt double %272, %188
  %301 = select i1 %300, double %272, double 0x7FF8000000000000
  %302 = select i1 %299, double %224, double %301
  %303 = load ptr, ptr %201, align 8
  %304 = add nsw i64 %209, 1
  %305 = getelementptr inbounds %struct.Bracket, ptr %303, i64 %209
  store double %288, ptr %305, align 8
  %306 = getelementptr inbounds i8, ptr %305, i64 8
  store double %290, ptr %306, align 8
  %307 = getelementptr inbounds i8, ptr %305, i64 16
  store double %294, ptr %307, align 8
  %308 = getelementptr inbounds i8, ptr %305, i64 24
  store double %298, ptr %308, align 8
  %309 = getelementptr inbounds i8, ptr %305, i64 32
  store double %224, ptr %309, align 8
  %310 = getelementptr inbounds i8, ptr %305, i64 40
  store double %302, ptr %310, align 8
  %311 = getelementptr inbounds i8, ptr %305, i64 48
  store double 0x7FF8000000000000, ptr %311, align 8
  %312 = getelementptr inbounds i8, ptr %305, i64 56
  %313 = getelementptr inbounds i8, ptr %305, i64 72
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %312, i8 0, i64 16, i1 false)
  store i64 %218, ptr %313, align 8
  %314 = load i64, ptr %91, align 8
  br label %315

315:                                              ; preds = %283, %276, %269
  %316 = phi i64 [ %314, %283 ], [ %208, %276 ], [ %208, %269 ]
  %317 = phi i64 [ %304, %283 ], [ %209, %276 ], [ %209, %269 ]
  %318 = add nuw nsw i64 %210, 1
  %319 = icmp slt i64 %318, %316
  br i1 %319, label %207, label %202

320:                                              ; preds = %202
  %321 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %322 = load ptr, ptr %321, align 8
  tail call void @qsort(ptr noundef %322, i64 noundef %203, i64 noundef 80, ptr noundef nonnull @lower) #6
  %323 = load i64, ptr %204, align 8
  br label %324

324:                                              ; preds = %320, %202
  %325 = phi i64 [ %323, %320 ], [ %203, %202 ]
  %326 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 12
  %327 = load i64, ptr %326, align 8
  %328 = icmp sgt i64 %327, 0
  br i1 %328, label %329, label %333

329:                                              ; preds = %324
  %330 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 13
  %331 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 14
  %332 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  br label %345

333:                                              ; preds = %345, %324
  %334 = phi i64 [ %325, %324 ], [ %359, %345 ]
  %335 = icmp sgt i64 %334, 0
  br i1 %335, label %338, label %336

336:                                              ; preds = %333
  %337 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  store i64 %334, ptr %337, align 8
  store i64 2, ptr %1, align 8
  br label %395

338:                                              ; preds = %333
  %339 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 3
  %340 = load ptr, ptr %339, align 8
  %341 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %342 = load ptr, ptr %341, align 8
  %343 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 23
  %344 = load ptr, ptr %343, align 8
  br label %372

345:                                              ; preds = %345, %329
  %346 = phi i64 [ %325, %329 ], [ %359, %345 ]
  %347 = phi i64 [ 0, %329 ], [ %369, %345 ]
  %348 = load ptr, ptr %330, align 8
  %349 = getelementptr inbounds double, ptr %348, i64 %347
  %350 = load double, ptr %349, align 8
  %351 = fsub double %350, %193
  %352 = tail call double @llvm.maxnum.f64(double %351, double 0.000000e+00)
  %353 = fadd double %193, %350
  %354 = tail call double @llvm.minnum.f64(double %353, double 1.000000e+00)
  %355 = load ptr, ptr %331, align 8
  %356 = getelementptr inbounds i64, ptr %355, i64 %347
  %357 = load i64, ptr %356, align 8
  %358 = load ptr, ptr %332, align 8
  %359 = add nsw i64 %346, 1
  %360 = getelementptr inbounds %struct.Bracket, ptr %358, i64 %346
  store double %352, ptr %360, align 8
  %361 = getelementptr inbounds i8, ptr %360, i64 8
  store double %350, ptr %361, align 8
  %362 = getelementptr inbounds i8, ptr %360, i64 16
  store double %354, ptr %362, align 8
  %363 = getelementptr inbounds i8, ptr %360, i64 24
  store double 0x7FF8000000000000, ptr %363, align 8
  %364 = getelementptr inbounds i8, ptr %360, i64 32
  store double 0x7FF8000000000000, ptr %364, align 8
  %365 = getelementptr inbounds i8, ptr %360, i64 40
  store double 0x7FF8000000000000, ptr %365, align 8
  %366 = getelementptr inbounds i8, ptr %360, i64 48
  store double 0x7FF8000000000000, ptr %366, align 8
  %367 = getelementptr inbounds i8, ptr %360, i64 56
  %368 = getelementptr inbounds i8, ptr %360, i64 72
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %367, i8 0, i64 16, i1 false)
  store i64 %357, ptr %368, align 8
  %369 = add nuw nsw i64 %347, 1
  %370 = load i64, ptr %326, align 8
  %371 = icmp slt i64 %369, %370
  br i1 %371, label %345, label %333

372:                                              ; preds = %372, %338
  %373 = phi i64 [ 0, %338 ], [ %388, %372 ]
  %374 = getelementptr inbounds %struct.Bracket, ptr %342, i64 %373, i32 9
  %375 = shl nuw nsw i64 %373, 1
  %376 = load i64, ptr %374, align 8
  %377 = shl nsw i64 %376, 1
  %378 = getelementptr inbounds i64, ptr %340, i64 %377
  %379 = load i64, ptr %378, align 8
  %380 = getelementptr inbounds i64, ptr %344, i64 %375
  store i64 %379, ptr %380, align 8
  %381 = load i64, ptr %374, align 8
  %382 = shl nsw i64 %381, 1
  %383 = or i64 %382, 1
  %384 = getelementptr inbounds i64, ptr %340, i64 %383
  %385 = load i64, ptr %384, align 8
  %386 = or i64 %375, 1
  %387 = getelementptr inbounds i64, ptr %344, i64 %386
  store i64 %385, ptr %387, align 8
  %388 = add nuw nsw i64 %373, 1
  %389 = icmp eq i64 %388, %334
  br i1 %389, label %390, label %372

390:                                              ; preds = %372
  %391 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  store i64 %334, ptr %391, align 8
  store i64 2, ptr %1, align 8
  br i1 %335, label %392, label %395

392:                                              ; preds = %390
  %393 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %394 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 23
  br label %399

395:                                              ; preds = %336, %390
  %396 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  br label %586

397:                                              ; preds = %439
  %398 = icmp eq i64 %443, 0
  br i1 %398, label %447, label %663

399:                                              ; preds = %392, %439
  %400 = phi i64 [ 0, %392 ], [ %443, %439 ]
  %401 = phi i64 [ 0, %392 ], [ %444, %439 ]
  %402 = load ptr, ptr %393, align 8
  %403 = getelementptr inbounds %struct.Bracket, ptr %402, i64 %401
  %404 = load ptr, ptr %394, align 8
  %405 = shl nuw nsw i64 %401, 1
  %406 = getelementptr inbounds i64, ptr %404, i64 %405
  call void @llvm.lifetime.start.p0(i64 176, ptr nonnull %6) #6
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(176) %6, i8 0, i64 176, i1 false)
  %407 = getelementptr inbounds %struct.Bracket, ptr %402, i64 %401, i32 4
  %408 = load double, ptr %407, align 8
  %409 = fcmp uno double %408, 0.000000e+00
  br i1 %409, label %410, label %414

410:                                              ; preds = %399
  %411 = getelementptr inbounds %struct.Bracket, ptr %402, i64 %401, i32 1
  %412 = load double, ptr %411, align 8
  %413 = call fastcc double @distance_at(ptr noundef %0, double noundef %412, ptr noundef %406, ptr noundef nonnull %6)
  store double %413, ptr %407, align 8
  br label %414

414:                                              ; preds = %410, %399
  %415 = getelementptr inbounds %struct.Bracket, ptr %402, i64 %401, i32 3
  %416 = load double, ptr %415, align 8
  %417 = fcmp uno double %416, 0.000000e+00
  br i1 %417, label %418, label %421

418:                                              ; preds = %414
  %419 = load double, ptr %403, align 8
  %420 = call fastcc double @distance_at(ptr noundef %0, double noundef %419, ptr noundef %406, ptr noundef nonnull %6)
  store double %420, ptr %415, align 8
  br label %421

421:                                              ; preds = %418, %414
  %422 = getelementptr inbounds %struct.Bracket, ptr %402, i64 %401, i32 5
  %423 = load double, ptr %422, align 8
  %424 = fcmp uno double %423, 0.000000e+00
  br i1 %424, label %425, label %429

425:                                              ; preds = %421
  %426 = getelementptr inbounds %struct.Bracket, ptr %402, i64 %401, i32 2
  %427 = load double, ptr %426, align 8
  %428 = call fastcc double @distance_at(ptr noundef %0, double noundef %427, ptr noundef %406, ptr noundef nonnull %6)
  store double %428, ptr %422, align 8
  br label %429

429:                                              ; preds = %425, %421
  %430 = phi double [ %428, %425 ], [ %423, %421 ]
  %431 = load double, ptr %407, align 8
  %432 = fcmp uno double %431, 0.000000e+00
  br i1 %432, label %439, label %433

433:                                              ; preds = %429
  %434 = load double, ptr %415, align 8
  %435 = fcmp uno double %434, 0.000000e+00
  br i1 %435, label %439, label %436

436:                                              ; preds = %433
  %437 = fcmp ord double %430, 0.000000e+00
  %438 = zext i1 %437 to i32
  br label %439

439:                                              ; preds = %429, %433, %436
  %440 = phi i32 [ 0, %433 ], [ 0, %429 ], [ %438, %436 ]
  call void @llvm.lifetime.end.p0(i64 176, ptr nonnull %6) #6
  %441 = icmp eq i32 %440, 0
  %442 = zext i1 %441 to i64
  %443 = add nuw nsw i64 %400, %442
  %444 = add nuw nsw i64 %401, 1
  %445 = load i64, ptr %391, align 8
  %446 = icmp slt i64 %444, %445
  br i1 %446, label %399, label %397

447:                                              ; preds = %8, %397
  %448 = phi i64 [ %10, %8 ], [ %445, %397 ]
  %449 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 23
  %450 = load ptr, ptr %449, align 8
  %451 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %452 = load ptr, ptr %451, align 8
  %453 = icmp sgt i64 %448, 0
  br i1 %453, label %454, label %586

454:                                              ; preds = %447
  %455 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 8
  %456 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 7
  br label %457

457:                                              ; preds = %580, %454
  %458 = phi i64 [ 0, %454 ], [ %581, %580 ]
  %459 = phi i64 [ 0, %454 ], [ %582, %580 ]
  %460 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459
  call void @llvm.lifetime.start.p0(i64 176, ptr nonnull %5) #6
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(176) %5, i8 0, i64 176, i1 false)
  %461 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 6
  %462 = load double, ptr %461, align 8
  %463 = fcmp uno double %462, 0.000000e+00
  br i1 %463, label %464, label %467

464:                                              ; preds = %457
  %465 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 8
  %466 = load i64, ptr %465, align 8
  br label %492

467:                                              ; preds = %457
  %468 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 7
  %469 = load double, ptr %468, align 8
  %470 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 4
  %471 = load double, ptr %470, align 8
  %472 = fcmp ogt double %471, %469
  %473 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 1
  %474 = load double, ptr %473, align 8
  %475 = fcmp olt double %474, %462
  %476 = select i1 %472, double %474, double %462
  br i1 %472, label %478, label %477

477:                                              ; preds = %467
  br i1 %475, label %482, label %479

478:                                              ; preds = %467
  br i1 %475, label %479, label %482

479:                                              ; preds = %478, %477
  %480 = phi double [ %469, %477 ], [ %471, %478 ]
  store double %476, ptr %460, align 8
  %481 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 3
  store double %480, ptr %481, align 8
  br label %486

482:                                              ; preds = %478, %477
  %483 = phi double [ %469, %477 ], [ %471, %478 ]
  %484 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 2
  store double %476, ptr %484, align 8
  %485 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 5
  store double %483, ptr %485, align 8
  br label %486

486:                                              ; preds = %482, %479
  br i1 %472, label %487, label %488

487:                                              ; preds = %486
  store double %462, ptr %473, align 8
  store double %469, ptr %470, align 8
  br label %488

488:                                              ; preds = %487, %486
  %489 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 8
  %490 = load i64, ptr %489, align 8
  %491 = add nsw i64 %490, 1
  store i64 %491, ptr %489, align 8
  store double 0x7FF8000000000000, ptr %461, align 8
  br label %492

492:                                              ; preds = %488, %464
  %493 = phi i64 [ %466, %464 ], [ %491, %488 ]
  %494 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 8
  %495 = load i64, ptr %455, align 8
  %496 = icmp slt i64 %493, %495
  br i1 %496, label %497, label %580

497:                                              ; preds = %492
  %498 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 2
  %499 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 1
  %500 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 3
  %501 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 4
  %502 = getelementptr inbounds %struct.Bracket, ptr %452, i64 %459, i32 5
  %503 = shl nuw nsw i64 %459, 1
  %504 = getelementptr inbounds i64, ptr %450, i64 %503
  br label %505

505:                                              ; preds = %575, %497
  %506 = phi i64 [ %493, %497 ], [ %577, %575 ]
  %507 = load double, ptr %498, align 8
  %508 = load double, ptr %460, align 8
  %509 = fsub double %507, %508
  %510 = load double, ptr %456, align 8
  %511 = fcmp ult double %509, %510
  br i1 %511, label %580, label %512

512:                                              ; preds = %505
  %513 = load double, ptr %499, align 8
  %514 = fsub double %513, %508
  %515 = fsub double %507, %513
  %516 = fcmp ogt double %514, %515
  %517 = fmul double %514, -5.000000e-01
  %518 = fmul double %515, 5.000000e-01
  %519 = select i1 %516, double %517, double %518
  %520 = load double, ptr %500, align 8
  %521 = load double, ptr %501, align 8
  %522 = fsub double %520, %521
  %523 = fdiv double %522, %514
  %524 = load double, ptr %502, align 8
  %525 = fsub double %524, %521
  %526 = fdiv double %525, %515
  %527 = fmul double %515, %523
  %528 = fmul double %514, %526
  %529 = fsub double %527, %528
  %530 = fadd double %523, %526
  %531 = fmul double %530, 2.000000e+00
  %532 = fdiv double %529, %531
  %533 = call double @llvm.fabs.f64(double %532) #7
  %534 = fcmp one double %533, 0x7FF0000000000000
  %535 = fneg double %514
  %536 = fcmp ogt double %532, %535
  %537 = select i1 %534, i1 %536, i1 false
  %538 = fcmp olt double %532, %515
  %539 = select i1 %537, i1 %538, i1 false
  br i1 %539, label %540, label %544

540:                                              ; preds = %512
  %541 = srem i64 %506, 3
  %542 = icmp slt i64 %541, 2
  %543 = select i1 %542, double %532, double %519
  br label %544

544:                                              ; preds = %540, %512
  %545 = phi double [ %519, %512 ], [ %543, %540 ]
  %546 = fadd double %514, %515
  %547 = fmul double %546, 2.000000e-02
  %548 = fmul double %510, 2.500000e-01
  %549 = call double @llvm.maxnum.f64(double %547, double %548)
  %550 = call double @llvm.fabs.f64(double %545)
  %551 = fcmp olt double %550, %549
  %552 = call double @llvm.copysign.f64(double %549, double %519)
  %553 = select i1 %551, double %552, double %545
  %554 = fadd double %513, %553
  %555 = call double @llvm.maxnum.f64(double %554, double %508)
  %556 = call double @llvm.minnum.f64(double %555, double %507)
  %557 = call fastcc double @distance_at(ptr noundef nonnull %0, double noundef %556, ptr noundef %504, ptr noundef nonnull %5)
  %558 = fcmp uno double %557, 0.000000e+00
  br i1 %558, label %559, label %561

559:                                              ; preds = %544
  store double %556, ptr %461, align 8
  %560 = add nsw i64 %458, 1
  br label %580

561:                                              ; preds = %544
  %562 = load double, ptr %501, align 8
  %563 = fcmp ogt double %562, %557
  %564 = load double, ptr %499, align 8
  %565 = fcmp olt double %564, %556
  %566 = select i1 %563, double %564, double %556
  br i1 %563, label %568, label %567

567:                                              ; preds = %561
  br i1 %565, label %571, label %569

568:                                              ; preds = %561
  br i1 %565, label %569, label %571

569:                                              ; preds = %568, %567
  %570 = phi double [ %557, %567 ], [ %562, %568 ]
  store double %566, ptr %460, align 8
  store double %570, ptr %500, align 8
  br label %573

571:                                              ; preds = %568, %567
  %572 = phi double [ %557, %567 ], [ %562, %568 ]
  store double %566, ptr %498, align 8
  store double %572, ptr %502, align 8
  br label %573

573:                                              ; preds = %571, %569
  br i1 %563, label %574, label %575

574:                                              ; preds = %573
  store double %556, ptr %499, align 8
  store double %557, ptr %501, align 8
  br label %575

575:                                              ; preds = %574, %573
  %576 = load i64, ptr %494, align 8
  %577 = add nsw i64 %576, 1
  store i64 %577, ptr %494, align 8
  %578 = load i64, ptr %455, align 8
  %579 = icmp slt i64 %577, %578
  br i1 %579, label %505, label %580

580:                                              ; preds = %575, %505, %559, %492
  %581 = phi i64 [ %560, %559 ], [ %458, %492 ], [ %458, %505 ], [ %458, %575 ]
  call void @llvm.lifetime.end.p0(i64 176, ptr nonnull %5) #6
  %582 = add nuw nsw i64 %459, 1
  %583 = icmp eq i64 %582, %448
  br i1 %583, label %584, label %457

584:                                              ; preds = %580
  %585 = icmp eq i64 %581, 0
  br i1 %585, label %586, label %663

586:                                              ; preds = %395, %447, %584
  %587 = phi ptr [ %451, %584 ], [ %396, %395 ], [ %451, %447 ]
  %588 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  %589 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  %590 = load i64, ptr %589, align 8
  %591 = icmp sgt i64 %590, 0
  br i1 %591, label %592, label %600

592:                                              ; preds = %586
  %593 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 18
  %594 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 2
  %595 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %596 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 8
  %597 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 9
  %598 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 6
  %599 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 7
  br label %604

600:                                              ; preds = %638, %586
  %601 = phi i64 [ 0, %586 ], [ %640, %638 ]
  %602 = load i64, ptr %588, align 8
  %603 = icmp sgt i64 %602, 0
  br i1 %603, label %645, label %643

604:                                              ; preds = %592, %638
  %605 = phi i64 [ %590, %592 ], [ %639, %638 ]
  %606 = phi i64 [ 0, %592 ], [ %640, %638 ]
  %607 = phi i64 [ 0, %592 ], [ %641, %638 ]
  %608 = load ptr, ptr %593, align 8
  %609 = getelementptr inbounds i64, ptr %608, i64 %607
  %610 = load i64, ptr %609, align 8
  %611 = load i64, ptr %594, align 8
  %612 = sdiv i64 %610, %611
  %613 = srem i64 %610, %611
  %614 = load ptr, ptr %595, align 8
  %615 = getelementptr inbounds double, ptr %614, i64 %607
  %616 = load double, ptr %615, align 8
  %617 = load double, ptr %596, align 8
  %618 = load double, ptr %597, align 8
  %619 = fadd double %617, %618
  %620 = fcmp olt double %616, %619
  br i1 %620, label %628, label %621

621:                                              ; preds = %604
  %622 = load i64, ptr %598, align 8
  %623 = srem i64 %612, %622
  %624 = icmp eq i64 %623, 0
  %625 = fadd double %617, %2
  %626 = fcmp olt double %616, %625
  %627 = select i1 %624, i1 %626, i1 false
  br i1 %627, label %628, label %638

628:                                              ; preds = %621, %604
  %629 = load ptr, ptr %599, align 8
  %630 = getelementptr inbounds double, ptr %629, i64 %612
  %631 = load double, ptr %630, align 8
  %632 = add nsw i64 %606, 1
  %633 = getelementptr inbounds %struct.Found, ptr %3, i64 %606
  store double %616, ptr %633, align 8
  %634 = getelementptr inbounds i8, ptr %633, i64 8
  store double %631, ptr %634, align 8
  %635 = getelementptr inbounds i8, ptr %633, i64 16
  store i64 %613, ptr %635, align 8
  %636 = getelementptr inbounds i8, ptr %633, i64 24
  store i64 0, ptr %636, align 8
  %637 = load i64, ptr %589, align 8
  br label %638

638:                                              ; preds = %621, %628
  %639 = phi i64 [ %637, %628 ], [ %605, %621 ]
  %640 = phi i64 [ %632, %628 ], [ %606, %621 ]
  %641 = add nuw nsw i64 %607, 1
  %642 = icmp slt i64 %641, %639
  br i1 %642, label %604, label %600

643:                                              ; preds = %645, %600
  %644 = phi i64 [ %601, %600 ], [ %655, %645 ]
  call void @qsort(ptr noundef %3, i64 noundef %644, i64 noundef 32, ptr noundef nonnull @order) #6
  br label %663

645:                                              ; preds = %600, %645
  %646 = phi i64 [ %655, %645 ], [ %601, %600 ]
  %647 = phi i64 [ %660, %645 ], [ 0, %600 ]
  %648 = load ptr, ptr %587, align 8
  %649 = getelementptr inbounds %struct.Bracket, ptr %648, i64 %647, i32 4
  %650 = load double, ptr %649, align 8
  %651 = getelementptr inbounds %struct.Bracket, ptr %648, i64 %647, i32 1
  %652 = load double, ptr %651, align 8
  %653 = getelementptr inbounds %struct.Bracket, ptr %648, i64 %647, i32 9
  %654 = load i64, ptr %653, align 8
  %655 = add nsw i64 %646, 1
  %656 = getelementptr inbounds %struct.Found, ptr %3, i64 %646
  store double %650, ptr %656, align 8
  %657 = getelementptr inbounds i8, ptr %656, i64 8
  store double %652, ptr %657, align 8
  %658 = getelementptr inbounds i8, ptr %656, i64 16
  store i64 %654, ptr %658, align 8
  %659 = getelementptr inbounds i8, ptr %656, i64 24
  store i64 1, ptr %659, align 8
  %660 = add nuw nsw i64 %647, 1
  %661 = load i64, ptr %588, align 8
  %662 = icmp slt i64 %660, %661
  br i1 %662, label %645, label %643

663:                                              ; preds = %84, %584, %397, %87, %643
  %664 = phi i64 [ %644, %643 ], [ -1, %87 ], [ -1, %397 ], [ -1, %584 ], [ -2, %84 ]
  ret i64 %664
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

define internal i32 @lower(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1) #3 {
  %3 = getelementptr inbounds %struct.Bracket, ptr %0, i64 0, i32 4
  %4 = load double, ptr %3, align 8
  %5 = getelementptr inbounds %struct.Bracket, ptr %1, i64 0, i32 4
  %6 = load double, ptr %5, align 8
  %7 = fcmp une double %4, %6
  br i1 %7, label %8, label %10

8:                                                ; preds = %2
  %9 = fcmp olt double %4, %6
  br label %24

10:                                               ; preds = %2
  %11 = getelementptr inbounds %struct.Bracket, ptr %0, i64 0, i32 1
  %12 = load double, ptr %11, align 8
  %13 = getelementptr inbounds %struct.Bracket, ptr %1, i64 0, i32 1
  %14 = load double, ptr %13, align 8
  %15 = fcmp une double %12, %14
  br i1 %15, label %16, label %18

16:                                               ; preds = %10
  %17 = fcmp olt double %12, %14
  br label %24

18:                                               ; preds = %10
  %19 = getelementptr inbounds %struct.Bracket, ptr %0, i64 0, i32 9
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr inbounds %struct.Bracket, ptr %1, i64 0, i32 9
  %22 = load i64, ptr %21, align 8
  %23 = icmp slt i64 %20, %22
  br label %24

24:                                               ; preds = %18, %16, %8
  %25 = phi i1 [ %23, %18 ], [ %17, %16 ], [ %9, %8 ]
  %26 = select i1 %25, i32 -1, i32 1
  ret i32 %26
}

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #5

define internal fastcc double @distance_at(ptr nocapture noundef readonly %0, double noundef %1, ptr noundef %2, ptr noundef %3) unnamed_addr #0 {
  %5 = alloca double, align 8
  store double %1, ptr %5, align 8
  %6 = load i64, ptr %0, align 8
  %7 = alloca double, i64 %6, align 16
  %8 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 2
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 1
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 3
  %13 = load double, ptr %12, align 8
  %14 = call i64 %9(ptr noundef %11, ptr noundef nonnull %5, i64 noundef 1, double noundef %13, ptr noundef nonnull %7) #6
  %15 = icmp eq i64 %14, 0
  br i1 %15, label %16, label %27

16:                                               ; preds = %4
  %17 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 5
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 4
  %20 = load ptr, ptr %19, align 8
  %21 = call double %18(ptr noundef %20, ptr noundef nonnull %7, ptr noundef %2, ptr noundef %3) #6
  %22 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 6
  %23 = load double, ptr %22, align 8
  %24 = fdiv double %21, %23
  %25 = call double @llvm.rint.f64(double %24)
  %26 = fmul double %23, %25
  br label %27

27:                                               ; preds = %4, %16
  %28 = phi double [ %26, %16 ], [ 0x7FF8000000000000, %4 ]
  ret double %28
}

declare double @llvm.fabs.f64(double) #4

declare double @llvm.copysign.f64(double, double) #4

attributes #0 = { nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { nofree "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #3 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: read) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #5 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #6 = { nounwind }
attributes #7 = { memory(none) }


