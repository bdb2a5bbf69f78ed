; look.c 79be4886feb12e9bc59562c910414c2a7242bf30e52b26aab0b331c463eeec45: written by make kernel

%struct.Look = type { i64, i64, i64, ptr, ptr, i64, i64, ptr, double, double, double, double, i64, ptr, ptr, ptr, ptr, i64, ptr, ptr, ptr, i64, ptr, ptr }
%struct.Dips = type { i64, ptr, ptr, double, ptr, ptr, double, double, i64 }
%struct.Bracket = type { double, double, double, double, double, double, double, double, i64 }
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
  %9 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 21
  %10 = load i64, ptr %9, align 8
  br label %448

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
  br i1 %86, label %667, label %87

87:                                               ; preds = %84
  store i64 1, ptr %1, align 8
  %88 = icmp eq i32 %85, 0
  br i1 %88, label %667, label %89

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
  br i1 %194, label %195, label %204

195:                                              ; preds = %182
  %196 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 18
  %197 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 2
  %198 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %199 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 10
  %200 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 7
  %201 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %202 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  %203 = load ptr, ptr %196, align 8
  br label %214

204:                                              ; preds = %327, %182
  %205 = phi i64 [ 0, %182 ], [ %330, %327 ]
  %206 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 12
  %207 = load i64, ptr %206, align 8
  %208 = icmp sgt i64 %207, 0
  br i1 %208, label %209, label %333

209:                                              ; preds = %204
  %210 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 13
  %211 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %212 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 14
  %213 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  br label %345

214:                                              ; preds = %327, %195
  %215 = phi i64 [ %183, %195 ], [ %328, %327 ]
  %216 = phi ptr [ %203, %195 ], [ %329, %327 ]
  %217 = phi i64 [ 0, %195 ], [ %330, %327 ]
  %218 = phi i64 [ 0, %195 ], [ %331, %327 ]
  %219 = phi i64 [ 0, %195 ], [ %276, %327 ]
  %220 = phi i64 [ 0, %195 ], [ %250, %327 ]
  %221 = getelementptr inbounds i64, ptr %216, i64 %218
  %222 = load i64, ptr %221, align 8
  %223 = load i64, ptr %197, align 8
  %224 = sdiv i64 %222, %223
  %225 = load i64, ptr %189, align 8
  %226 = add nsw i64 %225, -1
  %227 = load ptr, ptr %198, align 8
  %228 = getelementptr inbounds double, ptr %227, i64 %218
  %229 = load double, ptr %228, align 8
  %230 = tail call double @llvm.minnum.f64(double %229, double %188)
  %231 = icmp sgt i64 %224, 0
  br i1 %231, label %232, label %249

232:                                              ; preds = %214
  %233 = sub nsw i64 %222, %223
  %234 = icmp slt i64 %220, %218
  br i1 %234, label %235, label %249

235:                                              ; preds = %232, %240
  %236 = phi i64 [ %241, %240 ], [ %220, %232 ]
  %237 = getelementptr inbounds i64, ptr %216, i64 %236
  %238 = load i64, ptr %237, align 8
  %239 = icmp slt i64 %238, %233
  br i1 %239, label %240, label %243

240:                                              ; preds = %235
  %241 = add i64 %236, 1
  %242 = icmp eq i64 %241, %218
  br i1 %242, label %249, label %235

243:                                              ; preds = %235
  %244 = icmp eq i64 %238, %233
  br i1 %244, label %245, label %249

245:                                              ; preds = %243
  %246 = getelementptr inbounds double, ptr %227, i64 %236
  %247 = load double, ptr %246, align 8
  %248 = tail call double @llvm.minnum.f64(double %247, double %188)
  br label %249

249:                                              ; preds = %240, %245, %243, %232, %214
  %250 = phi i64 [ %220, %214 ], [ %236, %245 ], [ %236, %243 ], [ %220, %232 ], [ %218, %240 ]
  %251 = phi double [ 0xFFF0000000000000, %214 ], [ %248, %245 ], [ %188, %243 ], [ %188, %232 ], [ %188, %240 ]
  %252 = phi double [ 0x7FF0000000000000, %214 ], [ %248, %245 ], [ %188, %243 ], [ %188, %232 ], [ %188, %240 ]
  %253 = icmp slt i64 %224, %226
  br i1 %253, label %254, label %275

254:                                              ; preds = %249
  %255 = add nsw i64 %223, %222
  %256 = icmp slt i64 %219, %215
  br i1 %256, label %257, label %271

257:                                              ; preds = %254, %262
  %258 = phi i64 [ %263, %262 ], [ %219, %254 ]
  %259 = getelementptr inbounds i64, ptr %216, i64 %258
  %260 = load i64, ptr %259, align 8
  %261 = icmp slt i64 %260, %255
  br i1 %261, label %262, label %265

262:                                              ; preds = %257
  %263 = add i64 %258, 1
  %264 = icmp eq i64 %263, %215
  br i1 %264, label %271, label %257

265:                                              ; preds = %257
  %266 = icmp eq i64 %260, %255
  br i1 %266, label %267, label %271

267:                                              ; preds = %265
  %268 = getelementptr inbounds double, ptr %227, i64 %258
  %269 = load double, ptr %268, align 8
  %270 = tail call double @llvm.minnum.f64(double %269, double %188)
  br label %271

271:                                              ; preds = %262, %267, %265, %254
  %272 = phi i64 [ %258, %267 ], [ %258, %265 ], [ %219, %254 ], [ %215, %262 ]
  %273 = phi double [ %270, %267 ], [ %188, %265 ], [ %188, %254 ], [ %188, %262 ]
  %274 = tail call double @llvm.maxnum.f64(double %251, double %273)
  br label %275

275:                                              ; preds = %271, %249
  %276 = phi i64 [ %272, %271 ], [ %219, %249 ]
  %277 = phi double [ %274, %271 ], [ %251, %249 ]
  %278 = phi double [ %273, %271 ], [ 0x7FF0000000000000, %249 ]
  %279 = fcmp oge double %252, %230
  %280 = fcmp ogt double %278, %230
  %281 = select i1 %279, i1 %280, i1 false
  br i1 %281, label %282, label %327

282:                                              ; preds = %275
  %283 = fsub double %277, %230
  %284 = fsub double %230, %283
  %285 = load double, ptr %184, align 8
  %286 = load double, ptr %199, align 8
  %287 = fadd double %285, %286
  %288 = fcmp olt double %284, %287
  br i1 %288, label %289, label %327

289:                                              ; preds = %282
  %290 = load ptr, ptr %200, align 8
  %291 = add nsw i64 %224, -1
  %292 = select i1 %231, i64 %291, i64 0
  %293 = getelementptr inbounds double, ptr %290, i64 %292
  %294 = load double, ptr %293, align 8
  %295 = getelementptr inbounds double, ptr %290, i64 %224
  %296 = load double, ptr %295, align 8
  %297 = add nsw i64 %224, 1
  %298 = select i1 %253, i64 %297, i64 %226
  %299 = getelementptr inbounds double, ptr %290, i64 %298
  %300 = load double, ptr %299, align 8
  %301 = icmp eq i64 %224, 0
  %302 = fcmp olt double %252, %188
  %303 = select i1 %302, double %252, double 0x7FF8000000000000
  %304 = select i1 %301, double %230, double %303
  %305 = icmp eq i64 %224, %226
  %306 = fcmp olt double %278, %188
  %307 = select i1 %306, double %278, double 0x7FF8000000000000
  %308 = select i1 %305, double %230, double %307
  %309 = load ptr, ptr %201, align 8
  %310 = getelementptr inbounds %struct.Bracket, ptr %309, i64 %217
  store double %294, ptr %310, align 8
  %311 = getelementptr inbounds i8, ptr %310, i64 8
  store double %296, ptr %311, align 8
  %312 = getelementptr inbounds i8, ptr %310, i64 16
  store double %300, ptr %312, align 8
  %313 = getelementptr inbounds i8, ptr %310, i64 24
  store double %304, ptr %313, align 8
  %314 = getelementptr inbounds i8, ptr %310, i64 32
  store double %230, ptr %314, align 8
  %315 = getelementptr inbounds i8, ptr %310, i64 40
  store double %308, ptr %315, align 8
  %316 = getelementptr inbounds i8, ptr %310, i64 48
  store double 0x7FF8000000000000, ptr %316, align 8
  %317 = getelementptr inbounds i8, ptr %310, i64 56
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %317, i8 0, i64 16, i1 false)
  %318 = load ptr, ptr %196, align 8
  %319 = getelementptr inbounds i64, ptr %318, i64 %218
  %320 = load i64, ptr %319, align 8
  %321 = load i64, ptr %197, align 8
  %322 = srem i64 %320, %321
  %323 = load ptr, ptr %202, align 8
  %324 = add nsw i64 %217, 1
  %325 = getelementptr inbounds i64, ptr %323, i64 %217
  store i64 %322, ptr %325, align 8
  %326 = load i64, ptr %91, align 8
  br label %327

327:                                              ; preds = %289, %282, %275
  %328 = phi i64 [ %326, %289 ], [ %215, %282 ], [ %215, %275 ]
  %329 = phi ptr [ %318, %289 ], [ %216, %282 ], [ %216, %275 ]
  %330 = phi i64 [ %324, %289 ], [ %217, %282 ], [ %217, %275 ]
  %331 = add nuw nsw i64 %218, 1
  %332 = icmp slt i64 %331, %328
  br i1 %332, label %214, label %204

333:                                              ; preds = %345, %204
  %334 = phi i64 [ %205, %204 ], [ %368, %345 ]
  %335 = icmp sgt i64 %334, 0
  br i1 %335, label %338, label %336

336:                                              ; preds = %333
  %337 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 21
  store i64 %334, ptr %337, align 8
  store i64 2, ptr %1, align 8
  br label %396

338:                                              ; preds = %333
  %339 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 3
  %340 = load ptr, ptr %339, align 8
  %341 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  %342 = load ptr, ptr %341, align 8
  %343 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 23
  %344 = load ptr, ptr %343, align 8
  br label %373

345:                                              ; preds = %345, %209
  %346 = phi i64 [ %205, %209 ], [ %368, %345 ]
  %347 = phi i64 [ 0, %209 ], [ %370, %345 ]
  %348 = load ptr, ptr %210, align 8
  %349 = getelementptr inbounds double, ptr %348, i64 %347
  %350 = load double, ptr %349, align 8
  %351 = fsub double %350, %193
  %352 = tail call double @llvm.maxnum.f64(double %351, double 0.000000e+00)
  %353 = fadd double %193, %350
  %354 = tail call double @llvm.minnum.f64(double %353, double 1.000000e+00)
  %355 = load ptr, ptr %211, align 8
  %356 = getelementptr inbounds %struct.Bracket, ptr %355, i64 %346
  store double %352, ptr %356, align 8
  %357 = getelementptr inbounds i8, ptr %356, i64 8
  store double %350, ptr %357, align 8
  %358 = getelementptr inbounds i8, ptr %356, i64 16
  store double %354, ptr %358, align 8
  %359 = getelementptr inbounds i8, ptr %356, i64 24
  store double 0x7FF8000000000000, ptr %359, align 8
  %360 = getelementptr inbounds i8, ptr %356, i64 32
  store double 0x7FF8000000000000, ptr %360, align 8
  %361 = getelementptr inbounds i8, ptr %356, i64 40
  store double 0x7FF8000000000000, ptr %361, align 8
  %362 = getelementptr inbounds i8, ptr %356, i64 48
  store double 0x7FF8000000000000, ptr %362, align 8
  %363 = getelementptr inbounds i8, ptr %356, i64 56
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %363, i8 0, i64 16, i1 false)
  %364 = load ptr, ptr %212, align 8
  %365 = getelementptr inbounds i64, ptr %364, i64 %347
  %366 = load i64, ptr %365, align 8
  %367 = load ptr, ptr %213, align 8
  %368 = add nsw i64 %346, 1
  %369 = getelementptr inbounds i64, ptr %367, i64 %346
  store i64 %366, ptr %369, align 8
  %370 = add nuw nsw i64 %347, 1
  %371 = load i64, ptr %206, align 8
  %372 = icmp slt i64 %370, %371
  br i1 %372, label %345, label %333

373:                                              ; preds = %373, %338
  %374 = phi i64 [ 0, %338 ], [ %389, %373 ]
  %375 = getelementptr inbounds i64, ptr %342, i64 %374
  %376 = shl nuw nsw i64 %374, 1
  %377 = load i64, ptr %375, align 8
  %378 = shl nsw i64 %377, 1
  %379 = getelementptr inbounds i64, ptr %340, i64 %378
  %380 = load i64, ptr %379, align 8
  %381 = getelementptr inbounds i64, ptr %344, i64 %376
  store i64 %380, ptr %381, align 8
  %382 = load i64, ptr %375, align 8
  %383 = shl nsw i64 %382, 1
  %384 = or i64 %383, 1
  %385 = getelementptr inbounds i64, ptr %340, i64 %384
  %386 = load i64, ptr %385, align 8
  %387 = or i64 %376, 1
  %388 = getelementptr inbounds i64, ptr %344, i64 %387
  store i64 %386, ptr %388, align 8
  %389 = add nuw nsw i64 %374, 1
  %390 = icmp eq i64 %389, %334
  br i1 %390, label %391, label %373

391:                                              ; preds = %373
  %392 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 21
  store i64 %334, ptr %392, align 8
  store i64 2, ptr %1, align 8
  br i1 %335, label %393, label %396

393:                                              ; preds = %391
  %394 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %395 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 23
  br label %400

396:                                              ; preds = %336, %391
  %397 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  br label %587

398:                                              ; preds = %440
  %399 = icmp eq i64 %444, 0
  br i1 %399, label %448, label %667

400:                                              ; preds = %393, %440
  %401 = phi i64 [ 0, %393 ], [ %444, %440 ]
  %402 = phi i64 [ 0, %393 ], [ %445, %440 ]
  %403 = load ptr, ptr %394, align 8
  %404 = getelementptr inbounds %struct.Bracket, ptr %403, i64 %402
  %405 = load ptr, ptr %395, align 8
  %406 = shl nuw nsw i64 %402, 1
  %407 = getelementptr inbounds i64, ptr %405, i64 %406
  call void @llvm.lifetime.start.p0(i64 176, ptr nonnull %6) #6
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(176) %6, i8 0, i64 176, i1 false)
  %408 = getelementptr inbounds %struct.Bracket, ptr %403, i64 %402, i32 4
  %409 = load double, ptr %408, align 8
  %410 = fcmp uno double %409, 0.000000e+00
  br i1 %410, label %411, label %415

411:                                              ; preds = %400
  %412 = getelementptr inbounds %struct.Bracket, ptr %403, i64 %402, i32 1
  %413 = load double, ptr %412, align 8
  %414 = call fastcc double @distance_at(ptr noundef %0, double noundef %413, ptr noundef %407, ptr noundef nonnull %6)
  store double %414, ptr %408, align 8
  br label %415

415:                                              ; preds = %411, %400
  %416 = getelementptr inbounds %struct.Bracket, ptr %403, i64 %402, i32 3
  %417 = load double, ptr %416, align 8
  %418 = fcmp uno double %417, 0.000000e+00
  br i1 %418, label %419, label %422

419:                                              ; preds = %415
  %420 = load double, ptr %404, align 8
  %421 = call fastcc double @distance_at(ptr noundef %0, double noundef %420, ptr noundef %407, ptr noundef nonnull %6)
  store double %421, ptr %416, align 8
  br label %422

422:                                              ; preds = %419, %415
  %423 = getelementptr inbounds %struct.Bracket, ptr %403, i64 %402, i32 5
  %424 = load double, ptr %423, align 8
  %425 = fcmp uno double %424, 0.000000e+00
  br i1 %425, label %426, label %430

426:                                              ; preds = %422
  %427 = getelementptr inbounds %struct.Bracket, ptr %403, i64 %402, i32 2
  %428 = load double, ptr %427, align 8
  %429 = call fastcc double @distance_at(ptr noundef %0, double noundef %428, ptr noundef %407, ptr noundef nonnull %6)
  store double %429, ptr %423, align 8
  br label %430

430:                                              ; preds = %426, %422
  %431 = phi double [ %429, %426 ], [ %424, %422 ]
  %432 = load double, ptr %408, align 8
  %433 = fcmp uno double %432, 0.000000e+00
  br i1 %433, label %440, label %434

434:                                              ; preds = %430
  %435 = load double, ptr %416, align 8
  %436 = fcmp uno double %435, 0.000000e+00
  br i1 %436, label %440, label %437

437:                                              ; preds = %434
  %438 = fcmp ord double %431, 0.000000e+00
  %439 = zext i1 %438 to i32
  br label %440

440:                                              ; preds = %430, %434, %437
  %441 = phi i32 [ 0, %434 ], [ 0, %430 ], [ %439, %437 ]
  call void @llvm.lifetime.end.p0(i64 176, ptr nonnull %6) #6
  %442 = icmp eq i32 %441, 0
  %443 = zext i1 %442 to i64
  %444 = add nuw nsw i64 %401, %443
  %445 = add nuw nsw i64 %402, 1
  %446 = load i64, ptr %392, align 8
  %447 = icmp slt i64 %445, %446
  br i1 %447, label %400, label %398

448:                                              ; preds = %8, %398
  %449 = phi i64 [ %10, %8 ], [ %446, %398 ]
  %450 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 23
  %451 = load ptr, ptr %450, align 8
  %452 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %453 = load ptr, ptr %452, align 8
  %454 = icmp sgt i64 %449, 0
  br i1 %454, label %455, label %587

455:                                              ; preds = %448
  %456 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 8
  %457 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 7
  br label %458

458:                                              ; preds = %581, %455
  %459 = phi i64 [ 0, %455 ], [ %582, %581 ]
  %460 = phi i64 [ 0, %455 ], [ %583, %581 ]
  %461 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460
  call void @llvm.lifetime.start.p0(i64 176, ptr nonnull %5) #6
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(176) %5, i8 0, i64 176, i1 false)
  %462 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 6
  %463 = load double, ptr %462, align 8
  %464 = fcmp uno double %463, 0.000000e+00
  br i1 %464, label %465, label %468

465:                                              ; preds = %458
  %466 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 8
  %467 = load i64, ptr %466, align 8
  br label %493

468:                                              ; preds = %458
  %469 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 7
  %470 = load double, ptr %469, align 8
  %471 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 4
  %472 = load double, ptr %471, align 8
  %473 = fcmp ogt double %472, %470
  %474 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 1
  %475 = load double, ptr %474, align 8
  %476 = fcmp olt double %475, %463
  %477 = select i1 %473, double %475, double %463
  br i1 %473, label %479, label %478

478:                                              ; preds = %468
  br i1 %476, label %483, label %480

479:                                              ; preds = %468
  br i1 %476, label %480, label %483

480:                                              ; preds = %479, %478
  %481 = phi double [ %470, %478 ], [ %472, %479 ]
  store double %477, ptr %461, align 8
  %482 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 3
  store double %481, ptr %482, align 8
  br label %487

483:                                              ; preds = %479, %478
  %484 = phi double [ %470, %478 ], [ %472, %479 ]
  %485 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 2
  store double %477, ptr %485, align 8
  %486 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 5
  store double %484, ptr %486, align 8
  br label %487

487:                                              ; preds = %483, %480
  br i1 %473, label %488, label %489

488:                                              ; preds = %487
  store double %463, ptr %474, align 8
  store double %470, ptr %471, align 8
  br label %489

489:                                              ; preds = %488, %487
  %490 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 8
  %491 = load i64, ptr %490, align 8
  %492 = add nsw i64 %491, 1
  store i64 %492, ptr %490, align 8
  store double 0x7FF8000000000000, ptr %462, align 8
  br label %493

493:                                              ; preds = %489, %465
  %494 = phi i64 [ %467, %465 ], [ %492, %489 ]
  %495 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 8
  %496 = load i64, ptr %456, align 8
  %497 = icmp slt i64 %494, %496
  br i1 %497, label %498, label %581

498:                                              ; preds = %493
  %499 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 2
  %500 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 1
  %501 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 3
  %502 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 4
  %503 = getelementptr inbounds %struct.Bracket, ptr %453, i64 %460, i32 5
  %504 = shl nuw nsw i64 %460, 1
  %505 = getelementptr inbounds i64, ptr %451, i64 %504
  br label %506

506:                                              ; preds = %576, %498
  %507 = phi i64 [ %494, %498 ], [ %578, %576 ]
  %508 = load double, ptr %499, align 8
  %509 = load double, ptr %461, align 8
  %510 = fsub double %508, %509
  %511 = load double, ptr %457, align 8
  %512 = fcmp ult double %510, %511
  br i1 %512, label %581, label %513

513:                                              ; preds = %506
  %514 = load double, ptr %500, align 8
  %515 = fsub double %514, %509
  %516 = fsub double %508, %514
  %517 = fcmp ogt double %515, %516
  %518 = fmul double %515, -5.000000e-01
  %519 = fmul double %516, 5.000000e-01
  %520 = select i1 %517, double %518, double %519
  %521 = load double, ptr %501, align 8
  %522 = load double, ptr %502, align 8
  %523 = fsub double %521, %522
  %524 = fdiv double %523, %515
  %525 = load double, ptr %503, align 8
  %526 = fsub double %525, %522
  %527 = fdiv double %526, %516
  %528 = fmul double %516, %524
  %529 = fmul double %515, %527
  %530 = fsub double %528, %529
  %531 = fadd double %524, %527
  %532 = fmul double %531, 2.000000e+00
  %533 = fdiv double %530, %532
  %534 = call double @llvm.fabs.f64(double %533) #7
  %535 = fcmp one double %534, 0x7FF0000000000000
  %536 = fneg double %515
  %537 = fcmp ogt double %533, %536
  %538 = select i1 %535, i1 %537, i1 false
  %539 = fcmp olt double %533, %516
  %540 = select i1 %538, i1 %539, i1 false
  br i1 %540, label %541, label %545

541:                                              ; preds = %513
  %542 = srem i64 %507, 3
  %543 = icmp slt i64 %542, 2
  %544 = select i1 %543, double %533, double %520
  br label %545

545:                                              ; preds = %541, %513
  %546 = phi double [ %520, %513 ], [ %544, %541 ]
  %547 = fadd double %515, %516
  %548 = fmul double %547, 2.000000e-02
  %549 = fmul double %511, 2.500000e-01
  %550 = call double @llvm.maxnum.f64(double %548, double %549)
  %551 = call double @llvm.fabs.f64(double %546)
  %552 = fcmp olt double %551, %550
  %553 = call double @llvm.copysign.f64(double %550, double %520)
  %554 = select i1 %552, double %553, double %546
  %555 = fadd double %514, %554
  %556 = call double @llvm.maxnum.f64(double %555, double %509)
  %557 = call double @llvm.minnum.f64(double %556, double %508)
  %558 = call fastcc double @distance_at(ptr noundef nonnull %0, double noundef %557, ptr noundef %505, ptr noundef nonnull %5)
  %559 = fcmp uno double %558, 0.000000e+00
  br i1 %559, label %560, label %562

560:                                              ; preds = %545
  store double %557, ptr %462, align 8
  %561 = add nsw i64 %459, 1
  br label %581

562:                                              ; preds = %545
  %563 = load double, ptr %502, align 8
  %564 = fcmp ogt double %563, %558
  %565 = load double, ptr %500, align 8
  %566 = fcmp olt double %565, %557
  %567 = select i1 %564, double %565, double %557
  br i1 %564, label %569, label %568

568:                                              ; preds = %562
  br i1 %566, label %572, label %570

569:                                              ; preds = %562
  br i1 %566, label %570, label %572

570:                                              ; preds = %569, %568
  %571 = phi double [ %558, %568 ], [ %563, %569 ]
  store double %567, ptr %461, align 8
  store double %571, ptr %501, align 8
  br label %574

572:                                              ; preds = %569, %568
  %573 = phi double [ %558, %568 ], [ %563, %569 ]
  store double %567, ptr %499, align 8
  store double %573, ptr %503, align 8
  br label %574

574:                                              ; preds = %572, %570
  br i1 %564, label %575, label %576

575:                                              ; preds = %574
  store double %557, ptr %500, align 8
  store double %558, ptr %502, align 8
  br label %576

576:                                              ; preds = %575, %574
  %577 = load i64, ptr %495, align 8
  %578 = add nsw i64 %577, 1
  store i64 %578, ptr %495, align 8
  %579 = load i64, ptr %456, align 8
  %580 = icmp slt i64 %578, %579
  br i1 %580, label %506, label %581

581:                                              ; preds = %576, %506, %560, %493
  %582 = phi i64 [ %561, %560 ], [ %459, %493 ], [ %459, %506 ], [ %459, %576 ]
  call void @llvm.lifetime.end.p0(i64 176, ptr nonnull %5) #6
  %583 = add nuw nsw i64 %460, 1
  %584 = icmp eq i64 %583, %449
  br i1 %584, label %585, label %458

585:                                              ; preds = %581
  %586 = icmp eq i64 %582, 0
  br i1 %586, label %587, label %667

587:                                              ; preds = %396, %448, %585
  %588 = phi ptr [ %452, %585 ], [ %397, %396 ], [ %452, %448 ]
  %589 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 21
  %590 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  %591 = load i64, ptr %590, align 8
  %592 = icmp sgt i64 %591, 0
  br i1 %592, label %593, label %601

593:                                              ; preds = %587
  %594 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 18
  %595 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 2
  %596 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %597 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 8
  %598 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 9
  %599 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 6
  %600 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 7
  br label %607

601:                                              ; preds = %641, %587
  %602 = phi i64 [ 0, %587 ], [ %643, %641 ]
  %603 = load i64, ptr %589, align 8
  %604 = icmp sgt i64 %603, 0
  br i1 %604, label %605, label %646

605:                                              ; preds = %601
  %606 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 22
  br label %648

607:                                              ; preds = %593, %641
  %608 = phi i64 [ %591, %593 ], [ %642, %641 ]
  %609 = phi i64 [ 0, %593 ], [ %643, %641 ]
  %610 = phi i64 [ 0, %593 ], [ %644, %641 ]
  %611 = load ptr, ptr %594, align 8
  %612 = getelementptr inbounds i64, ptr %611, i64 %610
  %613 = load i64, ptr %612, align 8
  %614 = load i64, ptr %595, align 8
  %615 = sdiv i64 %613, %614
  %616 = srem i64 %613, %614
  %617 = load ptr, ptr %596, align 8
  %618 = getelementptr inbounds double, ptr %617, i64 %610
  %619 = load double, ptr %618, align 8
  %620 = load double, ptr %597, align 8
  %621 = load double, ptr %598, align 8
  %622 = fadd double %620, %621
  %623 = fcmp olt double %619, %622
  br i1 %623, label %631, label %624

624:                                              ; preds = %607
  %625 = load i64, ptr %599, align 8
  %626 = srem i64 %615, %625
  %627 = icmp eq i64 %626, 0
  %628 = fadd double %620, %2
  %629 = fcmp olt double %619, %628
  %630 = select i1 %627, i1 %629, i1 false
  br i1 %630, label %631, label %641

631:                                              ; preds = %624, %607
  %632 = load ptr, ptr %600, align 8
  %633 = getelementptr inbounds double, ptr %632, i64 %615
  %634 = load double, ptr %633, align 8
  %635 = add nsw i64 %609, 1
  %636 = getelementptr inbounds %struct.Found, ptr %3, i64 %609
  store double %619, ptr %636, align 8
  %637 = getelementptr inbounds i8, ptr %636, i64 8
  store double %634, ptr %637, align 8
  %638 = getelementptr inbounds i8, ptr %636, i64 16
  store i64 %616, ptr %638, align 8
  %639 = getelementptr inbounds i8, ptr %636, i64 24
  store i64 0, ptr %639, align 8
  %640 = load i64, ptr %590, align 8
  br label %641

641:                                              ; preds = %624, %631
  %642 = phi i64 [ %640, %631 ], [ %608, %624 ]
  %643 = phi i64 [ %635, %631 ], [ %609, %624 ]
  %644 = add nuw nsw i64 %610, 1
  %645 = icmp slt i64 %644, %642
  br i1 %645, label %607, label %601

646:                                              ; preds = %648, %601
  %647 = phi i64 [ %602, %601 ], [ %659, %648 ]
  call void @qsort(ptr noundef %3, i64 noundef %647, i64 noundef 32, ptr noundef nonnull @order) #6
  br label %667

648:                                              ; preds = %605, %648
  %649 = phi i64 [ %602, %605 ], [ %659, %648 ]
  %650 = phi i64 [ 0, %605 ], [ %664, %648 ]
  %651 = load ptr, ptr %588, align 8
  %652 = getelementptr inbounds %struct.Bracket, ptr %651, i64 %650, i32 4
  %653 = load double, ptr %652, align 8
  %654 = getelementptr inbounds %struct.Bracket, ptr %651, i64 %650, i32 1
  %655 = load double, ptr %654, align 8
  %656 = load ptr, ptr %606, align 8
  %657 = getelementptr inbounds i64, ptr %656, i64 %650
  %658 = load i64, ptr %657, align 8
  %659 = add nsw i64 %649, 1
  %660 = getelementptr inbounds %struct.Found, ptr %3, i64 %649
  store double %653, ptr %660, align 8
  %661 = getelementptr inbounds i8, ptr %660, i64 8
  store double %655, ptr %661, align 8
  %662 = getelementptr inbounds i8, ptr %660, i64 16
  store i64 %658, ptr %662, align 8
  %663 = getelementptr inbounds i8, ptr %660, i64 24
  store i64 1, ptr %663, align 8
  %664 = add nuw nsw i64 %650, 1
  %665 = load i64, ptr %589, align 8
  %666 = icmp slt i64 %664, %665
  br i1 %666, label %648, label %646

667:                                              ; preds = %84, %585, %398, %87, %646
  %668 = phi i64 [ %647, %646 ], [ -1, %87 ], [ -1, %398 ], [ -1, %585 ], [ -2, %84 ]
  ret i64 %668
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


