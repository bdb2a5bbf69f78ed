; distances.c 8df06c7c6055e3c939f9f5226fbb9b5dcd0745627039999ba20f87e0ed80878b: written by make kernel

%struct.Core = type { i64, i64, ptr, ptr, ptr, ptr, ptr, [12 x double] }
%struct.Search = type { ptr, i64, ptr, ptr, i64, double, ptr, ptr, i32, i64, %struct.Plane, ptr, i64, i32, i32, ptr, ptr, i32, double }
%struct.Plane = type { [3 x double], double }
%struct.World = type { i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, i64, ptr, i64, ptr, ptr, i64, ptr, ptr, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr }
%struct.Simplex = type { [4 x [3 x double]], [4 x [3 x double]], i32, [3 x double] }
%struct.Two = type { ptr, i64, [12 x double], [9 x double], double, [3 x double] }
%struct.Face = type { [3 x i32], [3 x double], double }
%struct.Part = type { i64, i64, i64 }

@hull_core.still = internal constant [12 x double] [double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00], align 16
@reduce.face = internal unnamed_addr constant [4 x [3 x i32]] [[3 x i32] [i32 0, i32 1, i32 2], [3 x i32] [i32 0, i32 1, i32 3], [3 x i32] [i32 0, i32 2, i32 3], [3 x i32] [i32 1, i32 2, i32 3]], align 16
@__const.reduce.chosen = private unnamed_addr constant [3 x i32] [i32 0, i32 1, i32 2], align 4
@within.ray = internal constant [3 x [3 x double]] [[3 x double] [double 6.123720e-01, double 3.535530e-01, double 7.071070e-01], [3 x double] [double -4.177900e-01, double 0x3FEA99C38B04AB60, double -3.670100e-01], [3 x double] [double 1.173100e-01, double -5.144900e-01, double -8.494300e-01]], align 16
@box_core.straight = internal unnamed_addr constant [9 x double] [double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00], align 16
@begin.solid = internal unnamed_addr constant [4 x [3 x i32]] [[3 x i32] [i32 0, i32 2, i32 1], [3 x i32] [i32 0, i32 1, i32 3], [3 x i32] [i32 0, i32 3, i32 2], [3 x i32] [i32 1, i32 2, i32 3]], align 16
@begin.beside = internal unnamed_addr constant [6 x [3 x i32]] [[3 x i32] [i32 0, i32 1, i32 3], [3 x i32] [i32 1, i32 2, i32 3], [3 x i32] [i32 2, i32 0, i32 3], [3 x i32] [i32 1, i32 0, i32 4], [3 x i32] [i32 2, i32 1, i32 4], [3 x i32] [i32 0, i32 2, i32 4]], align 16
@begin.around = internal unnamed_addr constant [6 x [3 x i32]] [[3 x i32] [i32 2, i32 3, i32 1], [3 x i32] [i32 3, i32 4, i32 1], [3 x i32] [i32 4, i32 2, i32 1], [3 x i32] [i32 3, i32 2, i32 0], [3 x i32] [i32 4, i32 3, i32 0], [3 x i32] [i32 2, i32 4, i32 0]], align 16
@place.still = internal constant [12 x double] [double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00], align 16
@__const.nearest_of.share = private unnamed_addr constant [3 x double] [double 1.000000e+00, double 0.000000e+00, double 0.000000e+00], align 16

define dso_local i32 @manipplan_check_one(ptr noundef %0, ptr nocapture noundef readonly %1, double noundef %2) local_unnamed_addr #0 {
  %4 = tail call fastcc i32 @examine(ptr noundef %0, ptr noundef %1, double noundef %2, ptr noundef null, ptr noundef null)
  ret i32 %4
}

define internal fastcc i32 @examine(ptr noundef %0, ptr nocapture noundef readonly %1, double noundef %2, ptr noundef %3, ptr noundef %4) unnamed_addr #0 {
  %6 = alloca [3 x double], align 16
  %7 = alloca %struct.Core, align 8
  %8 = alloca %struct.Search, align 8
  %9 = alloca %struct.Core, align 8
  %10 = alloca %struct.Search, align 8
  %11 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %27, label %47

14:                                               ; preds = %27
  %15 = icmp eq i32 %35, 0
  br i1 %15, label %16, label %47

16:                                               ; preds = %14
  %17 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %18 = icmp eq ptr %3, null
  br i1 %18, label %250, label %19

19:                                               ; preds = %16
  %20 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 44
  %21 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 45
  %22 = load i64, ptr %17, align 8
  %23 = icmp sgt i64 %22, 0
  br i1 %23, label %24, label %250

24:                                               ; preds = %19
  %25 = load ptr, ptr %20, align 8
  %26 = load ptr, ptr %21, align 8
  br label %38

27:                                               ; preds = %5, %27
  %28 = phi i32 [ %35, %27 ], [ 1, %5 ]
  %29 = phi i64 [ %36, %27 ], [ 0, %5 ]
  %30 = getelementptr inbounds double, ptr %1, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = tail call double @llvm.fabs.f64(double %31) #18
  %33 = fcmp one double %32, 0x7FF0000000000000
  %34 = zext i1 %33 to i32
  %35 = and i32 %28, %34
  %36 = add nuw nsw i64 %29, 1
  %37 = icmp eq i64 %36, %12
  br i1 %37, label %14, label %27

38:                                               ; preds = %24, %38
  %39 = phi i64 [ %44, %38 ], [ 0, %24 ]
  %40 = getelementptr inbounds double, ptr %25, i64 %39
  store double 0x7FF8000000000000, ptr %40, align 8
  %41 = load i64, ptr %3, align 8
  %42 = add nsw i64 %41, 1
  store i64 %42, ptr %3, align 8
  %43 = getelementptr inbounds i64, ptr %26, i64 %41
  store i64 %39, ptr %43, align 8
  %44 = add nuw nsw i64 %39, 1
  %45 = load i64, ptr %17, align 8
  %46 = icmp slt i64 %44, %45
  br i1 %46, label %38, label %250

47:                                               ; preds = %5, %14
  %48 = icmp eq ptr %3, null
  br i1 %48, label %52, label %49

49:                                               ; preds = %47
  %50 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 44
  %51 = load ptr, ptr %50, align 8
  br label %52

52:                                               ; preds = %47, %49
  %53 = phi ptr [ %51, %49 ], [ null, %47 ]
  tail call fastcc void @place(ptr noundef nonnull %0, ptr noundef %1)
  %54 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 28
  %55 = load i64, ptr %54, align 8
  %56 = icmp sgt i64 %55, 0
  br i1 %56, label %57, label %166

57:                                               ; preds = %52
  %58 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 32
  %59 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 29
  %60 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 30
  %61 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 42
  %62 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 1
  %63 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 26
  %64 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 2
  %65 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 3
  %66 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 27
  %67 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 10
  %68 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 4
  %69 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 5
  %70 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 6
  %71 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 7
  %72 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 8
  %73 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 9
  %74 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 10
  %75 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 11
  %76 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 12
  %77 = getelementptr inbounds %struct.Search, ptr %8, i64 0, i32 18
  %78 = icmp ne ptr %53, null
  br label %79

79:                                               ; preds = %57, %161
  %80 = phi i64 [ %55, %57 ], [ %162, %161 ]
  %81 = phi i32 [ 0, %57 ], [ %163, %161 ]
  %82 = phi i64 [ 0, %57 ], [ %164, %161 ]
  %83 = load i64, ptr %58, align 8
  %84 = icmp sgt i64 %83, -1
  br i1 %84, label %85, label %166

85:                                               ; preds = %79
  %86 = load ptr, ptr %59, align 8
  %87 = mul nsw i64 %82, 3
  %88 = getelementptr inbounds i64, ptr %86, i64 %87
  %89 = load ptr, ptr %60, align 8
  %90 = shl nsw i64 %82, 2
  %91 = getelementptr inbounds double, ptr %89, i64 %90
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #19
  %92 = getelementptr inbounds double, ptr %91, i64 3
  %93 = load double, ptr %92, align 8
  %94 = load ptr, ptr %61, align 8
  %95 = load i64, ptr %88, align 8
  %96 = mul nsw i64 %95, 12
  %97 = getelementptr inbounds double, ptr %94, i64 %96
  %98 = getelementptr inbounds double, ptr %91, i64 1
  %99 = getelementptr inbounds double, ptr %91, i64 2
  br label %100

100:                                              ; preds = %100, %85
  %101 = phi i64 [ 0, %85 ], [ %124, %100 ]
  %102 = mul nuw nsw i64 %101, 3
  %103 = getelementptr inbounds double, ptr %97, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = load double, ptr %91, align 8
  %106 = fmul double %104, %105
  %107 = add nuw nsw i64 %102, 1
  %108 = getelementptr inbounds double, ptr %97, i64 %107
  %109 = load double, ptr %108, align 8
  %110 = load double, ptr %98, align 8
  %111 = fmul double %109, %110
  %112 = fadd double %106, %111
  %113 = add nuw nsw i64 %102, 2
  %114 = getelementptr inbounds double, ptr %97, i64 %113
  %115 = load double, ptr %114, align 8
  %116 = load double, ptr %99, align 8
  %117 = fmul double %115, %116
  %118 = fadd double %112, %117
  %119 = add nuw nsw i64 %101, 9
  %120 = getelementptr inbounds double, ptr %97, i64 %119
  %121 = load double, ptr %120, align 8
  %122 = fadd double %121, %118
  %123 = getelementptr inbounds double, ptr %6, i64 %101
  store double %122, ptr %123, align 8
  %124 = add nuw nsw i64 %101, 1
  %125 = icmp eq i64 %124, 3
  br i1 %125, label %126, label %100

126:                                              ; preds = %100
  %127 = fadd double %93, %2
  %128 = fmul double %127, %127
  %129 = call fastcc i32 @is_near(ptr noundef %0, ptr noundef nonnull %6, double noundef %128, i64 noundef %83)
  %130 = icmp eq i32 %129, 0
  br i1 %130, label %161, label %131

131:                                              ; preds = %126
  %132 = getelementptr inbounds i64, ptr %88, i64 1
  %133 = getelementptr inbounds i64, ptr %88, i64 2
  %134 = load i64, ptr %133, align 8
  %135 = icmp sgt i64 %134, 0
  br i1 %135, label %136, label %161

136:                                              ; preds = %131
  %137 = load i64, ptr %132, align 8
  br label %144

138:                                              ; preds = %144
  %139 = add nsw i64 %146, 1
  %140 = load i64, ptr %132, align 8
  %141 = load i64, ptr %133, align 8
  %142 = add nsw i64 %141, %140
  %143 = icmp slt i64 %139, %142
  br i1 %143, label %144, label %159

144:                                              ; preds = %136, %138
  %145 = phi i32 [ %155, %138 ], [ %81, %136 ]
  %146 = phi i64 [ %139, %138 ], [ %137, %136 ]
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %7) #19
  call void @llvm.lifetime.start.p0(i64 168, ptr nonnull %8) #19
  store ptr %0, ptr %8, align 8
  %147 = load ptr, ptr %63, align 8
  %148 = getelementptr inbounds i64, ptr %147, i64 %146
  %149 = load i64, ptr %148, align 8
  store i64 %149, ptr %62, align 8
  store ptr %7, ptr %64, align 8
  %150 = load ptr, ptr %66, align 8
  %151 = load i64, ptr %67, align 8
  %152 = mul nsw i64 %151, %146
  %153 = getelementptr inbounds i64, ptr %150, i64 %152
  store ptr %153, ptr %65, align 8
  store i64 -1, ptr %68, align 8
  store double %2, ptr %69, align 8
  store ptr %53, ptr %70, align 8
  store ptr %3, ptr %71, align 8
  store i32 %145, ptr %72, align 8
  store i64 -1, ptr %73, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %74, i8 0, i64 32, i1 false)
  store ptr %4, ptr %75, align 8
  store double 0.000000e+00, ptr %77, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(36) %76, i8 0, i64 36, i1 false)
  call fastcc void @core_of(ptr noundef %0, i64 noundef %149, ptr noundef nonnull %7)
  %154 = load i64, ptr %58, align 8
  call fastcc void @descend(ptr noundef nonnull %8, i64 noundef %154)
  %155 = load i32, ptr %72, align 8
  %156 = icmp ne i32 %155, 1
  %157 = select i1 %78, i1 true, i1 %156
  call void @llvm.lifetime.end.p0(i64 168, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %7) #19
  br i1 %157, label %138, label %158

158:                                              ; preds = %144
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #19
  br label %250

159:                                              ; preds = %138
  %160 = load i64, ptr %54, align 8
  br label %161

161:                                              ; preds = %159, %131, %126
  %162 = phi i64 [ %80, %126 ], [ %80, %131 ], [ %160, %159 ]
  %163 = phi i32 [ %81, %126 ], [ %81, %131 ], [ %155, %159 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #19
  %164 = add nuw nsw i64 %82, 1
  %165 = icmp slt i64 %164, %162
  br i1 %165, label %79, label %166

166:                                              ; preds = %161, %79, %52
  %167 = phi i32 [ 0, %52 ], [ %81, %79 ], [ %163, %161 ]
  %168 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 23
  %169 = load i64, ptr %168, align 8
  %170 = icmp sgt i64 %169, 0
  br i1 %170, label %171, label %250

171:                                              ; preds = %166
  %172 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 24
  %173 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 43
  %174 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 18
  %175 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 1
  %176 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 2
  %177 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 3
  %178 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 4
  %179 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 5
  %180 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 6
  %181 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 7
  %182 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 8
  %183 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 9
  %184 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 10
  %185 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 11
  %186 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 12
  %187 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 18
  %188 = icmp eq ptr %53, null
  br label %189

189:                                              ; preds = %171, %245
  %190 = phi i64 [ %169, %171 ], [ %246, %245 ]
  %191 = phi i32 [ %167, %171 ], [ %247, %245 ]
  %192 = phi i64 [ 0, %171 ], [ %248, %245 ]
  %193 = load ptr, ptr %172, align 8
  %194 = mul nuw nsw i64 %192, 3
  %195 = getelementptr inbounds i64, ptr %193, i64 %194
  %196 = load i64, ptr %195, align 8
  %197 = add nuw nsw i64 %194, 1
  %198 = getelementptr inbounds i64, ptr %193, i64 %197
  %199 = load i64, ptr %198, align 8
  %200 = load ptr, ptr %173, align 8
  %201 = mul nsw i64 %196, 3
  %202 = getelementptr inbounds double, ptr %200, i64 %201
  %203 = mul nsw i64 %199, 3
  %204 = getelementptr inbounds double, ptr %200, i64 %203
  %205 = load double, ptr %202, align 8
  %206 = load double, ptr %204, align 8
  %207 = fsub double %205, %206
  %208 = getelementptr inbounds double, ptr %202, i64 1
  %209 = load double, ptr %208, align 8
  %210 = getelementptr inbounds double, ptr %204, i64 1
  %211 = load double, ptr %210, align 8
  %212 = fsub double %209, %211
  %213 = getelementptr inbounds double, ptr %202, i64 2
  %214 = load double, ptr %213, align 8
  %215 = getelementptr inbounds double, ptr %204, i64 2
  %216 = load double, ptr %215, align 8
  %217 = fsub double %214, %216
  %218 = load ptr, ptr %174, align 8
  %219 = shl nsw i64 %196, 2
  %220 = or i64 %219, 3
  %221 = getelementptr inbounds double, ptr %218, i64 %220
  %222 = load double, ptr %221, align 8
  %223 = fadd double %222, %2
  %224 = shl nsw i64 %199, 2
  %225 = or i64 %224, 3
  %226 = getelementptr inbounds double, ptr %218, i64 %225
  %227 = load double, ptr %226, align 8
  %228 = fadd double %223, %227
  %229 = fmul double %207, %207
  %230 = fmul double %212, %212
  %231 = fadd double %229, %230
  %232 = fmul double %217, %217
  %233 = fadd double %231, %232
  %234 = fmul double %228, %228
  %235 = fcmp ogt double %233, %234
  br i1 %235, label %245, label %236

236:                                              ; preds = %189
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %9) #19
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %196, ptr noundef nonnull %9)
  call void @llvm.lifetime.start.p0(i64 168, ptr nonnull %10) #19
  store ptr %0, ptr %10, align 8
  store i64 %196, ptr %175, align 8
  store ptr %9, ptr %176, align 8
  store ptr null, ptr %177, align 8
  %237 = add nuw nsw i64 %194, 2
  %238 = getelementptr inbounds i64, ptr %193, i64 %237
  %239 = load i64, ptr %238, align 8
  store i64 %239, ptr %178, align 8
  store double %2, ptr %179, align 8
  store ptr %53, ptr %180, align 8
  store ptr %3, ptr %181, align 8
  store i32 %191, ptr %182, align 8
  store i64 -1, ptr %183, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %184, i8 0, i64 32, i1 false)
  store ptr %4, ptr %185, align 8
  store double 0.000000e+00, ptr %187, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(36) %186, i8 0, i64 36, i1 false)
  call fastcc void @look_at(ptr noundef nonnull %10, i64 noundef %199, ptr noundef null)
  %240 = load i32, ptr %182, align 8
  %241 = icmp eq i32 %240, 1
  %242 = select i1 %188, i1 %241, i1 false
  call void @llvm.lifetime.end.p0(i64 168, ptr nonnull %10) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %9) #19
  br i1 %242, label %250, label %243

243:                                              ; preds = %236
  %244 = load i64, ptr %168, align 8
  br label %245

245:                                              ; preds = %243, %189
  %246 = phi i64 [ %190, %189 ], [ %244, %243 ]
  %247 = phi i32 [ %191, %189 ], [ %240, %243 ]
  %248 = add nuw nsw i64 %192, 1
  %249 = icmp slt i64 %248, %246
  br i1 %249, label %189, label %250

250:                                              ; preds = %236, %245, %38, %19, %166, %16, %158
  %251 = phi i32 [ 1, %158 ], [ 2, %16 ], [ %167, %166 ], [ 2, %19 ], [ 2, %38 ], [ 1, %236 ], [ %247, %245 ]
  ret i32 %251
}

define dso_local void @manipplan_check(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, double noundef %3, ptr nocapture noundef writeonly %4) local_unnamed_addr #0 {
  %6 = icmp sgt i64 %2, 0
  br i1 %6, label %7, label %9

7:                                                ; preds = %5
  %8 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  br label %10

9:                                                ; preds = %10, %5
  ret void

10:                                               ; preds = %7, %10
  %11 = phi i64 [ 0, %7 ], [ %18, %10 ]
  %12 = load i64, ptr %8, align 8
  %13 = mul nsw i64 %12, %11
  %14 = getelementptr inbounds double, ptr %1, i64 %13
  %15 = tail call fastcc i32 @examine(ptr noundef %0, ptr noundef %14, double noundef %3, ptr noundef null, ptr noundef null)
  %16 = trunc i32 %15 to i8
  %17 = getelementptr inbounds i8, ptr %4, i64 %11
  store i8 %16, ptr %17, align 1
  %18 = add nuw nsw i64 %11, 1
  %19 = icmp eq i64 %18, %2
  br i1 %19, label %9, label %10
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

define dso_local void @manipplan_distances(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef writeonly %4) local_unnamed_addr #0 {
  %6 = alloca i64, align 8
  %7 = icmp slt i64 %2, 2
  br i1 %7, label %25, label %8

8:                                                ; preds = %5
  %9 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %10 = load i64, ptr %9, align 8
  %11 = icmp sgt i64 %10, 0
  br i1 %11, label %12, label %14

12:                                               ; preds = %8
  %13 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 46
  br label %17

14:                                               ; preds = %17, %8
  %15 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 46
  %16 = load ptr, ptr %15, align 8
  br label %25

17:                                               ; preds = %17, %12
  %18 = phi i64 [ 0, %12 ], [ %22, %17 ]
  %19 = load ptr, ptr %13, align 8
  %20 = mul nuw nsw i64 %18, 22
  %21 = getelementptr inbounds double, ptr %19, i64 %20
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %21, i8 0, i64 24, i1 false)
  %22 = add nuw nsw i64 %18, 1
  %23 = load i64, ptr %9, align 8
  %24 = icmp slt i64 %22, %23
  br i1 %24, label %17, label %14

25:                                               ; preds = %5, %14
  %26 = phi ptr [ %16, %14 ], [ null, %5 ]
  %27 = icmp sgt i64 %2, 0
  br i1 %27, label %28, label %33

28:                                               ; preds = %25
  %29 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %30 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %31 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 44
  %32 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 45
  br label %34

33:                                               ; preds = %57, %25
  ret void

34:                                               ; preds = %28, %57
  %35 = phi i64 [ 0, %28 ], [ %58, %57 ]
  %36 = phi ptr [ %4, %28 ], [ %59, %57 ]
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %6) #19
  store i64 0, ptr %6, align 8
  %37 = load i64, ptr %29, align 8
  %38 = mul nsw i64 %37, %35
  %39 = getelementptr inbounds double, ptr %1, i64 %38
  %40 = getelementptr inbounds double, ptr %3, i64 %35
  %41 = load double, ptr %40, align 8
  %42 = call fastcc i32 @examine(ptr noundef %0, ptr noundef %39, double noundef %41, ptr noundef nonnull %6, ptr noundef %26)
  %43 = load i64, ptr %30, align 8
  %44 = icmp sgt i64 %43, 0
  br i1 %44, label %51, label %45

45:                                               ; preds = %51, %34
  %46 = load i64, ptr %6, align 8
  %47 = icmp sgt i64 %46, 0
  br i1 %47, label %48, label %57

48:                                               ; preds = %45
  %49 = load ptr, ptr %31, align 8
  %50 = load ptr, ptr %32, align 8
  br label %61

51:                                               ; preds = %34, %51
  %52 = phi i64 [ %55, %51 ], [ 0, %34 ]
  %53 = load double, ptr %40, align 8
  %54 = getelementptr inbounds double, ptr %36, i64 %52
  store double %53, ptr %54, align 8
  %55 = add nuw nsw i64 %52, 1
  %56 = icmp eq i64 %55, %43
  br i1 %56, label %45, label %51

57:                                               ; preds = %61, %45
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %6) #19
  %58 = add nuw nsw i64 %35, 1
  %59 = getelementptr inbounds double, ptr %36, i64 %43
  %60 = icmp eq i64 %58, %2
  br i1 %60, label %33, label %34

61:                                               ; preds = %48, %61
  %62 = phi i64 [ 0, %48 ], [ %68, %61 ]
  %63 = getelementptr inbounds i64, ptr %50, i64 %62
  %64 = load i64, ptr %63, align 8
  %65 = getelementptr inbounds double, ptr %49, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = getelementptr inbounds double, ptr %36, i64 %64
  store double %66, ptr %67, align 8
  store double 0x7FF0000000000000, ptr %65, align 8
  %68 = add nuw nsw i64 %62, 1
  %69 = icmp eq i64 %68, %46
  br i1 %69, label %57, label %61
}

define dso_local i64 @manipplan_near(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, ptr nocapture noundef readonly %3, i64 noundef %4, ptr nocapture noundef writeonly %5, ptr nocapture noundef writeonly %6) local_unnamed_addr #0 {
  %8 = alloca i64, align 8
  %9 = icmp slt i64 %2, 2
  br i1 %9, label %27, label %10

10:                                               ; preds = %7
  %11 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %14, label %16

14:                                               ; preds = %10
  %15 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 46
  br label %19

16:                                               ; preds = %19, %10
  %17 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 46
  %18 = load ptr, ptr %17, align 8
  br label %27

19:                                               ; preds = %19, %14
  %20 = phi i64 [ 0, %14 ], [ %24, %19 ]
  %21 = load ptr, ptr %15, align 8
  %22 = mul nuw nsw i64 %20, 22
  %23 = getelementptr inbounds double, ptr %21, i64 %22
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %23, i8 0, i64 24, i1 false)
  %24 = add nuw nsw i64 %20, 1
  %25 = load i64, ptr %11, align 8
  %26 = icmp slt i64 %24, %25
  br i1 %26, label %19, label %16

27:                                               ; preds = %7, %16
  %28 = phi ptr [ %18, %16 ], [ null, %7 ]
  %29 = icmp sgt i64 %2, 0
  br i1 %29, label %30, label %35

30:                                               ; preds = %27
  %31 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %32 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 45
  %33 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %34 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 44
  br label %37

35:                                               ; preds = %51, %27
  %36 = phi i64 [ 0, %27 ], [ %52, %51 ]
  ret i64 %36

37:                                               ; preds = %30, %51
  %38 = phi i64 [ 0, %30 ], [ %52, %51 ]
  %39 = phi i64 [ 0, %30 ], [ %53, %51 ]
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %8) #19
  store i64 0, ptr %8, align 8
  %40 = load i64, ptr %31, align 8
  %41 = mul nsw i64 %40, %39
  %42 = getelementptr inbounds double, ptr %1, i64 %41
  %43 = getelementptr inbounds double, ptr %3, i64 %39
  %44 = load double, ptr %43, align 8
  %45 = call fastcc i32 @examine(ptr noundef %0, ptr noundef %42, double noundef %44, ptr noundef nonnull %8, ptr noundef %28)
  %46 = load i64, ptr %8, align 8
  %47 = icmp sgt i64 %46, 0
  br i1 %47, label %48, label %51

48:                                               ; preds = %37
  %49 = load ptr, ptr %32, align 8
  %50 = load ptr, ptr %34, align 8
  br label %55

51:                                               ; preds = %69, %37
  %52 = phi i64 [ %38, %37 ], [ %72, %69 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #19
  %53 = add nuw nsw i64 %39, 1
  %54 = icmp eq i64 %53, %2
  br i1 %54, label %35, label %37

55:                                               ; preds = %48, %69
  %56 = phi i64 [ %38, %48 ], [ %72, %69 ]
  %57 = phi i64 [ 0, %48 ], [ %71, %69 ]
  %58 = getelementptr inbounds i64, ptr %49, i64 %57
  %59 = load i64, ptr %58, align 8
  %60 = icmp slt i64 %56, %4
  br i1 %60, label %61, label %69

61:                                               ; preds = %55
  %62 = load i64, ptr %33, align 8
  %63 = mul nsw i64 %62, %39
  %64 = add nsw i64 %63, %59
  %65 = getelementptr inbounds i64, ptr %5, i64 %56
  store i64 %64, ptr %65, align 8
  %66 = getelementptr inbounds double, ptr %50, i64 %59
  %67 = load double, ptr %66, align 8
  %68 = getelementptr inbounds double, ptr %6, i64 %56
  store double %67, ptr %68, align 8
  br label %69

69:                                               ; preds = %61, %55
  %70 = getelementptr inbounds double, ptr %50, i64 %59
  store double 0x7FF0000000000000, ptr %70, align 8
  %71 = add nuw nsw i64 %57, 1
  %72 = add nsw i64 %56, 1
  %73 = icmp eq i64 %71, %46
  br i1 %73, label %51, label %55
}

define dso_local i32 @manipplan_least(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, double noundef %3, i64 noundef %4, ptr nocapture noundef %5, ptr nocapture noundef %6, ptr nocapture noundef %7) local_unnamed_addr #0 {
  %9 = alloca i64, align 8
  store double %3, ptr %5, align 8
  store i64 0, ptr %6, align 8
  store i64 -1, ptr %7, align 8
  %10 = icmp sgt i64 %2, 0
  %11 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %12 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 45
  %13 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 44
  br label %14

14:                                               ; preds = %78, %8
  %15 = phi i1 [ true, %8 ], [ false, %78 ]
  %16 = phi i32 [ 0, %8 ], [ 1, %78 ]
  br i1 %10, label %17, label %77

17:                                               ; preds = %14, %70
  %18 = phi i1 [ %72, %70 ], [ true, %14 ]
  %19 = phi i64 [ %71, %70 ], [ 0, %14 ]
  %20 = srem i64 %19, %4
  %21 = icmp ne i64 %20, 0
  %22 = zext i1 %21 to i32
  %23 = icmp eq i32 %16, %22
  br i1 %23, label %24, label %70

24:                                               ; preds = %17
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %9) #19
  store i64 0, ptr %9, align 8
  %25 = load double, ptr %5, align 8
  %26 = load i64, ptr %11, align 8
  %27 = mul nsw i64 %26, %19
  %28 = getelementptr inbounds double, ptr %1, i64 %27
  %29 = fadd double %25, 1.000000e-09
  %30 = call fastcc i32 @examine(ptr noundef %0, ptr noundef %28, double noundef %29, ptr noundef nonnull %9, ptr noundef null)
  %31 = load i64, ptr %9, align 8
  %32 = icmp sgt i64 %31, 0
  br i1 %32, label %34, label %33

33:                                               ; preds = %24
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #19
  br label %70

34:                                               ; preds = %24
  %35 = load ptr, ptr %12, align 8
  %36 = load ptr, ptr %13, align 8
  %37 = load i64, ptr %7, align 8
  br label %40

38:                                               ; preds = %66
  %39 = icmp eq i32 %49, 0
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #19
  br i1 %39, label %74, label %70

40:                                               ; preds = %34, %66
  %41 = phi i64 [ %37, %34 ], [ %67, %66 ]
  %42 = phi i64 [ 0, %34 ], [ %68, %66 ]
  %43 = phi i32 [ 1, %34 ], [ %49, %66 ]
  %44 = getelementptr inbounds i64, ptr %35, i64 %42
  %45 = load i64, ptr %44, align 8
  %46 = getelementptr inbounds double, ptr %36, i64 %45
  %47 = load double, ptr %46, align 8
  store double 0x7FF0000000000000, ptr %46, align 8
  %48 = fcmp uno double %47, 0.000000e+00
  %49 = select i1 %48, i32 0, i32 %43
  %50 = icmp sgt i64 %41, -1
  br i1 %50, label %51, label %58

51:                                               ; preds = %40
  %52 = load i64, ptr %6, align 8
  %53 = icmp slt i64 %19, %52
  br i1 %53, label %58, label %54

54:                                               ; preds = %51
  %55 = icmp eq i64 %19, %52
  %56 = icmp slt i64 %45, %41
  %57 = select i1 %55, i1 %56, i1 false
  br label %58

58:                                               ; preds = %54, %51, %40
  %59 = phi i1 [ false, %40 ], [ true, %51 ], [ %57, %54 ]
  %60 = load double, ptr %5, align 8
  %61 = fcmp olt double %47, %60
  %62 = fcmp oeq double %47, %60
  %63 = select i1 %62, i1 %59, i1 false
  %64 = select i1 %61, i1 true, i1 %63
  br i1 %64, label %65, label %66

65:                                               ; preds = %58
  store double %47, ptr %5, align 8
  store i64 %19, ptr %6, align 8
  store i64 %45, ptr %7, align 8
  br label %66

66:                                               ; preds = %58, %65
  %67 = phi i64 [ %41, %58 ], [ %45, %65 ]
  %68 = add nuw nsw i64 %42, 1
  %69 = icmp eq i64 %68, %31
  br i1 %69, label %38, label %40

70:                                               ; preds = %33, %38, %17
  %71 = add nuw nsw i64 %19, 1
  %72 = icmp slt i64 %71, %2
  %73 = icmp eq i64 %71, %2
  br i1 %73, label %77, label %17

74:                                               ; preds = %38
  %75 = xor i1 %15, true
  %76 = or i1 %18, %75
  br i1 %76, label %79, label %78

77:                                               ; preds = %70, %14
  br i1 %15, label %78, label %82

78:                                               ; preds = %77, %74
  br label %14

79:                                               ; preds = %74
  %80 = xor i1 %18, true
  %81 = zext i1 %80 to i32
  br label %82

82:                                               ; preds = %77, %79
  %83 = phi i32 [ %81, %79 ], [ 1, %77 ]
  ret i32 %83
}

define dso_local void @manipplan_pairs(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, ptr nocapture noundef writeonly %5, ptr nocapture noundef writeonly %6) local_unnamed_addr #0 {
  %8 = alloca double, align 8
  %9 = alloca %struct.Core, align 8
  %10 = alloca %struct.Search, align 8
  %11 = alloca [22 x double], align 16
  call void @llvm.lifetime.start.p0(i64 176, ptr nonnull %11) #19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(176) %11, i8 0, i64 176, i1 false)
  %12 = icmp sgt i64 %2, 0
  br i1 %12, label %13, label %27

13:                                               ; preds = %7
  %14 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %15 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 1
  %16 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 2
  %17 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 3
  %18 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 5
  %19 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 6
  %20 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 7
  %21 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 8
  %22 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 9
  %23 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 10
  %24 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 11
  %25 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 12
  %26 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 18
  br label %28

27:                                               ; preds = %83, %7
  call void @llvm.lifetime.end.p0(i64 176, ptr nonnull %11) #19
  ret void

28:                                               ; preds = %13, %83
  %29 = phi i64 [ 0, %13 ], [ %86, %83 ]
  %30 = shl nuw nsw i64 %29, 1
  %31 = getelementptr inbounds i64, ptr %3, i64 %30
  %32 = load i64, ptr %31, align 8
  %33 = or i64 %30, 1
  %34 = getelementptr inbounds i64, ptr %3, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = icmp eq i64 %29, 0
  br i1 %36, label %58, label %37

37:                                               ; preds = %28
  %38 = add nsw i64 %30, -2
  %39 = getelementptr inbounds i64, ptr %3, i64 %38
  %40 = load i64, ptr %39, align 8
  %41 = icmp eq i64 %32, %40
  br i1 %41, label %42, label %47

42:                                               ; preds = %37
  %43 = add nsw i64 %30, -1
  %44 = getelementptr inbounds i64, ptr %3, i64 %43
  %45 = load i64, ptr %44, align 8
  %46 = icmp eq i64 %35, %45
  br i1 %46, label %48, label %47

47:                                               ; preds = %42, %37
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(176) %11, i8 0, i64 176, i1 false)
  br label %48

48:                                               ; preds = %42, %47
  %49 = load i64, ptr %14, align 8
  %50 = mul nsw i64 %49, %29
  %51 = getelementptr inbounds double, ptr %1, i64 %50
  %52 = add nsw i64 %29, -1
  %53 = mul nsw i64 %49, %52
  %54 = getelementptr inbounds double, ptr %1, i64 %53
  %55 = shl i64 %49, 3
  %56 = call i32 @bcmp(ptr %51, ptr %54, i64 %55)
  %57 = icmp eq i32 %56, 0
  br i1 %57, label %63, label %58

58:                                               ; preds = %28, %48
  %59 = phi i64 [ %50, %48 ], [ 0, %28 ]
  %60 = getelementptr inbounds double, ptr %1, i64 %59
  call fastcc void @place(ptr noundef %0, ptr noundef %60)
  %61 = load i64, ptr %14, align 8
  %62 = mul nsw i64 %61, %29
  br label %63

63:                                               ; preds = %58, %48
  %64 = phi i64 [ %62, %58 ], [ %50, %48 ]
  %65 = getelementptr inbounds double, ptr %1, i64 %64
  %66 = getelementptr inbounds double, ptr %4, i64 %29
  %67 = load double, ptr %66, align 8
  %68 = getelementptr inbounds i64, ptr %6, i64 %29
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %8) #19
  store double %67, ptr %8, align 8
  store i64 -1, ptr %68, align 8
  %69 = load i64, ptr %14, align 8
  %70 = icmp sgt i64 %69, 0
  br i1 %70, label %74, label %80

71:                                               ; preds = %74
  %72 = add nuw nsw i64 %75, 1
  %73 = icmp eq i64 %72, %69
  br i1 %73, label %80, label %74

74:                                               ; preds = %63, %71
  %75 = phi i64 [ %72, %71 ], [ 0, %63 ]
  %76 = getelementptr inbounds double, ptr %65, i64 %75
  %77 = load double, ptr %76, align 8
  %78 = call double @llvm.fabs.f64(double %77) #18
  %79 = fcmp ueq double %78, 0x7FF0000000000000
  br i1 %79, label %83, label %71

80:                                               ; preds = %71, %63
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %9) #19
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %32, ptr noundef nonnull %9)
  call void @llvm.lifetime.start.p0(i64 168, ptr nonnull %10) #19
  store ptr %0, ptr %10, align 8
  store i64 %32, ptr %15, align 8
  store ptr %9, ptr %16, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %17, i8 0, i64 16, i1 false)
  store double %67, ptr %18, align 8
  store ptr %8, ptr %19, align 8
  store ptr null, ptr %20, align 8
  store i32 0, ptr %21, align 8
  store i64 -1, ptr %22, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %23, i8 0, i64 32, i1 false)
  store ptr %11, ptr %24, align 8
  store double 0.000000e+00, ptr %26, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(36) %25, i8 0, i64 36, i1 false)
  call fastcc void @look_at(ptr noundef nonnull %10, i64 noundef %35, ptr noundef null)
  %81 = load i64, ptr %22, align 8
  store i64 %81, ptr %68, align 8
  %82 = load double, ptr %8, align 8
  call void @llvm.lifetime.end.p0(i64 168, ptr nonnull %10) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %9) #19
  br label %83

83:                                               ; preds = %74, %80
  %84 = phi double [ %82, %80 ], [ 0x7FF8000000000000, %74 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #19
  %85 = getelementptr inbounds double, ptr %5, i64 %29
  store double %84, ptr %85, align 8
  %86 = add nuw nsw i64 %29, 1
  %87 = icmp eq i64 %86, %2
  br i1 %87, label %27, label %28
}

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #2

define internal fastcc void @place(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1) unnamed_addr #3 {
  %3 = alloca [12 x double], align 16
  %4 = alloca [12 x double], align 16
  %5 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 42
  %6 = load ptr, ptr %5, align 8
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(96) %6, ptr noundef nonnull align 16 dereferenceable(96) @place.still, i64 96, i1 false)
  %7 = load i64, ptr %0, align 8
  %8 = icmp sgt i64 %7, 0
  br i1 %8, label %9, label %35

9:                                                ; preds = %2
  %10 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 8
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 3
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 2
  %15 = load ptr, ptr %14, align 8
  %16 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 4
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 9
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr inbounds i8, ptr %3, i64 8
  %21 = getelementptr inbounds i8, ptr %3, i64 16
  %22 = getelementptr inbounds i8, ptr %3, i64 24
  %23 = getelementptr inbounds i8, ptr %3, i64 32
  %24 = getelementptr inbounds i8, ptr %3, i64 40
  %25 = getelementptr inbounds i8, ptr %3, i64 48
  %26 = getelementptr inbounds i8, ptr %3, i64 56
  %27 = getelementptr inbounds i8, ptr %3, i64 64
  %28 = getelementptr inbounds i8, ptr %3, i64 72
  %29 = getelementptr inbounds i8, ptr %3, i64 80
  %30 = getelementptr inbounds i8, ptr %3, i64 88
  %31 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 5
  %32 = load ptr, ptr %31, align 8
  %33 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 7
  %34 = load ptr, ptr %33, align 8
  br label %44

35:                                               ; preds = %210, %2
  %36 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 10
  %37 = load i64, ptr %36, align 8
  %38 = icmp sgt i64 %37, 0
  br i1 %38, label %39, label %212

39:                                               ; preds = %35
  %40 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 18
  %43 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 43
  br label %213

44:                                               ; preds = %9, %210
  %45 = phi i64 [ 0, %9 ], [ %161, %210 ]
  %46 = mul nsw i64 %45, 3
  %47 = getelementptr inbounds double, ptr %11, i64 %46
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %3) #19
  %48 = getelementptr inbounds double, ptr %13, i64 %45
  %49 = load double, ptr %48, align 8
  %50 = getelementptr inbounds i64, ptr %15, i64 %45
  %51 = load i64, ptr %50, align 8
  %52 = getelementptr inbounds double, ptr %1, i64 %51
  %53 = load double, ptr %52, align 8
  %54 = fmul double %49, %53
  %55 = getelementptr inbounds double, ptr %17, i64 %45
  %56 = load double, ptr %55, align 8
  %57 = fadd double %54, %56
  %58 = getelementptr inbounds i64, ptr %19, i64 %45
  %59 = load i64, ptr %58, align 8
  %60 = icmp eq i64 %59, 0
  br i1 %60, label %71, label %61

61:                                               ; preds = %44
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(96) %3, ptr noundef nonnull align 16 dereferenceable(96) @place.still, i64 96, i1 false)
  br label %62

62:                                               ; preds = %61, %62
  %63 = phi i64 [ 0, %61 ], [ %69, %62 ]
  %64 = getelementptr inbounds double, ptr %47, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = fmul double %57, %65
  %67 = add nuw nsw i64 %63, 9
  %68 = getelementptr inbounds [12 x double], ptr %3, i64 0, i64 %67
  store double %66, ptr %68, align 8
  %69 = add nuw nsw i64 %63, 1
  %70 = icmp eq i64 %69, 3
  br i1 %70, label %104, label %62

71:                                               ; preds = %44
  %72 = tail call double @llvm.sin.f64(double %57)
  %73 = tail call double @llvm.cos.f64(double %57)
  %74 = fsub double 1.000000e+00, %73
  %75 = load double, ptr %47, align 8
  %76 = fmul double %74, %75
  %77 = fmul double %75, %76
  %78 = fadd double %73, %77
  %79 = getelementptr inbounds double, ptr %47, i64 1
  %80 = load double, ptr %79, align 8
  %81 = fmul double %76, %80
  %82 = getelementptr inbounds double, ptr %47, i64 2
  %83 = load double, ptr %82, align 8
  %84 = fmul double %72, %83
  %85 = fsub double %81, %84
  %86 = fmul double %76, %83
  %87 = fmul double %72, %80
  %88 = fadd double %87, %86
  %89 = fmul double %74, %80
  %90 = fmul double %75, %89
  %91 = fadd double %90, %84
  %92 = fmul double %80, %89
  %93 = fadd double %73, %92
  %94 = fmul double %89, %83
  %95 = fmul double %72, %75
  %96 = fsub double %94, %95
  %97 = fmul double %74, %83
  %98 = fmul double %75, %97
  %99 = fsub double %98, %87
  %100 = fmul double %80, %97
  %101 = fadd double %95, %100
  %102 = fmul double %83, %97
  %103 = fadd double %73, %102
  store double %78, ptr %3, align 16
  store double %85, ptr %20, align 8
  store double %88, ptr %21, align 16
  store double %91, ptr %22, align 8
  store double %93, ptr %23, align 16
  store double %96, ptr %24, align 8
  store double %99, ptr %25, align 16
  store double %101, ptr %26, align 8
  store double %103, ptr %27, align 16
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %28, i8 0, i64 24, i1 false)
  br label %104

104:                                              ; preds = %62, %71
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %4) #19
  %105 = getelementptr inbounds i64, ptr %32, i64 %45
  %106 = load i64, ptr %105, align 8
  %107 = mul nsw i64 %106, 12
  %108 = getelementptr inbounds double, ptr %6, i64 %107
  %109 = mul nsw i64 %45, 12
  %110 = getelementptr inbounds double, ptr %34, i64 %109
  %111 = getelementptr inbounds double, ptr %110, i64 9
  %112 = getelementptr inbounds double, ptr %110, i64 10
  %113 = getelementptr inbounds double, ptr %110, i64 11
  %114 = load double, ptr %111, align 8
  %115 = load double, ptr %112, align 8
  %116 = load double, ptr %113, align 8
  br label %117

117:                                              ; preds = %128, %104
  %118 = phi i64 [ 0, %104 ], [ %139, %128 ]
  %119 = mul nuw nsw i64 %118, 3
  %120 = getelementptr inbounds double, ptr %108, i64 %119
  %121 = add nuw nsw i64 %119, 1
  %122 = getelementptr inbounds double, ptr %108, i64 %121
  %123 = add nuw nsw i64 %119, 2
  %124 = getelementptr inbounds double, ptr %108, i64 %123
  %125 = load double, ptr %120, align 8
  %126 = load double, ptr %122, align 8
  %127 = load double, ptr %124, align 8
  br label %141

128:                                              ; preds = %141
  %129 = fmul double %125, %114
  %130 = fmul double %126, %115
  %131 = fadd double %129, %130
  %132 = fmul double %127, %116
  %133 = fadd double %131, %132
  %134 = add nuw nsw i64 %118, 9
  %135 = getelementptr inbounds double, ptr %108, i64 %134
  %136 = load double, ptr %135, align 8
  %137 = fadd double %136, %133
  %138 = getelementptr inbounds double, ptr %4, i64 %134
  store double %137, ptr %138, align 8
  %139 = add nuw nsw i64 %118, 1
  %140 = icmp eq i64 %139, 3
  br i1 %140, label %160, label %117

141:                                              ; preds = %141, %117
  %142 = phi i64 [ 0, %117 ], [ %158, %141 ]
  %143 = getelementptr inbounds double, ptr %110, i64 %142
  %144 = load double, ptr %143, align 8
  %145 = fmul double %125, %144
  %146 = add nuw nsw i64 %142, 3
  %147 = getelementptr inbounds double, ptr %110, i64 %146
  %148 = load double, ptr %147, align 8
  %149 = fmul double %126, %148
  %150 = fadd double %145, %149
  %151 = add nuw nsw i64 %142, 6
  %152 = getelementptr inbounds double, ptr %110, i64 %151
  %153 = load double, ptr %152, align 8
  %154 = fmul double %127, %153
  %155 = fadd double %150, %154
  %156 = add nuw nsw i64 %142, %119
  %157 = getelementptr inbounds double, ptr %4, i64 %156
  store double %155, ptr %157, align 8
  %158 = add nuw nsw i64 %142, 1
  %159 = icmp eq i64 %158, 3
  br i1 %159, label %128, label %141

160:                                              ; preds = %128
  %161 = add nuw nsw i64 %45, 1
  %162 = mul nsw i64 %161, 12
  %163 = getelementptr inbounds double, ptr %6, i64 %162
  %164 = load double, ptr %28, align 8
  %165 = load double, ptr %29, align 16
  %166 = load double, ptr %30, align 8
  br label %167

167:                                              ; preds = %178, %160
  %168 = phi i64 [ 0, %160 ], [ %189, %178 ]
  %169 = mul nuw nsw i64 %168, 3
  %170 = getelementptr inbounds double, ptr %4, i64 %169
  %171 = add nuw nsw i64 %169, 1
  %172 = getelementptr inbounds double, ptr %4, i64 %171
  %173 = add nuw nsw i64 %169, 2
  %174 = getelementptr inbounds double, ptr %4, i64 %173
  %175 = load double, ptr %170, align 8
  %176 = load double, ptr %172, align 8
  %177 = load double, ptr %174, align 8
  br label %191

178:                                              ; preds = %191
  %179 = fmul double %175, %164
  %180 = fmul double %176, %165
  %181 = fadd double %179, %180
  %182 = fmul double %177, %166
  %183 = fadd double %181, %182
  %184 = add nuw nsw i64 %168, 9
  %185 = getelementptr inbounds double, ptr %4, i64 %184
  %186 = load double, ptr %185, align 8
  %187 = fadd double %186, %183
  %188 = getelementptr inbounds double, ptr %163, i64 %184
  store double %187, ptr %188, align 8
  %189 = add nuw nsw i64 %168, 1
  %190 = icmp eq i64 %189, 3
  br i1 %190, label %210, label %167

191:                                              ; preds = %191, %167
  %192 = phi i64 [ 0, %167 ], [ %208, %191 ]
  %193 = getelementptr inbounds double, ptr %3, i64 %192
  %194 = load double, ptr %193, align 8
  %195 = fmul double %175, %194
  %196 = add nuw nsw i64 %192, 3
  %197 = getelementptr inbounds double, ptr %3, i64 %196
  %198 = load double, ptr %197, align 8
  %199 = fmul double %176, %198
  %200 = fadd double %195, %199
  %201 = add nuw nsw i64 %192, 6
  %202 = getelementptr inbounds double, ptr %3, i64 %201
  %203 = load double, ptr %202, align 8
  %204 = fmul double %177, %203
  %205 = fadd double %200, %204
  %206 = add nuw nsw i64 %192, %169
  %207 = getelementptr inbounds double, ptr %163, i64 %206
  store double %205, ptr %207, align 8
  %208 = add nuw nsw i64 %192, 1
  %209 = icmp eq i64 %208, 3
  br i1 %209, label %178, label %191

210:                                              ; preds = %178
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %4) #19
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %3) #19
  %211 = icmp eq i64 %161, %7
  br i1 %211, label %35, label %44

212:                                              ; preds = %255, %35
  ret void

213:                                              ; preds = %39, %255
  %214 = phi i64 [ 0, %39 ], [ %256, %255 ]
  %215 = getelementptr inbounds i64, ptr %41, i64 %214
  %216 = load i64, ptr %215, align 8
  %217 = icmp sgt i64 %216, 0
  br i1 %217, label %218, label %255

218:                                              ; preds = %213
  %219 = mul nsw i64 %216, 12
  %220 = getelementptr inbounds double, ptr %6, i64 %219
  %221 = load ptr, ptr %42, align 8
  %222 = shl nsw i64 %214, 2
  %223 = getelementptr inbounds double, ptr %221, i64 %222
  %224 = load ptr, ptr %43, align 8
  %225 = mul nsw i64 %214, 3
  %226 = getelementptr inbounds double, ptr %224, i64 %225
  %227 = getelementptr inbounds double, ptr %223, i64 1
  %228 = getelementptr inbounds double, ptr %223, i64 2
  br label %229

229:                                              ; preds = %229, %218
  %230 = phi i64 [ 0, %218 ], [ %253, %229 ]
  %231 = mul nuw nsw i64 %230, 3
  %232 = getelementptr inbounds double, ptr %220, i64 %231
  %233 = load double, ptr %232, align 8
  %234 = load double, ptr %223, align 8
  %235 = fmul double %233, %234
  %236 = add nuw nsw i64 %231, 1
  %237 = getelementptr inbounds double, ptr %220, i64 %236
  %238 = load double, ptr %237, align 8
  %239 = load double, ptr %227, align 8
  %240 = fmul double %238, %239
  %241 = fadd double %235, %240
  %242 = add nuw nsw i64 %231, 2
  %243 = getelementptr inbounds double, ptr %220, i64 %242
  %244 = load double, ptr %243, align 8
  %245 = load double, ptr %228, align 8
  %246 = fmul double %244, %245
  %247 = fadd double %241, %246
  %248 = add nuw nsw i64 %230, 9
  %249 = getelementptr inbounds double, ptr %220, i64 %248
  %250 = load double, ptr %249, align 8
  %251 = fadd double %250, %247
  %252 = getelementptr inbounds double, ptr %226, i64 %230
  store double %251, ptr %252, align 8
  %253 = add nuw nsw i64 %230, 1
  %254 = icmp eq i64 %253, 3
  br i1 %254, label %255, label %229

255:                                              ; preds = %229, %213
  %256 = add nuw nsw i64 %214, 1
  %257 = icmp eq i64 %256, %37
  br i1 %257, label %212, label %213
}

define dso_local double @manipplan_pair(ptr noundef %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr noundef %3) local_unnamed_addr #0 {
  %5 = alloca double, align 8
  %6 = alloca %struct.Core, align 8
  %7 = alloca %struct.Search, align 8
  tail call fastcc void @place(ptr noundef %0, ptr noundef %1)
  %8 = load i64, ptr %2, align 8
  %9 = getelementptr inbounds i64, ptr %2, i64 1
  %10 = load i64, ptr %9, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %5) #19
  store double 0x7FF0000000000000, ptr %5, align 8
  %11 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %12, 0
  br i1 %13, label %17, label %23

14:                                               ; preds = %17
  %15 = add nuw nsw i64 %18, 1
  %16 = icmp eq i64 %15, %12
  br i1 %16, label %23, label %17

17:                                               ; preds = %4, %14
  %18 = phi i64 [ %15, %14 ], [ 0, %4 ]
  %19 = getelementptr inbounds double, ptr %1, i64 %18
  %20 = load double, ptr %19, align 8
  %21 = tail call double @llvm.fabs.f64(double %20) #18
  %22 = fcmp ueq double %21, 0x7FF0000000000000
  br i1 %22, label %37, label %14

23:                                               ; preds = %14, %4
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %6) #19
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %8, ptr noundef nonnull %6)
  call void @llvm.lifetime.start.p0(i64 168, ptr nonnull %7) #19
  store ptr %0, ptr %7, align 8
  %24 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 1
  store i64 %8, ptr %24, align 8
  %25 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 2
  store ptr %6, ptr %25, align 8
  %26 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 3
  %27 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 5
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %26, i8 0, i64 16, i1 false)
  store double 0x7FF0000000000000, ptr %27, align 8
  %28 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 6
  store ptr %5, ptr %28, align 8
  %29 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 7
  store ptr null, ptr %29, align 8
  %30 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 8
  store i32 0, ptr %30, align 8
  %31 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 9
  store i64 -1, ptr %31, align 8
  %32 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 10
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %32, i8 0, i64 32, i1 false)
  %33 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 11
  store ptr %3, ptr %33, align 8
  %34 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 12
  %35 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 18
  store double 0.000000e+00, ptr %35, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(36) %34, i8 0, i64 36, i1 false)
  call fastcc void @look_at(ptr noundef nonnull %7, i64 noundef %10, ptr noundef null)
  %36 = load double, ptr %5, align 8
  call void @llvm.lifetime.end.p0(i64 168, ptr nonnull %7) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %6) #19
  br label %37

37:                                               ; preds = %17, %23
  %38 = phi double [ %36, %23 ], [ 0x7FF8000000000000, %17 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %5) #19
  ret double %38
}

define dso_local void @manipplan_intervals(ptr noundef %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, i64 noundef %3, ptr nocapture noundef readonly %4, ptr nocapture noundef readonly %5, ptr nocapture noundef readonly %6, ptr nocapture noundef writeonly %7, ptr nocapture noundef writeonly %8) local_unnamed_addr #0 {
  %10 = alloca double, align 8
  %11 = alloca %struct.Core, align 8
  %12 = alloca %struct.Search, align 8
  %13 = alloca double, align 8
  %14 = alloca %struct.Core, align 8
  %15 = alloca %struct.Search, align 8
  %16 = alloca [22 x double], align 16
  %17 = alloca [22 x double], align 16
  %18 = alloca %struct.Core, align 8
  %19 = alloca %struct.Core, align 8
  %20 = alloca %struct.Plane, align 8
  %21 = alloca double, align 8
  %22 = alloca double, align 8
  %23 = alloca [3 x double], align 16
  %24 = alloca [3 x double], align 16
  %25 = alloca [12 x double], align 16
  %26 = alloca [22 x double], align 16
  %27 = alloca [3 x double], align 16
  %28 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 176, ptr nonnull %16) #19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(176) %16, i8 0, i64 176, i1 false)
  %29 = icmp sgt i64 %3, 0
  br i1 %29, label %30, label %71

30:                                               ; preds = %9
  %31 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %32 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 12
  %33 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %34 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 15
  %35 = getelementptr inbounds double, ptr %16, i64 1
  %36 = getelementptr inbounds double, ptr %16, i64 2
  %37 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 43
  %38 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 1
  %39 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 2
  %40 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 3
  %41 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 5
  %42 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 6
  %43 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 7
  %44 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 8
  %45 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 9
  %46 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 10
  %47 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 11
  %48 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 12
  %49 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 18
  %50 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 42
  %51 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 16
  %52 = getelementptr inbounds double, ptr %20, i64 1
  %53 = getelementptr inbounds double, ptr %24, i64 1
  %54 = getelementptr inbounds double, ptr %20, i64 2
  %55 = getelementptr inbounds double, ptr %24, i64 2
  %56 = getelementptr inbounds double, ptr %23, i64 1
  %57 = getelementptr inbounds double, ptr %23, i64 2
  %58 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 1
  %59 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 2
  %60 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 3
  %61 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 5
  %62 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 6
  %63 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 7
  %64 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 8
  %65 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 9
  %66 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 10
  %67 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 11
  %68 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 12
  %69 = getelementptr inbounds %struct.Search, ptr %15, i64 0, i32 18
  %70 = getelementptr inbounds i8, ptr %25, i64 72
  br label %72

71:                                               ; preds = %369, %9
  call void @llvm.lifetime.end.p0(i64 176, ptr nonnull %16) #19
  ret void

72:                                               ; preds = %30, %369
  %73 = phi ptr [ %2, %30 ], [ %372, %369 ]
  %74 = phi i64 [ 0, %30 ], [ %370, %369 ]
  %75 = shl nuw nsw i64 %74, 1
  %76 = getelementptr inbounds i64, ptr %4, i64 %75
  %77 = load i64, ptr %76, align 8
  %78 = or i64 %75, 1
  %79 = getelementptr inbounds i64, ptr %4, i64 %78
  %80 = load i64, ptr %79, align 8
  %81 = icmp eq i64 %74, 0
  br i1 %81, label %93, label %82

82:                                               ; preds = %72
  %83 = add nsw i64 %75, -2
  %84 = getelementptr inbounds i64, ptr %4, i64 %83
  %85 = load i64, ptr %84, align 8
  %86 = icmp eq i64 %77, %85
  br i1 %86, label %87, label %92

87:                                               ; preds = %82
  %88 = add nsw i64 %75, -1
  %89 = getelementptr inbounds i64, ptr %4, i64 %88
  %90 = load i64, ptr %89, align 8
  %91 = icmp eq i64 %80, %90
  br i1 %91, label %94, label %92

92:                                               ; preds = %87, %82
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(176) %16, i8 0, i64 176, i1 false)
  br label %94

93:                                               ; preds = %72
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(176) %16, i8 0, i64 176, i1 false)
  br label %104

94:                                               ; preds = %87, %92
  %95 = load i64, ptr %31, align 8
  %96 = mul nsw i64 %95, %74
  %97 = getelementptr inbounds double, ptr %1, i64 %96
  %98 = add nsw i64 %74, -1
  %99 = mul nsw i64 %95, %98
  %100 = getelementptr inbounds double, ptr %1, i64 %99
  %101 = shl i64 %95, 3
  %102 = call i32 @bcmp(ptr %97, ptr %100, i64 %101)
  %103 = icmp eq i32 %102, 0
  br i1 %103, label %107, label %104

104:                                              ; preds = %93, %94
  %105 = phi i64 [ 0, %93 ], [ %96, %94 ]
  %106 = getelementptr inbounds double, ptr %1, i64 %105
  call fastcc void @place(ptr noundef %0, ptr noundef %106)
  br label %107

107:                                              ; preds = %104, %94
  %108 = getelementptr inbounds double, ptr %8, i64 %74
  store double 0xFFF0000000000000, ptr %108, align 8
  %109 = load ptr, ptr %32, align 8
  %110 = getelementptr inbounds i64, ptr %109, i64 %80
  %111 = load i64, ptr %110, align 8
  %112 = icmp eq i64 %111, 3
  br i1 %112, label %113, label %120

113:                                              ; preds = %107
  %114 = load ptr, ptr %33, align 8
  %115 = getelementptr inbounds i64, ptr %114, i64 %77
  %116 = load i64, ptr %115, align 8
  %117 = getelementptr inbounds i64, ptr %114, i64 %80
  %118 = load i64, ptr %117, align 8
  %119 = icmp slt i64 %116, %118
  br label %120

120:                                              ; preds = %113, %107
  %121 = phi i1 [ false, %107 ], [ %119, %113 ]
  %122 = getelementptr inbounds i64, ptr %109, i64 %77
  %123 = load i64, ptr %122, align 8
  %124 = icmp sgt i64 %123, 2
  %125 = icmp sgt i64 %111, 3
  %126 = select i1 %124, i1 true, i1 %125
  %127 = select i1 %126, i1 true, i1 %121
  br i1 %127, label %133, label %128

128:                                              ; preds = %120
  %129 = getelementptr inbounds double, ptr %6, i64 %74
  %130 = load double, ptr %129, align 8
  %131 = call double @llvm.fabs.f64(double %130) #18
  %132 = fcmp ueq double %131, 0x7FF0000000000000
  br i1 %132, label %133, label %163

133:                                              ; preds = %128, %120
  call void @llvm.lifetime.start.p0(i64 176, ptr nonnull %17) #19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(176) %17, i8 0, i64 176, i1 false)
  %134 = load i64, ptr %122, align 8
  %135 = icmp eq i64 %134, 4
  br i1 %135, label %136, label %141

136:                                              ; preds = %133
  %137 = load i64, ptr %110, align 8
  %138 = freeze i64 %137
  %139 = icmp eq i64 %138, 4
  %140 = select i1 %139, ptr %16, ptr %17
  br label %141

141:                                              ; preds = %133, %136
  %142 = phi ptr [ %140, %136 ], [ %17, %133 ]
  %143 = load i64, ptr %31, align 8
  %144 = mul nsw i64 %143, %74
  %145 = getelementptr inbounds double, ptr %1, i64 %144
  %146 = getelementptr inbounds double, ptr %5, i64 %74
  %147 = load double, ptr %146, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %13) #19
  store double %147, ptr %13, align 8
  %148 = icmp sgt i64 %143, 0
  br i1 %148, label %152, label %158

149:                                              ; preds = %152
  %150 = add nuw nsw i64 %153, 1
  %151 = icmp eq i64 %150, %143
  br i1 %151, label %158, label %152

152:                                              ; preds = %141, %149
  %153 = phi i64 [ %150, %149 ], [ 0, %141 ]
  %154 = getelementptr inbounds double, ptr %145, i64 %153
  %155 = load double, ptr %154, align 8
  %156 = call double @llvm.fabs.f64(double %155) #18
  %157 = fcmp ueq double %156, 0x7FF0000000000000
  br i1 %157, label %160, label %149

158:                                              ; preds = %149, %141
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %14) #19
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %77, ptr noundef nonnull %14)
  call void @llvm.lifetime.start.p0(i64 168, ptr nonnull %15) #19
  store ptr %0, ptr %15, align 8
  store i64 %77, ptr %58, align 8
  store ptr %14, ptr %59, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %60, i8 0, i64 16, i1 false)
  store double %147, ptr %61, align 8
  store ptr %13, ptr %62, align 8
  store ptr null, ptr %63, align 8
  store i32 0, ptr %64, align 8
  store i64 -1, ptr %65, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %66, i8 0, i64 32, i1 false)
  store ptr %142, ptr %67, align 8
  store double 0.000000e+00, ptr %69, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(36) %68, i8 0, i64 36, i1 false)
  call fastcc void @look_at(ptr noundef nonnull %15, i64 noundef %80, ptr noundef null)
  %159 = load double, ptr %13, align 8
  call void @llvm.lifetime.end.p0(i64 168, ptr nonnull %15) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %14) #19
  br label %160

160:                                              ; preds = %152, %158
  %161 = phi double [ %159, %158 ], [ 0x7FF8000000000000, %152 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %13) #19
  %162 = getelementptr inbounds double, ptr %7, i64 %74
  store double %161, ptr %162, align 8
  call void @llvm.lifetime.end.p0(i64 176, ptr nonnull %17) #19
  br label %369

163:                                              ; preds = %128
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %18) #19
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %19) #19
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %20) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %21) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %22) #19
  %164 = load ptr, ptr %34, align 8
  %165 = getelementptr inbounds double, ptr %164, i64 %77
  %166 = load double, ptr %165, align 8
  %167 = getelementptr inbounds double, ptr %164, i64 %80
  %168 = load double, ptr %167, align 8
  %169 = fadd double %166, %168
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %23) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %24) #19
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %77, ptr noundef nonnull %18)
  %170 = load i64, ptr %110, align 8
  %171 = icmp eq i64 %170, 3
  br i1 %171, label %172, label %243

172:                                              ; preds = %163
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %25) #19
  %173 = load ptr, ptr %50, align 8
  %174 = load ptr, ptr %33, align 8
  %175 = getelementptr inbounds i64, ptr %174, i64 %80
  %176 = load i64, ptr %175, align 8
  %177 = mul nsw i64 %176, 12
  %178 = getelementptr inbounds double, ptr %173, i64 %177
  %179 = load ptr, ptr %51, align 8
  %180 = mul nsw i64 %80, 12
  %181 = getelementptr inbounds double, ptr %179, i64 %180
  %182 = getelementptr inbounds double, ptr %181, i64 9
  %183 = getelementptr inbounds double, ptr %181, i64 10
  %184 = getelementptr inbounds double, ptr %181, i64 11
  %185 = load double, ptr %182, align 8
  %186 = load double, ptr %183, align 8
  %187 = load double, ptr %184, align 8
  br label %188

188:                                              ; preds = %199, %172
  %189 = phi i64 [ 0, %172 ], [ %210, %199 ]
  %190 = mul nuw nsw i64 %189, 3
  %191 = getelementptr inbounds double, ptr %178, i64 %190
  %192 = add nuw nsw i64 %190, 1
  %193 = getelementptr inbounds double, ptr %178, i64 %192
  %194 = add nuw nsw i64 %190, 2
  %195 = getelementptr inbounds double, ptr %178, i64 %194
  %196 = load double, ptr %191, align 8
  %197 = load double, ptr %193, align 8
  %198 = load double, ptr %195, align 8
  br label %213

199:                                              ; preds = %213
  %200 = fmul double %196, %185
  %201 = fmul double %197, %186
  %202 = fadd double %200, %201
  %203 = fmul double %198, %187
  %204 = fadd double %202, %203
  %205 = add nuw nsw i64 %189, 9
  %206 = getelementptr inbounds double, ptr %178, i64 %205
  %207 = load double, ptr %206, align 8
  %208 = fadd double %207, %204
  %209 = getelementptr inbounds double, ptr %25, i64 %205
  store double %208, ptr %209, align 8
  %210 = add nuw nsw i64 %189, 1
  %211 = icmp eq i64 %210, 3
  br i1 %211, label %212, label %188

212:                                              ; preds = %199
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %24, ptr noundef nonnull align 8 dereferenceable(24) %70, i64 24, i1 false)
  br label %234

213:                                              ; preds = %213, %188
  %214 = phi i64 [ 0, %188 ], [ %230, %213 ]
  %215 = getelementptr inbounds double, ptr %181, i64 %214
  %216 = load double, ptr %215, align 8
  %217 = fmul double %196, %216
  %218 = add nuw nsw i64 %214, 3
  %219 = getelementptr inbounds double, ptr %181, i64 %218
  %220 = load double, ptr %219, align 8
  %221 = fmul double %197, %220
  %222 = fadd double %217, %221
  %223 = add nuw nsw i64 %214, 6
  %224 = getelementptr inbounds double, ptr %181, i64 %223
  %225 = load double, ptr %224, align 8
  %226 = fmul double %198, %225
  %227 = fadd double %222, %226
  %228 = add nuw nsw i64 %214, %190
  %229 = getelementptr inbounds double, ptr %25, i64 %228
  store double %227, ptr %229, align 8
  %230 = add nuw nsw i64 %214, 1
  %231 = icmp eq i64 %230, 3
  br i1 %231, label %199, label %213

232:                                              ; preds = %234
  %233 = call fastcc double @over_plane(ptr noundef %0, i64 noundef %77, ptr noundef nonnull %18, i64 noundef %80)
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %25) #19
  br label %304

234:                                              ; preds = %212, %234
  %235 = phi i64 [ 0, %212 ], [ %241, %234 ]
  %236 = mul nuw nsw i64 %235, 3
  %237 = add nuw nsw i64 %236, 2
  %238 = getelementptr inbounds [12 x double], ptr %25, i64 0, i64 %237
  %239 = load double, ptr %238, align 8
  %240 = getelementptr inbounds [3 x double], ptr %20, i64 0, i64 %235
  store double %239, ptr %240, align 8
  %241 = add nuw nsw i64 %235, 1
  %242 = icmp eq i64 %241, 3
  br i1 %242, label %232, label %234

243:                                              ; preds = %163
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %80, ptr noundef nonnull %19)
  %244 = load double, ptr %16, align 16
  %245 = fmul double %244, %244
  %246 = load double, ptr %35, align 8
  %247 = fmul double %246, %246
  %248 = fadd double %245, %247
  %249 = load double, ptr %36, align 16
  %250 = fmul double %249, %249
  %251 = fadd double %248, %250
  %252 = fcmp ogt double %251, 0.000000e+00
  br i1 %252, label %269, label %253

253:                                              ; preds = %243
  %254 = load ptr, ptr %37, align 8
  %255 = mul nsw i64 %77, 3
  %256 = mul nsw i64 %80, 3
  br label %257

257:                                              ; preds = %253, %257
  %258 = phi i64 [ 0, %253 ], [ %267, %257 ]
  %259 = add nsw i64 %255, %258
  %260 = getelementptr inbounds double, ptr %254, i64 %259
  %261 = load double, ptr %260, align 8
  %262 = add nsw i64 %256, %258
  %263 = getelementptr inbounds double, ptr %254, i64 %262
  %264 = load double, ptr %263, align 8
  %265 = fsub double %261, %264
  %266 = getelementptr inbounds [22 x double], ptr %16, i64 0, i64 %258
  store double %265, ptr %266, align 8
  %267 = add nuw nsw i64 %258, 1
  %268 = icmp eq i64 %267, 3
  br i1 %268, label %269, label %257

269:                                              ; preds = %257, %243
  %270 = getelementptr inbounds double, ptr %5, i64 %74
  %271 = load double, ptr %270, align 8
  %272 = load double, ptr %165, align 8
  %273 = load double, ptr %167, align 8
  %274 = fadd double %272, %273
  %275 = fadd double %271, %274
  %276 = fadd double %274, 0xFFF0000000000000
  %277 = call fastcc i32 @bounds_from(ptr noundef nonnull %18, ptr noundef nonnull %19, ptr noundef nonnull %16, double noundef %275, double noundef %276, double noundef 0x3DA5FD7FE1796495, ptr noundef nonnull %21, ptr noundef nonnull %22, ptr noundef nonnull %20, ptr noundef null, i32 noundef 0)
  %278 = icmp eq i32 %277, 0
  br i1 %278, label %279, label %299

279:                                              ; preds = %269
  call void @llvm.lifetime.start.p0(i64 176, ptr nonnull %26) #19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(176) %26, i8 0, i64 176, i1 false)
  %280 = load i64, ptr %31, align 8
  %281 = mul nsw i64 %280, %74
  %282 = getelementptr inbounds double, ptr %1, i64 %281
  %283 = load double, ptr %270, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %10) #19
  store double %283, ptr %10, align 8
  %284 = icmp sgt i64 %280, 0
  br i1 %284, label %288, label %294

285:                                              ; preds = %288
  %286 = add nuw nsw i64 %289, 1
  %287 = icmp eq i64 %286, %280
  br i1 %287, label %294, label %288

288:                                              ; preds = %279, %285
  %289 = phi i64 [ %286, %285 ], [ 0, %279 ]
  %290 = getelementptr inbounds double, ptr %282, i64 %289
  %291 = load double, ptr %290, align 8
  %292 = call double @llvm.fabs.f64(double %291) #18
  %293 = fcmp ueq double %292, 0x7FF0000000000000
  br i1 %293, label %296, label %285

294:                                              ; preds = %285, %279
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %11) #19
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %77, ptr noundef nonnull %11)
  call void @llvm.lifetime.start.p0(i64 168, ptr nonnull %12) #19
  store ptr %0, ptr %12, align 8
  store i64 %77, ptr %38, align 8
  store ptr %11, ptr %39, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %40, i8 0, i64 16, i1 false)
  store double %283, ptr %41, align 8
  store ptr %10, ptr %42, align 8
  store ptr null, ptr %43, align 8
  store i32 0, ptr %44, align 8
  store i64 -1, ptr %45, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %46, i8 0, i64 32, i1 false)
  store ptr %26, ptr %47, align 8
  store double 0.000000e+00, ptr %49, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(36) %48, i8 0, i64 36, i1 false)
  call fastcc void @look_at(ptr noundef nonnull %12, i64 noundef %80, ptr noundef null)
  %295 = load double, ptr %10, align 8
  call void @llvm.lifetime.end.p0(i64 168, ptr nonnull %12) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %11) #19
  br label %296

296:                                              ; preds = %288, %294
  %297 = phi double [ %295, %294 ], [ 0x7FF8000000000000, %288 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %10) #19
  %298 = getelementptr inbounds double, ptr %7, i64 %74
  store double %297, ptr %298, align 8
  call void @llvm.lifetime.end.p0(i64 176, ptr nonnull %26) #19
  br label %368

299:                                              ; preds = %269
  %300 = load double, ptr %22, align 8
  %301 = fsub double %300, %274
  %302 = load double, ptr %21, align 8
  %303 = fsub double %302, %274
  call fastcc void @support(ptr noundef nonnull %19, ptr noundef nonnull %20, ptr noundef nonnull %24)
  br label %304

304:                                              ; preds = %299, %232
  %305 = phi double [ %301, %299 ], [ %233, %232 ]
  %306 = phi double [ %303, %299 ], [ %233, %232 ]
  %307 = getelementptr inbounds double, ptr %5, i64 %74
  %308 = load double, ptr %307, align 8
  %309 = fcmp ogt double %306, %308
  br i1 %309, label %315, label %310

310:                                              ; preds = %304
  %311 = fsub double %305, %306
  %312 = fcmp ugt double %311, 1.000000e-08
  br i1 %312, label %313, label %315

313:                                              ; preds = %310
  %314 = getelementptr inbounds double, ptr %7, i64 %74
  store double 0x7FF8000000000000, ptr %314, align 8
  br label %368

315:                                              ; preds = %310, %304
  %316 = phi double [ %308, %304 ], [ %305, %310 ]
  %317 = getelementptr inbounds double, ptr %7, i64 %74
  store double %316, ptr %317, align 8
  %318 = fcmp uno double %316, 0.000000e+00
  br i1 %318, label %368, label %319

319:                                              ; preds = %315
  %320 = load double, ptr %307, align 8
  %321 = fcmp ult double %316, %320
  br i1 %321, label %322, label %368

322:                                              ; preds = %319
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %27) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %28) #19
  %323 = load ptr, ptr %33, align 8
  %324 = getelementptr inbounds i64, ptr %323, i64 %77
  %325 = load i64, ptr %324, align 8
  %326 = getelementptr inbounds i64, ptr %323, i64 %80
  %327 = load i64, ptr %326, align 8
  %328 = icmp slt i64 %325, %327
  br i1 %328, label %355, label %329

329:                                              ; preds = %322
  call fastcc void @twist_of(ptr noundef nonnull %0, i64 noundef %327, i64 noundef %325, ptr noundef %73, ptr noundef nonnull %27, ptr noundef nonnull %28)
  %330 = load double, ptr %20, align 8
  %331 = load double, ptr %24, align 16
  %332 = fmul double %330, %331
  %333 = load double, ptr %52, align 8
  %334 = load double, ptr %53, align 8
  %335 = fmul double %333, %334
  %336 = fadd double %332, %335
  %337 = load double, ptr %54, align 8
  %338 = load double, ptr %55, align 16
  %339 = fmul double %337, %338
  %340 = fadd double %336, %339
  %341 = call fastcc double @stays_apart(ptr noundef nonnull %18, double noundef %340, ptr noundef nonnull %20, ptr noundef nonnull %27, ptr noundef nonnull %28)
  br label %363

342:                                              ; preds = %355
  call fastcc void @support(ptr noundef nonnull %18, ptr noundef nonnull %23, ptr noundef nonnull %24)
  call fastcc void @twist_of(ptr noundef %0, i64 noundef %325, i64 noundef %327, ptr noundef %73, ptr noundef nonnull %27, ptr noundef nonnull %28)
  %343 = load double, ptr %23, align 16
  %344 = load double, ptr %24, align 16
  %345 = fmul double %343, %344
  %346 = load double, ptr %56, align 8
  %347 = load double, ptr %53, align 8
  %348 = fmul double %346, %347
  %349 = fadd double %345, %348
  %350 = load double, ptr %57, align 16
  %351 = load double, ptr %55, align 16
  %352 = fmul double %350, %351
  %353 = fadd double %349, %352
  %354 = call fastcc double @stays_apart(ptr noundef nonnull %19, double noundef %353, ptr noundef nonnull %23, ptr noundef nonnull %27, ptr noundef nonnull %28)
  br label %363

355:                                              ; preds = %322, %355
  %356 = phi i64 [ %361, %355 ], [ 0, %322 ]
  %357 = getelementptr inbounds [3 x double], ptr %20, i64 0, i64 %356
  %358 = load double, ptr %357, align 8
  %359 = fneg double %358
  %360 = getelementptr inbounds [3 x double], ptr %23, i64 0, i64 %356
  store double %359, ptr %360, align 8
  %361 = add nuw nsw i64 %356, 1
  %362 = icmp eq i64 %361, 3
  br i1 %362, label %342, label %355

363:                                              ; preds = %342, %329
  %364 = phi double [ %354, %342 ], [ %341, %329 ]
  %365 = fsub double %364, %169
  %366 = load double, ptr %129, align 8
  %367 = fsub double %365, %366
  store double %367, ptr %108, align 8
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %28) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %27) #19
  br label %368

368:                                              ; preds = %313, %315, %319, %363, %296
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %24) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %23) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %22) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %21) #19
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %20) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %19) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %18) #19
  br label %369

369:                                              ; preds = %368, %160
  %370 = add nuw nsw i64 %74, 1
  %371 = load i64, ptr %31, align 8
  %372 = getelementptr inbounds double, ptr %73, i64 %371
  %373 = icmp eq i64 %370, %3
  br i1 %373, label %71, label %72
}

declare double @llvm.fabs.f64(double) #4

define internal fastcc void @core_of(ptr nocapture noundef readonly %0, i64 noundef %1, ptr noundef %2) unnamed_addr #5 {
  %4 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 42
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i64, ptr %7, i64 %1
  %9 = load i64, ptr %8, align 8
  %10 = mul nsw i64 %9, 12
  %11 = getelementptr inbounds double, ptr %5, i64 %10
  %12 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 12
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i64, ptr %13, i64 %1
  %15 = load i64, ptr %14, align 8
  store i64 %15, ptr %2, align 8
  %16 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 17
  %17 = load ptr, ptr %16, align 8
  %18 = mul nsw i64 %1, 3
  %19 = getelementptr inbounds double, ptr %17, i64 %18
  %20 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 6
  store ptr %19, ptr %20, align 8
  %21 = icmp eq i64 %15, 0
  br i1 %21, label %22, label %44

22:                                               ; preds = %3
  %23 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 13
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr inbounds i64, ptr %24, i64 %1
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 14
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds i64, ptr %28, i64 %1
  %30 = load i64, ptr %29, align 8
  %31 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 1
  store i64 %30, ptr %31, align 8
  %32 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 20
  %33 = load ptr, ptr %32, align 8
  %34 = getelementptr inbounds double, ptr %33, i64 %26
  %35 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 2
  store ptr %34, ptr %35, align 8
  %36 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 21
  %37 = load ptr, ptr %36, align 8
  %38 = getelementptr inbounds double, ptr %37, i64 %26
  %39 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 3
  store ptr %38, ptr %39, align 8
  %40 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 22
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds double, ptr %41, i64 %26
  %43 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 4
  store ptr %42, ptr %43, align 8
  br label %102

44:                                               ; preds = %3
  %45 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 16
  %46 = load ptr, ptr %45, align 8
  %47 = mul nsw i64 %1, 12
  %48 = getelementptr inbounds double, ptr %46, i64 %47
  %49 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 7
  %50 = getelementptr inbounds double, ptr %48, i64 9
  %51 = getelementptr inbounds double, ptr %48, i64 10
  %52 = getelementptr inbounds double, ptr %48, i64 11
  br label %53

53:                                               ; preds = %61, %44
  %54 = phi i64 [ 0, %44 ], [ %78, %61 ]
  %55 = mul nuw nsw i64 %54, 3
  %56 = getelementptr inbounds double, ptr %11, i64 %55
  %57 = add nuw nsw i64 %55, 1
  %58 = getelementptr inbounds double, ptr %11, i64 %57
  %59 = add nuw nsw i64 %55, 2
  %60 = getelementptr inbounds double, ptr %11, i64 %59
  br label %80

61:                                               ; preds = %80
  %62 = load double, ptr %56, align 8
  %63 = load double, ptr %50, align 8
  %64 = fmul double %62, %63
  %65 = load double, ptr %58, align 8
  %66 = load double, ptr %51, align 8
  %67 = fmul double %65, %66
  %68 = fadd double %64, %67
  %69 = load double, ptr %60, align 8
  %70 = load double, ptr %52, align 8
  %71 = fmul double %69, %70
  %72 = fadd double %68, %71
  %73 = add nuw nsw i64 %54, 9
  %74 = getelementptr inbounds double, ptr %11, i64 %73
  %75 = load double, ptr %74, align 8
  %76 = fadd double %75, %72
  %77 = getelementptr inbounds double, ptr %49, i64 %73
  store double %76, ptr %77, align 8
  %78 = add nuw nsw i64 %54, 1
  %79 = icmp eq i64 %78, 3
  br i1 %79, label %102, label %53

80:                                               ; preds = %80, %53
  %81 = phi i64 [ 0, %53 ], [ %100, %80 ]
  %82 = load double, ptr %56, align 8
  %83 = getelementptr inbounds double, ptr %48, i64 %81
  %84 = load double, ptr %83, align 8
  %85 = fmul double %82, %84
  %86 = load double, ptr %58, align 8
  %87 = add nuw nsw i64 %81, 3
  %88 = getelementptr inbounds double, ptr %48, i64 %87
  %89 = load double, ptr %88, align 8
  %90 = fmul double %86, %89
  %91 = fadd double %85, %90
  %92 = load double, ptr %60, align 8
  %93 = add nuw nsw i64 %81, 6
  %94 = getelementptr inbounds double, ptr %48, i64 %93
  %95 = load double, ptr %94, align 8
  %96 = fmul double %92, %95
  %97 = fadd double %91, %96
  %98 = add nuw nsw i64 %81, %55
  %99 = getelementptr inbounds double, ptr %49, i64 %98
  store double %97, ptr %99, align 8
  %100 = add nuw nsw i64 %81, 1
  %101 = icmp eq i64 %100, 3
  br i1 %101, label %61, label %80

102:                                              ; preds = %61, %22
  %103 = phi ptr [ %11, %22 ], [ %49, %61 ]
  %104 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 5
  store ptr %103, ptr %104, align 8
  ret void
}

define internal fastcc double @over_plane(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef readonly %2, i64 noundef %3) unnamed_addr #3 {
  %5 = alloca [12 x double], align 16
  %6 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %5) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #19
  %7 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 42
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i64, ptr %10, i64 %3
  %12 = load i64, ptr %11, align 8
  %13 = mul nsw i64 %12, 12
  %14 = getelementptr inbounds double, ptr %8, i64 %13
  %15 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 16
  %16 = load ptr, ptr %15, align 8
  %17 = mul nsw i64 %3, 12
  %18 = getelementptr inbounds double, ptr %16, i64 %17
  %19 = getelementptr inbounds double, ptr %18, i64 9
  %20 = getelementptr inbounds double, ptr %18, i64 10
  %21 = getelementptr inbounds double, ptr %18, i64 11
  %22 = load double, ptr %19, align 8
  %23 = load double, ptr %20, align 8
  %24 = load double, ptr %21, align 8
  br label %25

25:                                               ; preds = %36, %4
  %26 = phi i64 [ 0, %4 ], [ %47, %36 ]
  %27 = mul nuw nsw i64 %26, 3
  %28 = getelementptr inbounds double, ptr %14, i64 %27
  %29 = add nuw nsw i64 %27, 1
  %30 = getelementptr inbounds double, ptr %14, i64 %29
  %31 = add nuw nsw i64 %27, 2
  %32 = getelementptr inbounds double, ptr %14, i64 %31
  %33 = load double, ptr %28, align 8
  %34 = load double, ptr %30, align 8
  %35 = load double, ptr %32, align 8
  br label %49

36:                                               ; preds = %49
  %37 = fmul double %33, %22
  %38 = fmul double %34, %23
  %39 = fadd double %37, %38
  %40 = fmul double %35, %24
  %41 = fadd double %39, %40
  %42 = add nuw nsw i64 %26, 9
  %43 = getelementptr inbounds double, ptr %14, i64 %42
  %44 = load double, ptr %43, align 8
  %45 = fadd double %44, %41
  %46 = getelementptr inbounds double, ptr %5, i64 %42
  store double %45, ptr %46, align 8
  %47 = add nuw nsw i64 %26, 1
  %48 = icmp eq i64 %47, 3
  br i1 %48, label %68, label %25

49:                                               ; preds = %49, %25
  %50 = phi i64 [ 0, %25 ], [ %66, %49 ]
  %51 = getelementptr inbounds double, ptr %18, i64 %50
  %52 = load double, ptr %51, align 8
  %53 = fmul double %33, %52
  %54 = add nuw nsw i64 %50, 3
  %55 = getelementptr inbounds double, ptr %18, i64 %54
  %56 = load double, ptr %55, align 8
  %57 = fmul double %34, %56
  %58 = fadd double %53, %57
  %59 = add nuw nsw i64 %50, 6
  %60 = getelementptr inbounds double, ptr %18, i64 %59
  %61 = load double, ptr %60, align 8
  %62 = fmul double %35, %61
  %63 = fadd double %58, %62
  %64 = add nuw nsw i64 %50, %27
  %65 = getelementptr inbounds double, ptr %5, i64 %64
  store double %63, ptr %65, align 8
  %66 = add nuw nsw i64 %50, 1
  %67 = icmp eq i64 %66, 3
  br i1 %67, label %36, label %49

68:                                               ; preds = %36
  %69 = call fastcc double @lowest(ptr noundef %0, i64 noundef %1, ptr noundef %2, ptr noundef nonnull %5, ptr noundef nonnull %6)
  %70 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 15
  %71 = load ptr, ptr %70, align 8
  %72 = getelementptr inbounds double, ptr %71, i64 %1
  %73 = load double, ptr %72, align 8
  %74 = fsub double %69, %73
  %75 = getelementptr inbounds double, ptr %71, i64 %3
  %76 = load double, ptr %75, align 8
  %77 = fsub double %74, %76
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #19
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %5) #19
  ret double %77
}

define internal fastcc i32 @shape_bounds(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef readonly %2, i64 noundef %3, ptr nocapture noundef readonly %4, ptr nocapture noundef %5, double noundef %6, double noundef %7, ptr nocapture noundef %8, ptr nocapture noundef %9, ptr noundef %10, ptr noundef %11) unnamed_addr #6 {
  %13 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 15
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds double, ptr %14, i64 %1
  %16 = load double, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %14, i64 %3
  %18 = load double, ptr %17, align 8
  %19 = fadd double %16, %18
  %20 = fadd double %19, %6
  %21 = fadd double %19, %7
  %22 = tail call fastcc i32 @bounds_from(ptr noundef %2, ptr noundef %4, ptr noundef %5, double noundef %20, double noundef %21, double noundef 0x3DA5FD7FE1796495, ptr noundef %8, ptr noundef %9, ptr noundef %10, ptr noundef %11, i32 noundef 0)
  %23 = load double, ptr %8, align 8
  %24 = fsub double %23, %19
  store double %24, ptr %8, align 8
  %25 = load double, ptr %9, align 8
  %26 = fsub double %25, %19
  store double %26, ptr %9, align 8
  ret i32 %22
}

define internal fastcc void @support(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef writeonly %2) unnamed_addr #7 {
  %4 = alloca [64 x double], align 16
  %5 = alloca [8 x double], align 16
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  %8 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 5
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds double, ptr %1, i64 1
  %11 = getelementptr inbounds double, ptr %1, i64 2
  %12 = load double, ptr %1, align 8
  %13 = load double, ptr %10, align 8
  %14 = load double, ptr %11, align 8
  br label %15

15:                                               ; preds = %15, %3
  %16 = phi i64 [ 0, %3 ], [ %31, %15 ]
  %17 = getelementptr inbounds double, ptr %9, i64 %16
  %18 = load double, ptr %17, align 8
  %19 = fmul double %18, %12
  %20 = add nuw nsw i64 %16, 3
  %21 = getelementptr inbounds double, ptr %9, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = fmul double %22, %13
  %24 = fadd double %19, %23
  %25 = add nuw nsw i64 %16, 6
  %26 = getelementptr inbounds double, ptr %9, i64 %25
  %27 = load double, ptr %26, align 8
  %28 = fmul double %27, %14
  %29 = fadd double %24, %28
  %30 = getelementptr inbounds double, ptr %6, i64 %16
  store double %29, ptr %30, align 8
  %31 = add nuw nsw i64 %16, 1
  %32 = icmp eq i64 %31, 3
  br i1 %32, label %33, label %15

33:                                               ; preds = %15
  %34 = load i64, ptr %0, align 8
  switch i64 %34, label %186 [
    i64 0, label %38
    i64 1, label %35
  ]

35:                                               ; preds = %33
  %36 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 6
  %37 = load ptr, ptr %36, align 8
  br label %174

38:                                               ; preds = %33
  %39 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 2
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 3
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 4
  %44 = load ptr, ptr %43, align 8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %4) #19
  %45 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 1
  %46 = load i64, ptr %45, align 8
  %47 = icmp slt i64 %46, 4
  br i1 %47, label %54, label %48

48:                                               ; preds = %38
  %49 = getelementptr inbounds double, ptr %6, i64 1
  %50 = getelementptr inbounds double, ptr %6, i64 2
  %51 = load double, ptr %6, align 16
  %52 = load double, ptr %49, align 8
  %53 = load double, ptr %50, align 16
  br label %82

54:                                               ; preds = %38
  %55 = icmp sgt i64 %46, 0
  br i1 %55, label %56, label %166

56:                                               ; preds = %54
  %57 = load double, ptr %6, align 16
  %58 = getelementptr inbounds double, ptr %6, i64 1
  %59 = load double, ptr %58, align 8
  %60 = getelementptr inbounds double, ptr %6, i64 2
  %61 = load double, ptr %60, align 16
  br label %62

62:                                               ; preds = %62, %56
  %63 = phi double [ 0xFFF0000000000000, %56 ], [ %79, %62 ]
  %64 = phi i64 [ 0, %56 ], [ %80, %62 ]
  %65 = phi i64 [ 0, %56 ], [ %78, %62 ]
  %66 = getelementptr inbounds double, ptr %40, i64 %64
  %67 = load double, ptr %66, align 8
  %68 = fmul double %57, %67
  %69 = getelementptr inbounds double, ptr %42, i64 %64
  %70 = load double, ptr %69, align 8
  %71 = fmul double %59, %70
  %72 = fadd double %68, %71
  %73 = getelementptr inbounds double, ptr %44, i64 %64
  %74 = load double, ptr %73, align 8
  %75 = fmul double %61, %74
  %76 = fadd double %72, %75
  %77 = fcmp ogt double %76, %63
  %78 = select i1 %77, i64 %64, i64 %65
  %79 = select i1 %77, double %76, double %63
  %80 = add nuw nsw i64 %64, 1
  %81 = icmp eq i64 %80, %46
  br i1 %81, label %166, label %62

82:                                               ; preds = %160, %48
  %83 = phi i64 [ %46, %48 ], [ %165, %160 ]
  %84 = phi i64 [ 0, %48 ], [ %163, %160 ]
  %85 = phi double [ 0xFFF0000000000000, %48 ], [ %162, %160 ]
  %86 = phi i64 [ 0, %48 ], [ %161, %160 ]
  %87 = tail call i64 @llvm.smin.i64(i64 %83, i64 64)
  call void @llvm.lifetime.start.p0(i64 64, ptr nonnull %5) #19
  br label %90

88:                                               ; preds = %90
  %89 = tail call i64 @llvm.smax.i64(i64 %87, i64 1)
  br label %98

90:                                               ; preds = %90, %82
  %91 = phi i64 [ 0, %82 ], [ %93, %90 ]
  %92 = getelementptr inbounds [8 x double], ptr %5, i64 0, i64 %91
  store double 0xFFF0000000000000, ptr %92, align 8
  %93 = add nuw nsw i64 %91, 1
  %94 = icmp eq i64 %93, 8
  br i1 %94, label %88, label %90

95:                                               ; preds = %98
  %96 = and i64 %89, 7
  %97 = icmp eq i64 %96, 0
  br i1 %97, label %115, label %117

98:                                               ; preds = %88, %98
  %99 = phi i64 [ %113, %98 ], [ 0, %88 ]
  %100 = add nuw nsw i64 %99, %84
  %101 = getelementptr inbounds double, ptr %40, i64 %100
  %102 = load double, ptr %101, align 8
  %103 = fmul double %51, %102
  %104 = getelementptr inbounds double, ptr %42, i64 %100
  %105 = load double, ptr %104, align 8
  %106 = fmul double %52, %105
  %107 = fadd double %103, %106
  %108 = getelementptr inbounds double, ptr %44, i64 %100
  %109 = load double, ptr %108, align 8
  %110 = fmul double %53, %109
  %111 = fadd double %107, %110
  %112 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %99
  store double %111, ptr %112, align 8
  %113 = add nuw nsw i64 %99, 1
  %114 = icmp eq i64 %113, %89
  br i1 %114, label %95, label %98

115:                                              ; preds = %117, %95
  %116 = phi i64 [ %89, %95 ], [ %120, %117 ]
  br label %123

117:                                              ; preds = %95, %117
  %118 = phi i64 [ %120, %117 ], [ %89, %95 ]
  %119 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %118
  store double 0xFFF0000000000000, ptr %119, align 8
  %120 = add nuw nsw i64 %118, 1
  %121 = and i64 %120, 7
  %122 = icmp eq i64 %121, 0
  br i1 %122, label %115, label %117

123:                                              ; preds = %127, %115
  %124 = phi i64 [ %128, %127 ], [ 0, %115 ]
  br label %130

125:                                              ; preds = %127
  %126 = load double, ptr %5, align 16
  br label %143

127:                                              ; preds = %130
  %128 = add nuw nsw i64 %124, 8
  %129 = icmp ult i64 %128, %116
  br i1 %129, label %123, label %125

130:                                              ; preds = %130, %123
  %131 = phi i64 [ 0, %123 ], [ %139, %130 ]
  %132 = add nuw nsw i64 %131, %124
  %133 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %132
  %134 = load double, ptr %133, align 8
  %135 = getelementptr inbounds [8 x double], ptr %5, i64 0, i64 %131
  %136 = load double, ptr %135, align 8
  %137 = fcmp ogt double %134, %136
  %138 = select i1 %137, double %134, double %136
  store double %138, ptr %135, align 8
  %139 = add nuw nsw i64 %131, 1
  %140 = icmp eq i64 %139, 8
  br i1 %140, label %127, label %130

141:                                              ; preds = %143
  %142 = fcmp ogt double %149, %85
  br i1 %142, label %152, label %160

143:                                              ; preds = %143, %125
  %144 = phi i64 [ 1, %125 ], [ %150, %143 ]
  %145 = phi double [ %126, %125 ], [ %149, %143 ]
  %146 = getelementptr inbounds [8 x double], ptr %5, i64 0, i64 %144
  %147 = load double, ptr %146, align 8
  %148 = fcmp ogt double %147, %145
  %149 = select i1 %148, double %147, double %145
  %150 = add nuw nsw i64 %144, 1
  %151 = icmp eq i64 %150, 8
  br i1 %151, label %141, label %143

152:                                              ; preds = %141, %152
  %153 = phi i64 [ %157, %152 ], [ 0, %141 ]
  %154 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %153
  %155 = load double, ptr %154, align 8
  %156 = fcmp une double %155, %149
  %157 = add nuw nsw i64 %153, 1
  br i1 %156, label %152, label %158

158:                                              ; preds = %152
  %159 = add nuw nsw i64 %153, %84
  br label %160

160:                                              ; preds = %158, %141
  %161 = phi i64 [ %159, %158 ], [ %86, %141 ]
  %162 = phi double [ %149, %158 ], [ %85, %141 ]
  call void @llvm.lifetime.end.p0(i64 64, ptr nonnull %5) #19
  %163 = add nuw nsw i64 %84, 64
  %164 = icmp sgt i64 %46, %163
  %165 = add i64 %83, -64
  br i1 %164, label %82, label %166

166:                                              ; preds = %160, %62, %54
  %167 = phi i64 [ 0, %54 ], [ %78, %62 ], [ %161, %160 ]
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %4) #19
  %168 = getelementptr inbounds double, ptr %40, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = getelementptr inbounds double, ptr %42, i64 %167
  %171 = load double, ptr %170, align 8
  %172 = getelementptr inbounds double, ptr %44, i64 %167
  %173 = load double, ptr %172, align 8
  br label %219

174:                                              ; preds = %35, %174
  %175 = phi i64 [ 0, %35 ], [ %184, %174 ]
  %176 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %175
  %177 = load double, ptr %176, align 8
  %178 = fcmp ult double %177, 0.000000e+00
  %179 = getelementptr inbounds double, ptr %37, i64 %175
  %180 = load double, ptr %179, align 8
  %181 = fneg double %180
  %182 = select i1 %178, double %181, double %180
  %183 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %175
  store double %182, ptr %183, align 8
  %184 = add nuw nsw i64 %175, 1
  %185 = icmp eq i64 %184, 3
  br i1 %185, label %213, label %174

186:                                              ; preds = %33
  %187 = load double, ptr %6, align 16
  %188 = fmul double %187, %187
  %189 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 1
  %190 = load double, ptr %189, align 8
  %191 = fmul double %190, %190
  %192 = fadd double %188, %191
  %193 = tail call double @llvm.sqrt.f64(double %192)
  %194 = fcmp ogt double %193, 0.000000e+00
  br i1 %194, label %195, label %200

195:                                              ; preds = %186
  %196 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 6
  %197 = load ptr, ptr %196, align 8
  %198 = load double, ptr %197, align 8
  %199 = fdiv double %198, %193
  br label %200

200:                                              ; preds = %186, %195
  %201 = phi double [ %199, %195 ], [ 0.000000e+00, %186 ]
  %202 = fmul double %187, %201
  %203 = fmul double %190, %201
  %204 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 2
  %205 = load double, ptr %204, align 16
  %206 = fcmp ult double %205, 0.000000e+00
  %207 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 6
  %208 = load ptr, ptr %207, align 8
  %209 = getelementptr inbounds double, ptr %208, i64 1
  %210 = load double, ptr %209, align 8
  %211 = fneg double %210
  %212 = select i1 %206, double %211, double %210
  br label %219

213:                                              ; preds = %174
  %214 = load double, ptr %7, align 16
  %215 = getelementptr inbounds double, ptr %7, i64 1
  %216 = load double, ptr %215, align 8
  %217 = getelementptr inbounds double, ptr %7, i64 2
  %218 = load double, ptr %217, align 16
  br label %219

219:                                              ; preds = %213, %200, %166
  %220 = phi double [ %218, %213 ], [ %212, %200 ], [ %173, %166 ]
  %221 = phi double [ %216, %213 ], [ %203, %200 ], [ %171, %166 ]
  %222 = phi double [ %214, %213 ], [ %202, %200 ], [ %169, %166 ]
  br label %223

223:                                              ; preds = %223, %219
  %224 = phi i64 [ 0, %219 ], [ %244, %223 ]
  %225 = mul nuw nsw i64 %224, 3
  %226 = getelementptr inbounds double, ptr %9, i64 %225
  %227 = load double, ptr %226, align 8
  %228 = fmul double %227, %222
  %229 = add nuw nsw i64 %225, 1
  %230 = getelementptr inbounds double, ptr %9, i64 %229
  %231 = load double, ptr %230, align 8
  %232 = fmul double %231, %221
  %233 = fadd double %228, %232
  %234 = add nuw nsw i64 %225, 2
  %235 = getelementptr inbounds double, ptr %9, i64 %234
  %236 = load double, ptr %235, align 8
  %237 = fmul double %236, %220
  %238 = fadd double %233, %237
  %239 = add nuw nsw i64 %224, 9
  %240 = getelementptr inbounds double, ptr %9, i64 %239
  %241 = load double, ptr %240, align 8
  %242 = fadd double %241, %238
  %243 = getelementptr inbounds double, ptr %2, i64 %224
  store double %242, ptr %243, align 8
  %244 = add nuw nsw i64 %224, 1
  %245 = icmp eq i64 %244, 3
  br i1 %245, label %246, label %223

246:                                              ; preds = %223
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #19
  ret void
}

define internal fastcc void @twist_of(ptr nocapture noundef readonly %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef %4, ptr nocapture noundef %5) unnamed_addr #7 {
  %7 = alloca [3 x double], align 16
  %8 = alloca [3 x double], align 16
  br label %25

9:                                                ; preds = %25
  %10 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 6
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr %0, align 8
  %13 = add i64 %12, 1
  %14 = mul nsw i64 %13, %1
  %15 = getelementptr inbounds i64, ptr %11, i64 %14
  %16 = mul nsw i64 %13, %2
  %17 = getelementptr inbounds i64, ptr %11, i64 %16
  %18 = icmp slt i64 %12, 1
  br i1 %18, label %31, label %19

19:                                               ; preds = %9
  %20 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 42
  %21 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 3
  %22 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 2
  %23 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 8
  %24 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 9
  br label %32

25:                                               ; preds = %6, %25
  %26 = phi i64 [ 0, %6 ], [ %29, %25 ]
  %27 = getelementptr inbounds double, ptr %5, i64 %26
  store double 0.000000e+00, ptr %27, align 8
  %28 = getelementptr inbounds double, ptr %4, i64 %26
  store double 0.000000e+00, ptr %28, align 8
  %29 = add nuw nsw i64 %26, 1
  %30 = icmp eq i64 %29, 3
  br i1 %30, label %9, label %25

31:                                               ; preds = %131, %9
  ret void

32:                                               ; preds = %19, %131
  %33 = phi i64 [ 1, %19 ], [ %132, %131 ]
  %34 = getelementptr inbounds i64, ptr %15, i64 %33
  %35 = load i64, ptr %34, align 8
  %36 = getelementptr inbounds i64, ptr %17, i64 %33
  %37 = load i64, ptr %36, align 8
  %38 = icmp eq i64 %35, %37
  br i1 %38, label %131, label %39

39:                                               ; preds = %32
  %40 = load ptr, ptr %20, align 8
  %41 = mul nsw i64 %33, 12
  %42 = getelementptr inbounds double, ptr %40, i64 %41
  %43 = load ptr, ptr %21, align 8
  %44 = add nsw i64 %33, -1
  %45 = getelementptr inbounds double, ptr %43, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = load ptr, ptr %22, align 8
  %48 = getelementptr inbounds i64, ptr %47, i64 %44
  %49 = load i64, ptr %48, align 8
  %50 = getelementptr inbounds double, ptr %3, i64 %49
  %51 = load double, ptr %50, align 8
  %52 = fmul double %46, %51
  %53 = icmp eq i64 %37, 0
  %54 = fneg double %52
  %55 = select i1 %53, double %54, double %52
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  %56 = load ptr, ptr %23, align 8
  %57 = mul nsw i64 %44, 3
  %58 = getelementptr inbounds double, ptr %56, i64 %57
  %59 = load double, ptr %58, align 8
  %60 = getelementptr inbounds double, ptr %58, i64 1
  %61 = load double, ptr %60, align 8
  %62 = getelementptr inbounds double, ptr %58, i64 2
  %63 = load double, ptr %62, align 8
  br label %95

64:                                               ; preds = %95
  %65 = getelementptr inbounds double, ptr %42, i64 9
  br label %66

66:                                               ; preds = %66, %64
  %67 = phi i64 [ 0, %64 ], [ %68, %66 ]
  %68 = add nuw nsw i64 %67, 1
  %69 = icmp ult i64 %67, 2
  %70 = add nuw nsw i64 %67, 4294967294
  %71 = select i1 %69, i64 %68, i64 %70
  %72 = and i64 %71, 4294967295
  %73 = getelementptr inbounds double, ptr %65, i64 %72
  %74 = load double, ptr %73, align 8
  %75 = icmp eq i64 %67, 0
  %76 = add nuw nsw i64 %67, 4294967295
  %77 = and i64 %76, 4294967295
  %78 = select i1 %75, i64 2, i64 %77
  %79 = getelementptr inbounds double, ptr %7, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = fmul double %74, %80
  %82 = getelementptr inbounds double, ptr %65, i64 %78
  %83 = load double, ptr %82, align 8
  %84 = getelementptr inbounds double, ptr %7, i64 %72
  %85 = load double, ptr %84, align 8
  %86 = fmul double %83, %85
  %87 = fsub double %81, %86
  %88 = getelementptr inbounds double, ptr %8, i64 %67
  store double %87, ptr %88, align 8
  %89 = icmp eq i64 %68, 3
  br i1 %89, label %90, label %66

90:                                               ; preds = %66
  %91 = load ptr, ptr %24, align 8
  %92 = getelementptr inbounds i64, ptr %91, i64 %44
  %93 = load i64, ptr %92, align 8
  %94 = icmp eq i64 %93, 0
  br label %114

95:                                               ; preds = %39, %95
  %96 = phi i64 [ 0, %39 ], [ %111, %95 ]
  %97 = mul nuw nsw i64 %96, 3
  %98 = getelementptr inbounds double, ptr %42, i64 %97
  %99 = load double, ptr %98, align 8
  %100 = fmul double %99, %59
  %101 = getelementptr inbounds double, ptr %98, i64 1
  %102 = load double, ptr %101, align 8
  %103 = fmul double %102, %61
  %104 = fadd double %100, %103
  %105 = getelementptr inbounds double, ptr %98, i64 2
  %106 = load double, ptr %105, align 8
  %107 = fmul double %106, %63
  %108 = fadd double %104, %107
  %109 = fmul double %55, %108
  %110 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %96
  store double %109, ptr %110, align 8
  %111 = add nuw nsw i64 %96, 1
  %112 = icmp eq i64 %111, 3
  br i1 %112, label %64, label %95

113:                                              ; preds = %124
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  br label %131

114:                                              ; preds = %90, %124
  %115 = phi i64 [ 0, %90 ], [ %129, %124 ]
  %116 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %115
  %117 = load double, ptr %116, align 8
  br i1 %94, label %118, label %124

118:                                              ; preds = %114
  %119 = getelementptr inbounds double, ptr %4, i64 %115
  %120 = load double, ptr %119, align 8
  %121 = fadd double %117, %120
  store double %121, ptr %119, align 8
  %122 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %115
  %123 = load double, ptr %122, align 8
  br label %124

124:                                              ; preds = %114, %118
  %125 = phi double [ %123, %118 ], [ %117, %114 ]
  %126 = getelementptr inbounds double, ptr %5, i64 %115
  %127 = load double, ptr %126, align 8
  %128 = fadd double %125, %127
  store double %128, ptr %126, align 8
  %129 = add nuw nsw i64 %115, 1
  %130 = icmp eq i64 %129, 3
  br i1 %130, label %113, label %114

131:                                              ; preds = %32, %113
  %132 = add nuw i64 %33, 1
  %133 = icmp eq i64 %33, %12
  br i1 %133, label %31, label %32
}

define internal fastcc double @stays_apart(ptr nocapture noundef readonly %0, double noundef %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4) unnamed_addr #7 {
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  %8 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #19
  br label %9

9:                                                ; preds = %9, %5
  %10 = phi i64 [ 0, %5 ], [ %11, %9 ]
  %11 = add nuw nsw i64 %10, 1
  %12 = icmp ult i64 %10, 2
  %13 = add nuw nsw i64 %10, 4294967294
  %14 = select i1 %12, i64 %11, i64 %13
  %15 = and i64 %14, 4294967295
  %16 = getelementptr inbounds double, ptr %2, i64 %15
  %17 = load double, ptr %16, align 8
  %18 = icmp eq i64 %10, 0
  %19 = add nuw nsw i64 %10, 4294967295
  %20 = and i64 %19, 4294967295
  %21 = select i1 %18, i64 2, i64 %20
  %22 = getelementptr inbounds double, ptr %3, i64 %21
  %23 = load double, ptr %22, align 8
  %24 = fmul double %17, %23
  %25 = getelementptr inbounds double, ptr %2, i64 %21
  %26 = load double, ptr %25, align 8
  %27 = getelementptr inbounds double, ptr %3, i64 %15
  %28 = load double, ptr %27, align 8
  %29 = fmul double %26, %28
  %30 = fsub double %24, %29
  %31 = getelementptr inbounds double, ptr %6, i64 %10
  store double %30, ptr %31, align 8
  %32 = icmp eq i64 %11, 3
  br i1 %32, label %33, label %9

33:                                               ; preds = %9
  %34 = getelementptr inbounds double, ptr %2, i64 1
  %35 = getelementptr inbounds double, ptr %4, i64 1
  %36 = getelementptr inbounds double, ptr %2, i64 2
  %37 = getelementptr inbounds double, ptr %4, i64 2
  %38 = getelementptr inbounds double, ptr %7, i64 1
  %39 = getelementptr inbounds double, ptr %8, i64 1
  %40 = getelementptr inbounds double, ptr %7, i64 2
  %41 = getelementptr inbounds double, ptr %8, i64 2
  br label %44

42:                                               ; preds = %48
  %43 = fsub double %73, %1
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #19
  ret double %43

44:                                               ; preds = %33, %48
  %45 = phi i32 [ -1, %33 ], [ %74, %48 ]
  %46 = phi double [ 0x7FF0000000000000, %33 ], [ %73, %48 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  %47 = sitofp i32 %45 to double
  br label %76

48:                                               ; preds = %76
  call fastcc void @support(ptr noundef %0, ptr noundef nonnull %7, ptr noundef nonnull %8)
  %49 = load double, ptr %2, align 8
  %50 = load double, ptr %4, align 8
  %51 = fmul double %49, %50
  %52 = load double, ptr %34, align 8
  %53 = load double, ptr %35, align 8
  %54 = fmul double %52, %53
  %55 = fadd double %51, %54
  %56 = load double, ptr %36, align 8
  %57 = load double, ptr %37, align 8
  %58 = fmul double %56, %57
  %59 = fadd double %55, %58
  %60 = fmul double %59, %47
  %61 = load double, ptr %7, align 16
  %62 = load double, ptr %8, align 16
  %63 = fmul double %61, %62
  %64 = load double, ptr %38, align 8
  %65 = load double, ptr %39, align 8
  %66 = fmul double %64, %65
  %67 = fadd double %63, %66
  %68 = load double, ptr %40, align 16
  %69 = load double, ptr %41, align 16
  %70 = fmul double %68, %69
  %71 = fadd double %67, %70
  %72 = fsub double %60, %71
  %73 = tail call double @llvm.minnum.f64(double %46, double %72)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  %74 = add nsw i32 %45, 2
  %75 = icmp slt i32 %45, 0
  br i1 %75, label %44, label %42

76:                                               ; preds = %44, %76
  %77 = phi i64 [ 0, %44 ], [ %86, %76 ]
  %78 = getelementptr inbounds double, ptr %2, i64 %77
  %79 = load double, ptr %78, align 8
  %80 = fneg double %79
  %81 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %77
  %82 = load double, ptr %81, align 8
  %83 = fmul double %82, %47
  %84 = fsub double %80, %83
  %85 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %77
  store double %84, ptr %85, align 8
  %86 = add nuw nsw i64 %77, 1
  %87 = icmp eq i64 %86, 3
  br i1 %87, label %48, label %76
}

define dso_local void @manipplan_witnesses(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef %4) local_unnamed_addr #0 {
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  %8 = alloca double, align 8
  %9 = alloca [3 x double], align 16
  %10 = alloca [3 x double], align 16
  %11 = alloca [3 x double], align 16
  %12 = alloca [3 x double], align 16
  %13 = alloca [3 x double], align 16
  %14 = icmp sgt i64 %2, 0
  br i1 %14, label %15, label %36

15:                                               ; preds = %5
  %16 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %17 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %18 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 42
  %19 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 15
  %20 = getelementptr inbounds double, ptr %9, i64 1
  %21 = getelementptr inbounds double, ptr %9, i64 2
  %22 = getelementptr inbounds double, ptr %10, i64 1
  %23 = getelementptr inbounds double, ptr %10, i64 2
  %24 = getelementptr inbounds double, ptr %6, i64 1
  %25 = getelementptr inbounds double, ptr %6, i64 2
  %26 = getelementptr inbounds double, ptr %7, i64 1
  %27 = getelementptr inbounds double, ptr %7, i64 2
  %28 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 8
  %29 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 6
  %30 = getelementptr inbounds double, ptr %12, i64 1
  %31 = getelementptr inbounds double, ptr %12, i64 2
  %32 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 9
  %33 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 3
  %34 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 2
  %35 = load i64, ptr %17, align 8
  br label %37

36:                                               ; preds = %340, %5
  ret void

37:                                               ; preds = %15, %340
  %38 = phi i64 [ %35, %15 ], [ %342, %340 ]
  %39 = phi ptr [ %1, %15 ], [ %343, %340 ]
  %40 = phi ptr [ %4, %15 ], [ %345, %340 ]
  %41 = phi i64 [ 0, %15 ], [ %341, %340 ]
  %42 = shl nuw nsw i64 %41, 1
  %43 = getelementptr inbounds i64, ptr %3, i64 %42
  %44 = load i64, ptr %43, align 8
  %45 = or i64 %42, 1
  %46 = getelementptr inbounds i64, ptr %3, i64 %45
  %47 = load i64, ptr %46, align 8
  %48 = load ptr, ptr %16, align 8
  %49 = getelementptr inbounds i64, ptr %48, i64 %44
  %50 = load i64, ptr %49, align 8
  %51 = getelementptr inbounds i64, ptr %48, i64 %47
  %52 = load i64, ptr %51, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %8) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %10) #19
  %53 = icmp sgt i64 %38, 0
  br i1 %53, label %56, label %67

54:                                               ; preds = %56
  %55 = icmp eq i32 %64, 0
  br i1 %55, label %72, label %67

56:                                               ; preds = %37, %56
  %57 = phi i32 [ %64, %56 ], [ 1, %37 ]
  %58 = phi i64 [ %65, %56 ], [ 0, %37 ]
  %59 = getelementptr inbounds double, ptr %39, i64 %58
  %60 = load double, ptr %59, align 8
  %61 = call double @llvm.fabs.f64(double %60) #18
  %62 = fcmp one double %61, 0x7FF0000000000000
  %63 = zext i1 %62 to i32
  %64 = and i32 %57, %63
  %65 = add nuw nsw i64 %58, 1
  %66 = icmp eq i64 %65, %38
  br i1 %66, label %54, label %56

67:                                               ; preds = %37, %54
  call fastcc void @place(ptr noundef nonnull %0, ptr noundef %39)
  %68 = call fastcc i32 @nearest_points(ptr noundef nonnull %0, i64 noundef %44, i64 noundef %47, ptr noundef nonnull %6, ptr noundef nonnull %7, ptr noundef nonnull %8, ptr noundef nonnull %9)
  %69 = icmp eq i32 %68, 0
  br i1 %69, label %70, label %83

70:                                               ; preds = %67
  %71 = load i64, ptr %17, align 8
  br label %72

72:                                               ; preds = %70, %54
  %73 = phi i64 [ %71, %70 ], [ %38, %54 ]
  %74 = icmp sgt i64 %73, -13
  br i1 %74, label %75, label %340

75:                                               ; preds = %72
  %76 = add i64 %73, 12
  %77 = call i64 @llvm.smax.i64(i64 %76, i64 0)
  br label %78

78:                                               ; preds = %75, %78
  %79 = phi i64 [ %81, %78 ], [ 0, %75 ]
  %80 = getelementptr inbounds double, ptr %40, i64 %79
  store double 0x7FF8000000000000, ptr %80, align 8
  %81 = add nuw i64 %79, 1
  %82 = icmp eq i64 %79, %77
  br i1 %82, label %340, label %78

83:                                               ; preds = %67
  %84 = load ptr, ptr %18, align 8
  %85 = mul nsw i64 %50, 12
  %86 = mul nsw i64 %52, 12
  br label %220

87:                                               ; preds = %220
  %88 = getelementptr inbounds double, ptr %84, i64 %86
  %89 = load double, ptr %8, align 8
  %90 = load ptr, ptr %19, align 8
  %91 = getelementptr inbounds double, ptr %90, i64 %44
  %92 = load double, ptr %91, align 8
  %93 = fsub double %89, %92
  %94 = getelementptr inbounds double, ptr %90, i64 %47
  %95 = load double, ptr %94, align 8
  %96 = fsub double %93, %95
  store double %96, ptr %40, align 8
  %97 = getelementptr inbounds double, ptr %40, i64 1
  %98 = load double, ptr %9, align 16
  %99 = load double, ptr %20, align 8
  %100 = load double, ptr %21, align 16
  br label %101

101:                                              ; preds = %101, %87
  %102 = phi i64 [ 0, %87 ], [ %117, %101 ]
  %103 = getelementptr inbounds double, ptr %88, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = fmul double %104, %98
  %106 = add nuw nsw i64 %102, 3
  %107 = getelementptr inbounds double, ptr %88, i64 %106
  %108 = load double, ptr %107, align 8
  %109 = fmul double %108, %99
  %110 = fadd double %105, %109
  %111 = add nuw nsw i64 %102, 6
  %112 = getelementptr inbounds double, ptr %88, i64 %111
  %113 = load double, ptr %112, align 8
  %114 = fmul double %113, %100
  %115 = fadd double %110, %114
  %116 = getelementptr inbounds double, ptr %97, i64 %102
  store double %115, ptr %116, align 8
  %117 = add nuw nsw i64 %102, 1
  %118 = icmp eq i64 %117, 3
  br i1 %118, label %119, label %101

119:                                              ; preds = %101
  %120 = getelementptr inbounds double, ptr %84, i64 %85
  %121 = getelementptr inbounds double, ptr %40, i64 4
  %122 = load double, ptr %10, align 16
  %123 = load double, ptr %22, align 8
  %124 = load double, ptr %23, align 16
  br label %125

125:                                              ; preds = %125, %119
  %126 = phi i64 [ 0, %119 ], [ %141, %125 ]
  %127 = getelementptr inbounds double, ptr %120, i64 %126
  %128 = load double, ptr %127, align 8
  %129 = fmul double %128, %122
  %130 = add nuw nsw i64 %126, 3
  %131 = getelementptr inbounds double, ptr %120, i64 %130
  %132 = load double, ptr %131, align 8
  %133 = fmul double %132, %123
  %134 = fadd double %129, %133
  %135 = add nuw nsw i64 %126, 6
  %136 = getelementptr inbounds double, ptr %120, i64 %135
  %137 = load double, ptr %136, align 8
  %138 = fmul double %137, %124
  %139 = fadd double %134, %138
  %140 = getelementptr inbounds double, ptr %121, i64 %126
  store double %139, ptr %140, align 8
  %141 = add nuw nsw i64 %126, 1
  %142 = icmp eq i64 %141, 3
  br i1 %142, label %143, label %125

143:                                              ; preds = %125
  %144 = getelementptr inbounds double, ptr %40, i64 7
  %145 = load double, ptr %6, align 16
  %146 = getelementptr inbounds double, ptr %120, i64 9
  %147 = load double, ptr %146, align 8
  %148 = fsub double %145, %147
  %149 = load double, ptr %24, align 8
  %150 = getelementptr inbounds double, ptr %120, i64 10
  %151 = load double, ptr %150, align 8
  %152 = fsub double %149, %151
  %153 = load double, ptr %25, align 16
  %154 = getelementptr inbounds double, ptr %120, i64 11
  %155 = load double, ptr %154, align 8
  %156 = fsub double %153, %155
  br label %157

157:                                              ; preds = %157, %143
  %158 = phi i64 [ 0, %143 ], [ %173, %157 ]
  %159 = getelementptr inbounds double, ptr %120, i64 %158
  %160 = load double, ptr %159, align 8
  %161 = fmul double %148, %160
  %162 = add nuw nsw i64 %158, 3
  %163 = getelementptr inbounds double, ptr %120, i64 %162
  %164 = load double, ptr %163, align 8
  %165 = fmul double %152, %164
  %166 = fadd double %161, %165
  %167 = add nuw nsw i64 %158, 6
  %168 = getelementptr inbounds double, ptr %120, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = fmul double %156, %169
  %171 = fadd double %166, %170
  %172 = getelementptr inbounds double, ptr %144, i64 %158
  store double %171, ptr %172, align 8
  %173 = add nuw nsw i64 %158, 1
  %174 = icmp eq i64 %173, 3
  br i1 %174, label %175, label %157

175:                                              ; preds = %157
  %176 = getelementptr inbounds double, ptr %40, i64 10
  %177 = load double, ptr %7, align 16
  %178 = getelementptr inbounds double, ptr %88, i64 9
  %179 = load double, ptr %178, align 8
  %180 = fsub double %177, %179
  %181 = load double, ptr %26, align 8
  %182 = getelementptr inbounds double, ptr %88, i64 10
  %183 = load double, ptr %182, align 8
  %184 = fsub double %181, %183
  %185 = load double, ptr %27, align 16
  %186 = getelementptr inbounds double, ptr %88, i64 11
  %187 = load double, ptr %186, align 8
  %188 = fsub double %185, %187
  br label %189

189:                                              ; preds = %189, %175
  %190 = phi i64 [ 0, %175 ], [ %205, %189 ]
  %191 = getelementptr inbounds double, ptr %88, i64 %190
  %192 = load double, ptr %191, align 8
  %193 = fmul double %180, %192
  %194 = add nuw nsw i64 %190, 3
  %195 = getelementptr inbounds double, ptr %88, i64 %194
  %196 = load double, ptr %195, align 8
  %197 = fmul double %184, %196
  %198 = fadd double %193, %197
  %199 = add nuw nsw i64 %190, 6
  %200 = getelementptr inbounds double, ptr %88, i64 %199
  %201 = load double, ptr %200, align 8
  %202 = fmul double %188, %201
  %203 = fadd double %198, %202
  %204 = getelementptr inbounds double, ptr %176, i64 %190
  store double %203, ptr %204, align 8
  %205 = add nuw nsw i64 %190, 1
  %206 = icmp eq i64 %205, 3
  br i1 %206, label %207, label %189

207:                                              ; preds = %189
  %208 = getelementptr inbounds double, ptr %40, i64 13
  %209 = load i64, ptr %17, align 8
  %210 = shl i64 %209, 3
  call void @llvm.memset.p0.i64(ptr nonnull align 8 %208, i8 0, i64 %210, i1 false)
  %211 = load i64, ptr %0, align 8
  %212 = icmp slt i64 %211, 1
  br i1 %212, label %340, label %213

213:                                              ; preds = %207
  %214 = load ptr, ptr %18, align 8
  %215 = load ptr, ptr %28, align 8
  %216 = load ptr, ptr %29, align 8
  %217 = add nuw i64 %211, 1
  %218 = load ptr, ptr %33, align 8
  %219 = load ptr, ptr %34, align 8
  br label %228

220:                                              ; preds = %83, %220
  %221 = phi i64 [ 0, %83 ], [ %226, %220 ]
  %222 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %221
  %223 = load double, ptr %222, align 8
  %224 = fneg double %223
  %225 = getelementptr inbounds [3 x double], ptr %10, i64 0, i64 %221
  store double %224, ptr %225, align 8
  %226 = add nuw nsw i64 %221, 1
  %227 = icmp eq i64 %226, 3
  br i1 %227, label %87, label %220

228:                                              ; preds = %213, %262
  %229 = phi i64 [ 1, %213 ], [ %272, %262 ]
  %230 = mul nuw nsw i64 %229, 12
  %231 = getelementptr inbounds double, ptr %214, i64 %230
  %232 = add nsw i64 %229, -1
  %233 = mul nuw nsw i64 %232, 3
  %234 = getelementptr inbounds double, ptr %215, i64 %233
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %11) #19
  %235 = load double, ptr %234, align 8
  %236 = getelementptr inbounds double, ptr %234, i64 1
  %237 = load double, ptr %236, align 8
  %238 = getelementptr inbounds double, ptr %234, i64 2
  %239 = load double, ptr %238, align 8
  br label %245

240:                                              ; preds = %245
  %241 = getelementptr inbounds double, ptr %231, i64 9
  %242 = getelementptr inbounds double, ptr %231, i64 10
  %243 = getelementptr inbounds double, ptr %231, i64 11
  %244 = load double, ptr %11, align 16
  br label %274

245:                                              ; preds = %228, %245
  %246 = phi i64 [ 0, %228 ], [ %260, %245 ]
  %247 = mul nuw nsw i64 %246, 3
  %248 = getelementptr inbounds double, ptr %231, i64 %247
  %249 = load double, ptr %248, align 8
  %250 = fmul double %249, %235
  %251 = getelementptr inbounds double, ptr %248, i64 1
  %252 = load double, ptr %251, align 8
  %253 = fmul double %252, %237
  %254 = fadd double %250, %253
  %255 = getelementptr inbounds double, ptr %248, i64 2
  %256 = load double, ptr %255, align 8
  %257 = fmul double %256, %239
  %258 = fadd double %254, %257
  %259 = getelementptr inbounds [3 x double], ptr %11, i64 0, i64 %246
  store double %258, ptr %259, align 8
  %260 = add nuw nsw i64 %246, 1
  %261 = icmp eq i64 %260, 3
  br i1 %261, label %240, label %245

262:                                              ; preds = %338
  %263 = getelementptr inbounds double, ptr %218, i64 %232
  %264 = load double, ptr %263, align 8
  %265 = fmul double %339, %264
  %266 = getelementptr inbounds i64, ptr %219, i64 %232
  %267 = load i64, ptr %266, align 8
  %268 = add nsw i64 %267, 13
  %269 = getelementptr inbounds double, ptr %40, i64 %268
  %270 = load double, ptr %269, align 8
  %271 = fadd double %265, %270
  store double %271, ptr %269, align 8
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %11) #19
  %272 = add nuw i64 %229, 1
  %273 = icmp eq i64 %229, %211
  br i1 %273, label %340, label %228

274:                                              ; preds = %240, %338
  %275 = phi i1 [ true, %240 ], [ false, %338 ]
  %276 = phi double [ 0.000000e+00, %240 ], [ %339, %338 ]
  %277 = select i1 %275, i64 %50, i64 %52
  %278 = mul nsw i64 %277, %217
  %279 = add nsw i64 %278, %229
  %280 = getelementptr inbounds i64, ptr %216, i64 %279
  %281 = load i64, ptr %280, align 8
  %282 = icmp eq i64 %281, 0
  br i1 %282, label %338, label %283

283:                                              ; preds = %274
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %12) #19
  %284 = select i1 %275, double %145, double %177
  %285 = load double, ptr %241, align 8
  %286 = fsub double %284, %285
  store double %286, ptr %12, align 16
  %287 = select i1 %275, double %149, double %181
  %288 = load double, ptr %242, align 8
  %289 = fsub double %287, %288
  store double %289, ptr %30, align 8
  %290 = select i1 %275, double %153, double %185
  %291 = load double, ptr %243, align 8
  %292 = fsub double %290, %291
  store double %292, ptr %31, align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %13) #19
  br label %293

293:                                              ; preds = %293, %283
  %294 = phi i64 [ 0, %283 ], [ %295, %293 ]
  %295 = add nuw nsw i64 %294, 1
  %296 = icmp ult i64 %294, 2
  %297 = add nuw nsw i64 %294, 4294967294
  %298 = select i1 %296, i64 %295, i64 %297
  %299 = and i64 %298, 4294967295
  %300 = getelementptr inbounds double, ptr %11, i64 %299
  %301 = load double, ptr %300, align 8
  %302 = icmp eq i64 %294, 0
  %303 = add nuw nsw i64 %294, 4294967295
  %304 = and i64 %303, 4294967295
  %305 = select i1 %302, i64 2, i64 %304
  %306 = getelementptr inbounds double, ptr %12, i64 %305
  %307 = load double, ptr %306, align 8
  %308 = fmul double %301, %307
  %309 = getelementptr inbounds double, ptr %11, i64 %305
  %310 = load double, ptr %309, align 8
  %311 = getelementptr inbounds double, ptr %12, i64 %299
  %312 = load double, ptr %311, align 8
  %313 = fmul double %310, %312
  %314 = fsub double %308, %313
  %315 = getelementptr inbounds double, ptr %13, i64 %294
  store double %314, ptr %315, align 8
  %316 = icmp eq i64 %295, 3
  br i1 %316, label %317, label %293

317:                                              ; preds = %293
  %318 = load ptr, ptr %32, align 8
  %319 = getelementptr inbounds i64, ptr %318, i64 %232
  %320 = load i64, ptr %319, align 8
  %321 = icmp eq i64 %320, 0
  %322 = load double, ptr %13, align 16
  %323 = select i1 %321, double %322, double %244
  %324 = fmul double %98, %323
  %325 = select i1 %321, ptr %13, ptr %11
  %326 = getelementptr inbounds double, ptr %325, i64 1
  %327 = load double, ptr %326, align 8
  %328 = fmul double %99, %327
  %329 = fadd double %324, %328
  %330 = select i1 %321, ptr %13, ptr %11
  %331 = getelementptr inbounds double, ptr %330, i64 2
  %332 = load double, ptr %331, align 16
  %333 = fmul double %100, %332
  %334 = fadd double %329, %333
  %335 = fneg double %334
  %336 = select i1 %275, double %334, double %335
  %337 = fadd double %276, %336
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %13) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %12) #19
  br label %338

338:                                              ; preds = %274, %317
  %339 = phi double [ %337, %317 ], [ %276, %274 ]
  br i1 %275, label %274, label %262

340:                                              ; preds = %262, %78, %207, %72
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %10) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #19
  %341 = add nuw nsw i64 %41, 1
  %342 = load i64, ptr %17, align 8
  %343 = getelementptr inbounds double, ptr %39, i64 %342
  %344 = add nsw i64 %342, 13
  %345 = getelementptr inbounds double, ptr %40, i64 %344
  %346 = icmp eq i64 %341, %2
  br i1 %346, label %36, label %37
}

define internal fastcc i32 @nearest_points(ptr noundef %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef %3, ptr nocapture noundef %4, ptr nocapture noundef %5, ptr noundef %6) unnamed_addr #0 {
  %8 = alloca [3 x double], align 16
  %9 = alloca [3 x double], align 16
  %10 = alloca [3 x double], align 16
  %11 = alloca [3 x double], align 16
  %12 = alloca %struct.Core, align 8
  %13 = alloca %struct.Core, align 8
  %14 = alloca [3 x double], align 16
  %15 = alloca [9 x double], align 16
  %16 = alloca [9 x double], align 16
  %17 = alloca double, align 8
  %18 = alloca double, align 8
  %19 = alloca [12 x double], align 16
  %20 = alloca double, align 8
  %21 = alloca %struct.Search, align 8
  %22 = alloca %struct.Simplex, align 8
  %23 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 12
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr inbounds i64, ptr %24, i64 %2
  %26 = load i64, ptr %25, align 8
  %27 = trunc i64 %26 to i32
  %28 = getelementptr inbounds i64, ptr %24, i64 %1
  %29 = load i64, ptr %28, align 8
  %30 = trunc i64 %29 to i32
  %31 = icmp eq i32 %27, 5
  %32 = icmp eq i32 %30, 5
  %33 = select i1 %31, i1 true, i1 %32
  %34 = icmp eq i32 %30, 3
  %35 = select i1 %33, i1 true, i1 %34
  br i1 %35, label %500, label %36

36:                                               ; preds = %7
  %37 = icmp eq i32 %30, 4
  %38 = icmp slt i32 %27, 3
  %39 = select i1 %37, i1 %38, i1 false
  br i1 %39, label %40, label %50

40:                                               ; preds = %36
  %41 = tail call fastcc i32 @nearest_points(ptr noundef nonnull %0, i64 noundef %2, i64 noundef %1, ptr noundef %4, ptr noundef %3, ptr noundef %5, ptr noundef %6)
  %42 = icmp eq i32 %41, 0
  br i1 %42, label %500, label %43

43:                                               ; preds = %40, %43
  %44 = phi i64 [ %48, %43 ], [ 0, %40 ]
  %45 = getelementptr inbounds double, ptr %6, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = fneg double %46
  store double %47, ptr %45, align 8
  %48 = add nuw nsw i64 %44, 1
  %49 = icmp ult i64 %44, 2
  br i1 %49, label %43, label %500

50:                                               ; preds = %36
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %12) #19
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %13) #19
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %1, ptr noundef nonnull %12)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %14) #19
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %15) #19
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %16) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %17) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %18) #19
  switch i32 %27, label %295 [
    i32 3, label %51
    i32 4, label %137
  ]

51:                                               ; preds = %50
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %19) #19
  %52 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 42
  %53 = load ptr, ptr %52, align 8
  %54 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %55 = load ptr, ptr %54, align 8
  %56 = getelementptr inbounds i64, ptr %55, i64 %2
  %57 = load i64, ptr %56, align 8
  %58 = mul nsw i64 %57, 12
  %59 = getelementptr inbounds double, ptr %53, i64 %58
  %60 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 16
  %61 = load ptr, ptr %60, align 8
  %62 = mul nsw i64 %2, 12
  %63 = getelementptr inbounds double, ptr %61, i64 %62
  %64 = getelementptr inbounds double, ptr %63, i64 9
  %65 = getelementptr inbounds double, ptr %63, i64 10
  %66 = getelementptr inbounds double, ptr %63, i64 11
  %67 = load double, ptr %64, align 8
  %68 = load double, ptr %65, align 8
  %69 = load double, ptr %66, align 8
  br label %70

70:                                               ; preds = %81, %51
  %71 = phi i64 [ 0, %51 ], [ %92, %81 ]
  %72 = mul nuw nsw i64 %71, 3
  %73 = getelementptr inbounds double, ptr %59, i64 %72
  %74 = add nuw nsw i64 %72, 1
  %75 = getelementptr inbounds double, ptr %59, i64 %74
  %76 = add nuw nsw i64 %72, 2
  %77 = getelementptr inbounds double, ptr %59, i64 %76
  %78 = load double, ptr %73, align 8
  %79 = load double, ptr %75, align 8
  %80 = load double, ptr %77, align 8
  br label %94

81:                                               ; preds = %94
  %82 = fmul double %78, %67
  %83 = fmul double %79, %68
  %84 = fadd double %82, %83
  %85 = fmul double %80, %69
  %86 = fadd double %84, %85
  %87 = add nuw nsw i64 %71, 9
  %88 = getelementptr inbounds double, ptr %59, i64 %87
  %89 = load double, ptr %88, align 8
  %90 = fadd double %89, %86
  %91 = getelementptr inbounds double, ptr %19, i64 %87
  store double %90, ptr %91, align 8
  %92 = add nuw nsw i64 %71, 1
  %93 = icmp eq i64 %92, 3
  br i1 %93, label %115, label %70

94:                                               ; preds = %94, %70
  %95 = phi i64 [ 0, %70 ], [ %111, %94 ]
  %96 = getelementptr inbounds double, ptr %63, i64 %95
  %97 = load double, ptr %96, align 8
  %98 = fmul double %78, %97
  %99 = add nuw nsw i64 %95, 3
  %100 = getelementptr inbounds double, ptr %63, i64 %99
  %101 = load double, ptr %100, align 8
  %102 = fmul double %79, %101
  %103 = fadd double %98, %102
  %104 = add nuw nsw i64 %95, 6
  %105 = getelementptr inbounds double, ptr %63, i64 %104
  %106 = load double, ptr %105, align 8
  %107 = fmul double %80, %106
  %108 = fadd double %103, %107
  %109 = add nuw nsw i64 %95, %72
  %110 = getelementptr inbounds double, ptr %19, i64 %109
  store double %108, ptr %110, align 8
  %111 = add nuw nsw i64 %95, 1
  %112 = icmp eq i64 %111, 3
  br i1 %112, label %81, label %94

113:                                              ; preds = %115
  %114 = call fastcc double @lowest(ptr noundef %0, i64 noundef %1, ptr noundef nonnull %12, ptr noundef nonnull %19, ptr noundef %3)
  store double %114, ptr %5, align 8
  br label %125

115:                                              ; preds = %81, %115
  %116 = phi i64 [ %122, %115 ], [ 0, %81 ]
  %117 = mul nuw nsw i64 %116, 3
  %118 = add nuw nsw i64 %117, 2
  %119 = getelementptr inbounds [12 x double], ptr %19, i64 0, i64 %118
  %120 = load double, ptr %119, align 8
  %121 = getelementptr inbounds double, ptr %6, i64 %116
  store double %120, ptr %121, align 8
  %122 = add nuw nsw i64 %116, 1
  %123 = icmp eq i64 %122, 3
  br i1 %123, label %113, label %115

124:                                              ; preds = %125
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %19) #19
  br label %498

125:                                              ; preds = %113, %125
  %126 = phi i64 [ 0, %113 ], [ %135, %125 ]
  %127 = getelementptr inbounds double, ptr %3, i64 %126
  %128 = load double, ptr %127, align 8
  %129 = load double, ptr %5, align 8
  %130 = getelementptr inbounds double, ptr %6, i64 %126
  %131 = load double, ptr %130, align 8
  %132 = fmul double %129, %131
  %133 = fsub double %128, %132
  %134 = getelementptr inbounds double, ptr %4, i64 %126
  store double %133, ptr %134, align 8
  %135 = add nuw nsw i64 %126, 1
  %136 = icmp eq i64 %135, 3
  br i1 %136, label %124, label %125

137:                                              ; preds = %50
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %20) #19
  store double 0x7FF0000000000000, ptr %20, align 8
  %138 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 42
  %139 = load ptr, ptr %138, align 8
  %140 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %141 = load ptr, ptr %140, align 8
  %142 = getelementptr inbounds i64, ptr %141, i64 %2
  %143 = load i64, ptr %142, align 8
  %144 = mul nsw i64 %143, 12
  %145 = getelementptr inbounds double, ptr %139, i64 %144
  call void @llvm.lifetime.start.p0(i64 168, ptr nonnull %21) #19
  store ptr %0, ptr %21, align 8
  %146 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 1
  store i64 %1, ptr %146, align 8
  %147 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 2
  store ptr %12, ptr %147, align 8
  %148 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 3
  %149 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 5
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %148, i8 0, i64 16, i1 false)
  store double 0x7FF0000000000000, ptr %149, align 8
  %150 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 6
  store ptr %20, ptr %150, align 8
  %151 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 7
  store ptr null, ptr %151, align 8
  %152 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 8
  store i32 0, ptr %152, align 8
  %153 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 9
  store i64 -1, ptr %153, align 8
  %154 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 10
  %155 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 12
  %156 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 18
  store double 0.000000e+00, ptr %156, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(76) %154, i8 0, i64 76, i1 false)
  call fastcc void @look_at_solid(ptr noundef nonnull %21, i64 noundef %2)
  %157 = load double, ptr %20, align 8
  %158 = fcmp ord double %157, 0.000000e+00
  %159 = load i64, ptr %153, align 8
  %160 = icmp sgt i64 %159, -1
  %161 = select i1 %158, i1 %160, i1 false
  br i1 %161, label %163, label %162

162:                                              ; preds = %137
  call void @llvm.lifetime.end.p0(i64 168, ptr nonnull %21) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %20) #19
  br label %498

163:                                              ; preds = %137
  %164 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 13
  %165 = load i32, ptr %164, align 8
  %166 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 36
  %167 = load ptr, ptr %166, align 8
  %168 = mul nsw i64 %159, 9
  %169 = getelementptr inbounds double, ptr %167, i64 %168
  br label %170

170:                                              ; preds = %200, %163
  %171 = phi i64 [ 0, %163 ], [ %204, %200 ]
  %172 = phi i32 [ 1, %163 ], [ %203, %200 ]
  %173 = mul nuw nsw i64 %171, 3
  br label %183

174:                                              ; preds = %183
  %175 = add nuw nsw i64 %171, 3
  %176 = getelementptr inbounds double, ptr %169, i64 %175
  %177 = load double, ptr %176, align 8
  %178 = getelementptr inbounds double, ptr %169, i64 %171
  %179 = load double, ptr %178, align 8
  %180 = fsub double %177, %179
  %181 = call double @llvm.fabs.f64(double %180)
  %182 = fcmp olt double %181, 3.000000e-07
  br i1 %182, label %193, label %200

183:                                              ; preds = %183, %170
  %184 = phi i64 [ 0, %170 ], [ %191, %183 ]
  %185 = mul nuw nsw i64 %184, 3
  %186 = add nuw nsw i64 %185, %171
  %187 = getelementptr inbounds double, ptr %169, i64 %186
  %188 = load double, ptr %187, align 8
  %189 = add nuw nsw i64 %184, %173
  %190 = getelementptr inbounds double, ptr %15, i64 %189
  store double %188, ptr %190, align 8
  %191 = add nuw nsw i64 %184, 1
  %192 = icmp eq i64 %191, 3
  br i1 %192, label %174, label %183

193:                                              ; preds = %174
  %194 = add nuw nsw i64 %171, 6
  %195 = getelementptr inbounds double, ptr %169, i64 %194
  %196 = load double, ptr %195, align 8
  %197 = fsub double %196, %179
  %198 = call double @llvm.fabs.f64(double %197)
  %199 = fcmp olt double %198, 3.000000e-07
  br label %200

200:                                              ; preds = %193, %174
  %201 = phi i1 [ false, %174 ], [ %199, %193 ]
  %202 = zext i1 %201 to i32
  %203 = and i32 %172, %202
  %204 = add nuw nsw i64 %171, 1
  %205 = icmp eq i64 %204, 3
  br i1 %205, label %206, label %170

206:                                              ; preds = %200
  store i64 0, ptr %13, align 8
  %207 = icmp eq i32 %203, 0
  %208 = select i1 %207, i64 3, i64 1
  %209 = getelementptr inbounds %struct.Core, ptr %13, i64 0, i32 1
  store i64 %208, ptr %209, align 8
  %210 = getelementptr inbounds %struct.Core, ptr %13, i64 0, i32 5
  %211 = getelementptr inbounds %struct.Core, ptr %13, i64 0, i32 2
  store ptr %15, ptr %211, align 8
  %212 = getelementptr inbounds double, ptr %15, i64 3
  %213 = getelementptr inbounds %struct.Core, ptr %13, i64 0, i32 3
  store ptr %212, ptr %213, align 8
  %214 = getelementptr inbounds double, ptr %15, i64 6
  %215 = getelementptr inbounds %struct.Core, ptr %13, i64 0, i32 4
  store ptr %214, ptr %215, align 8
  store ptr %145, ptr %210, align 8
  br i1 %37, label %216, label %272

216:                                              ; preds = %206
  %217 = load i64, ptr %155, align 8
  %218 = mul nsw i64 %217, 9
  %219 = getelementptr inbounds double, ptr %167, i64 %218
  br label %220

220:                                              ; preds = %250, %216
  %221 = phi i64 [ 0, %216 ], [ %254, %250 ]
  %222 = phi i32 [ 1, %216 ], [ %253, %250 ]
  %223 = mul nuw nsw i64 %221, 3
  br label %233

224:                                              ; preds = %233
  %225 = add nuw nsw i64 %221, 3
  %226 = getelementptr inbounds double, ptr %219, i64 %225
  %227 = load double, ptr %226, align 8
  %228 = getelementptr inbounds double, ptr %219, i64 %221
  %229 = load double, ptr %228, align 8
  %230 = fsub double %227, %229
  %231 = call double @llvm.fabs.f64(double %230)
  %232 = fcmp olt double %231, 3.000000e-07
  br i1 %232, label %243, label %250

233:                                              ; preds = %233, %220
  %234 = phi i64 [ 0, %220 ], [ %241, %233 ]
  %235 = mul nuw nsw i64 %234, 3
  %236 = add nuw nsw i64 %235, %221
  %237 = getelementptr inbounds double, ptr %219, i64 %236
  %238 = load double, ptr %237, align 8
  %239 = add nuw nsw i64 %234, %223
  %240 = getelementptr inbounds double, ptr %16, i64 %239
  store double %238, ptr %240, align 8
  %241 = add nuw nsw i64 %234, 1
  %242 = icmp eq i64 %241, 3
  br i1 %242, label %224, label %233

243:                                              ; preds = %224
  %244 = add nuw nsw i64 %221, 6
  %245 = getelementptr inbounds double, ptr %219, i64 %244
  %246 = load double, ptr %245, align 8
  %247 = fsub double %246, %229
  %248 = call double @llvm.fabs.f64(double %247)
  %249 = fcmp olt double %248, 3.000000e-07
  br label %250

250:                                              ; preds = %243, %224
  %251 = phi i1 [ false, %224 ], [ %249, %243 ]
  %252 = zext i1 %251 to i32
  %253 = and i32 %222, %252
  %254 = add nuw nsw i64 %221, 1
  %255 = icmp eq i64 %254, 3
  br i1 %255, label %256, label %220

256:                                              ; preds = %250
  store i64 0, ptr %12, align 8
  %257 = icmp eq i32 %253, 0
  %258 = select i1 %257, i64 3, i64 1
  %259 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 1
  store i64 %258, ptr %259, align 8
  %260 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 5
  %261 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 2
  store ptr %16, ptr %261, align 8
  %262 = getelementptr inbounds double, ptr %16, i64 3
  %263 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 3
  store ptr %262, ptr %263, align 8
  %264 = getelementptr inbounds double, ptr %16, i64 6
  %265 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 4
  store ptr %264, ptr %265, align 8
  %266 = load ptr, ptr %138, align 8
  %267 = load ptr, ptr %140, align 8
  %268 = getelementptr inbounds i64, ptr %267, i64 %1
  %269 = load i64, ptr %268, align 8
  %270 = mul nsw i64 %269, 12
  %271 = getelementptr inbounds double, ptr %266, i64 %270
  store ptr %271, ptr %260, align 8
  br label %272

272:                                              ; preds = %256, %206
  %273 = load double, ptr %154, align 8
  %274 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 10, i32 0, i64 1
  %275 = load double, ptr %274, align 8
  %276 = getelementptr inbounds %struct.Search, ptr %21, i64 0, i32 10, i32 0, i64 2
  %277 = load double, ptr %276, align 8
  br label %278

278:                                              ; preds = %272, %278
  %279 = phi i64 [ 0, %272 ], [ %293, %278 ]
  %280 = mul nuw nsw i64 %279, 3
  %281 = getelementptr inbounds double, ptr %145, i64 %280
  %282 = load double, ptr %281, align 8
  %283 = fmul double %282, %273
  %284 = getelementptr inbounds double, ptr %281, i64 1
  %285 = load double, ptr %284, align 8
  %286 = fmul double %285, %275
  %287 = fadd double %283, %286
  %288 = getelementptr inbounds double, ptr %281, i64 2
  %289 = load double, ptr %288, align 8
  %290 = fmul double %289, %277
  %291 = fadd double %287, %290
  %292 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %279
  store double %291, ptr %292, align 8
  %293 = add nuw nsw i64 %279, 1
  %294 = icmp eq i64 %293, 3
  br i1 %294, label %312, label %278

295:                                              ; preds = %50
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %2, ptr noundef nonnull %13)
  %296 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 43
  %297 = load ptr, ptr %296, align 8
  %298 = mul nsw i64 %1, 3
  %299 = mul nsw i64 %2, 3
  br label %300

300:                                              ; preds = %295, %300
  %301 = phi i64 [ 0, %295 ], [ %310, %300 ]
  %302 = add nsw i64 %298, %301
  %303 = getelementptr inbounds double, ptr %297, i64 %302
  %304 = load double, ptr %303, align 8
  %305 = add nsw i64 %299, %301
  %306 = getelementptr inbounds double, ptr %297, i64 %305
  %307 = load double, ptr %306, align 8
  %308 = fsub double %304, %307
  %309 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %301
  store double %308, ptr %309, align 8
  %310 = add nuw nsw i64 %301, 1
  %311 = icmp eq i64 %310, 3
  br i1 %311, label %315, label %300

312:                                              ; preds = %278
  call void @llvm.lifetime.end.p0(i64 168, ptr nonnull %21) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %20) #19
  call void @llvm.lifetime.start.p0(i64 224, ptr nonnull %22) #19
  %313 = call fastcc i32 @bounds_from(ptr noundef nonnull %12, ptr noundef nonnull %13, ptr noundef nonnull %14, double noundef 0x7FF0000000000000, double noundef 0xFFF0000000000000, double noundef 1.000000e-15, ptr noundef nonnull %17, ptr noundef nonnull %18, ptr noundef null, ptr noundef nonnull %22, i32 noundef 0)
  %314 = icmp eq i32 %313, 0
  br i1 %314, label %318, label %326

315:                                              ; preds = %300
  call void @llvm.lifetime.start.p0(i64 224, ptr nonnull %22) #19
  %316 = call fastcc i32 @bounds_from(ptr noundef nonnull %12, ptr noundef nonnull %13, ptr noundef nonnull %14, double noundef 0x7FF0000000000000, double noundef 0xFFF0000000000000, double noundef 1.000000e-15, ptr noundef nonnull %17, ptr noundef nonnull %18, ptr noundef null, ptr noundef nonnull %22, i32 noundef 0)
  %317 = icmp eq i32 %316, 0
  br i1 %317, label %320, label %326

318:                                              ; preds = %312
  %319 = icmp eq i32 %165, 0
  br i1 %319, label %320, label %496

320:                                              ; preds = %315, %318
  %321 = call fastcc i32 @depth_of(ptr noundef nonnull %12, ptr noundef nonnull %13, ptr noundef nonnull %22, ptr noundef %5, ptr noundef %6, ptr noundef %3, ptr noundef %4)
  %322 = icmp eq i32 %321, 0
  br i1 %322, label %496, label %323

323:                                              ; preds = %320
  %324 = load double, ptr %5, align 8
  %325 = fneg double %324
  store double %325, ptr %5, align 8
  br label %496

326:                                              ; preds = %315, %312
  %327 = phi i32 [ 0, %315 ], [ %165, %312 ]
  %328 = load double, ptr %18, align 8
  %329 = load double, ptr %17, align 8
  %330 = fsub double %328, %329
  %331 = fcmp ogt double %330, 1.000000e-08
  %332 = fcmp olt double %328, 0x3EB0C6F7A0B5ED8D
  %333 = or i1 %332, %331
  br i1 %333, label %496, label %334

334:                                              ; preds = %326
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %8, ptr noundef nonnull align 16 dereferenceable(24) @__const.nearest_of.share, i64 24, i1 false)
  %335 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 2
  %336 = load i32, ptr %335, align 8
  %337 = add i32 %336, -4
  %338 = icmp ult i32 %337, -3
  br i1 %338, label %451, label %339

339:                                              ; preds = %334
  %340 = icmp ugt i32 %336, 1
  br i1 %340, label %341, label %424

341:                                              ; preds = %339
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %10) #19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %10, i8 0, i64 24, i1 false)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %11) #19
  %342 = icmp eq i32 %336, 3
  br label %364

343:                                              ; preds = %381
  %344 = load double, ptr %9, align 16
  %345 = fmul double %344, %344
  %346 = getelementptr inbounds double, ptr %9, i64 1
  %347 = load double, ptr %346, align 8
  %348 = fmul double %347, %347
  %349 = fadd double %345, %348
  %350 = getelementptr inbounds double, ptr %9, i64 2
  %351 = load double, ptr %350, align 16
  %352 = fmul double %351, %351
  %353 = fadd double %349, %352
  %354 = load double, ptr %10, align 16
  %355 = fmul double %344, %354
  %356 = getelementptr inbounds double, ptr %10, i64 1
  %357 = load double, ptr %356, align 8
  %358 = fmul double %347, %357
  %359 = fadd double %355, %358
  %360 = getelementptr inbounds double, ptr %10, i64 2
  %361 = load double, ptr %360, align 16
  %362 = fmul double %351, %361
  %363 = fadd double %359, %362
  br i1 %342, label %384, label %390

364:                                              ; preds = %381, %341
  %365 = phi i64 [ 0, %341 ], [ %382, %381 ]
  %366 = getelementptr inbounds [4 x [3 x double]], ptr %22, i64 0, i64 1, i64 %365
  %367 = load double, ptr %366, align 8
  %368 = getelementptr inbounds [3 x double], ptr %22, i64 0, i64 %365
  %369 = load double, ptr %368, align 8
  %370 = fsub double %367, %369
  %371 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %365
  store double %370, ptr %371, align 8
  %372 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 3, i64 %365
  %373 = load double, ptr %372, align 8
  %374 = fsub double %373, %369
  %375 = getelementptr inbounds [3 x double], ptr %11, i64 0, i64 %365
  store double %374, ptr %375, align 8
  br i1 %342, label %376, label %381

376:                                              ; preds = %364
  %377 = getelementptr inbounds [4 x [3 x double]], ptr %22, i64 0, i64 2, i64 %365
  %378 = load double, ptr %377, align 8
  %379 = fsub double %378, %369
  %380 = getelementptr inbounds [3 x double], ptr %10, i64 0, i64 %365
  store double %379, ptr %380, align 8
  br label %381

381:                                              ; preds = %376, %364
  %382 = add nuw nsw i64 %365, 1
  %383 = icmp eq i64 %382, 3
  br i1 %383, label %343, label %364

384:                                              ; preds = %343
  %385 = fmul double %354, %354
  %386 = fmul double %357, %357
  %387 = fadd double %385, %386
  %388 = fmul double %361, %361
  %389 = fadd double %387, %388
  br label %390

390:                                              ; preds = %384, %343
  %391 = phi double [ %389, %384 ], [ 1.000000e+00, %343 ]
  %392 = fmul double %353, %391
  %393 = fmul double %363, %363
  %394 = fsub double %392, %393
  %395 = fcmp ogt double %394, 0.000000e+00
  br i1 %395, label %396, label %450

396:                                              ; preds = %390
  %397 = load double, ptr %11, align 16
  %398 = fmul double %344, %397
  %399 = getelementptr inbounds double, ptr %11, i64 1
  %400 = load double, ptr %399, align 8
  %401 = fmul double %347, %400
  %402 = fadd double %398, %401
  %403 = getelementptr inbounds double, ptr %11, i64 2
  %404 = load double, ptr %403, align 16
  %405 = fmul double %351, %404
  %406 = fadd double %402, %405
  %407 = fmul double %391, %406
  %408 = fmul double %354, %397
  %409 = fmul double %357, %400
  %410 = fadd double %408, %409
  %411 = fmul double %361, %404
  %412 = fadd double %410, %411
  %413 = fmul double %363, %412
  %414 = fsub double %407, %413
  %415 = fdiv double %414, %394
  %416 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 1
  store double %415, ptr %416, align 8
  %417 = fmul double %353, %412
  %418 = fmul double %363, %406
  %419 = fsub double %417, %418
  %420 = fdiv double %419, %394
  %421 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 2
  store double %420, ptr %421, align 16
  %422 = fsub double 1.000000e+00, %415
  %423 = fsub double %422, %420
  store double %423, ptr %8, align 16
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %11) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %10) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #19
  br label %424

424:                                              ; preds = %396, %339
  %425 = icmp sgt i32 %336, 0
  %426 = zext i32 %336 to i64
  br label %427

427:                                              ; preds = %431, %424
  %428 = phi i64 [ 0, %424 ], [ %437, %431 ]
  %429 = getelementptr inbounds double, ptr %3, i64 %428
  store double 0.000000e+00, ptr %429, align 8
  br i1 %425, label %439, label %431

430:                                              ; preds = %439
  store double %447, ptr %429, align 8
  br label %431

431:                                              ; preds = %430, %427
  %432 = phi double [ 0.000000e+00, %427 ], [ %447, %430 ]
  %433 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 3, i64 %428
  %434 = load double, ptr %433, align 8
  %435 = fsub double %432, %434
  %436 = getelementptr inbounds double, ptr %4, i64 %428
  store double %435, ptr %436, align 8
  %437 = add nuw nsw i64 %428, 1
  %438 = icmp eq i64 %437, 3
  br i1 %438, label %452, label %427

439:                                              ; preds = %427, %439
  %440 = phi i64 [ %448, %439 ], [ 0, %427 ]
  %441 = phi double [ %447, %439 ], [ 0.000000e+00, %427 ]
  %442 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %440
  %443 = load double, ptr %442, align 8
  %444 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 1, i64 %440, i64 %428
  %445 = load double, ptr %444, align 8
  %446 = fmul double %443, %445
  %447 = fadd double %441, %446
  %448 = add nuw nsw i64 %440, 1
  %449 = icmp eq i64 %448, %426
  br i1 %449, label %430, label %439

450:                                              ; preds = %390
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %11) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %10) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #19
  br label %451

451:                                              ; preds = %334, %450
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  br label %496

452:                                              ; preds = %431
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  %453 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 3
  %454 = load double, ptr %453, align 8
  %455 = fmul double %454, %454
  %456 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 3, i64 1
  %457 = load double, ptr %456, align 8
  %458 = fmul double %457, %457
  %459 = fadd double %455, %458
  %460 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 3, i64 2
  %461 = load double, ptr %460, align 8
  %462 = fmul double %461, %461
  %463 = fadd double %459, %462
  %464 = call double @llvm.sqrt.f64(double %463)
  store double %464, ptr %5, align 8
  br label %474

465:                                              ; preds = %474
  %466 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 15
  %467 = load ptr, ptr %466, align 8
  %468 = getelementptr inbounds double, ptr %467, i64 %1
  %469 = load double, ptr %468, align 8
  %470 = getelementptr inbounds double, ptr %467, i64 %2
  %471 = load double, ptr %470, align 8
  %472 = fadd double %469, %471
  %473 = icmp eq i32 %327, 0
  br i1 %473, label %496, label %483

474:                                              ; preds = %452, %474
  %475 = phi i64 [ 0, %452 ], [ %481, %474 ]
  %476 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 3, i64 %475
  %477 = load double, ptr %476, align 8
  %478 = load double, ptr %5, align 8
  %479 = fdiv double %477, %478
  %480 = getelementptr inbounds double, ptr %6, i64 %475
  store double %479, ptr %480, align 8
  %481 = add nuw nsw i64 %475, 1
  %482 = icmp eq i64 %481, 3
  br i1 %482, label %465, label %474

483:                                              ; preds = %465
  %484 = load double, ptr %5, align 8
  %485 = fcmp ogt double %484, %472
  br i1 %485, label %486, label %496

486:                                              ; preds = %483
  %487 = fmul double %472, 2.000000e+00
  %488 = fsub double %487, %484
  store double %488, ptr %5, align 8
  br label %489

489:                                              ; preds = %486, %489
  %490 = phi i64 [ 0, %486 ], [ %494, %489 ]
  %491 = getelementptr inbounds double, ptr %6, i64 %490
  %492 = load double, ptr %491, align 8
  %493 = fneg double %492
  store double %493, ptr %491, align 8
  %494 = add nuw nsw i64 %490, 1
  %495 = icmp eq i64 %494, 3
  br i1 %495, label %496, label %489

496:                                              ; preds = %489, %451, %465, %483, %326, %318, %320, %323
  %497 = phi i32 [ 1, %323 ], [ 0, %320 ], [ 0, %318 ], [ 0, %326 ], [ 1, %483 ], [ 1, %465 ], [ 0, %451 ], [ 1, %489 ]
  call void @llvm.lifetime.end.p0(i64 224, ptr nonnull %22) #19
  br label %498

498:                                              ; preds = %162, %496, %124
  %499 = phi i32 [ 1, %124 ], [ %497, %496 ], [ 0, %162 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %18) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %17) #19
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %16) #19
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %15) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %14) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %13) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %12) #19
  br label %500

500:                                              ; preds = %43, %40, %7, %498
  %501 = phi i32 [ %499, %498 ], [ 0, %7 ], [ 0, %40 ], [ %41, %43 ]
  ret i32 %501
}

define dso_local i64 @manipplan_tree(ptr noundef %0, ptr noundef %1, i64 noundef %2, ptr noundef %3, i64 noundef %4, ptr noundef %5, ptr noundef %6) local_unnamed_addr #8 {
  br label %8

8:                                                ; preds = %128, %7
  %9 = phi ptr [ %1, %7 ], [ %135, %128 ]
  %10 = phi i64 [ %2, %7 ], [ %136, %128 ]
  %11 = phi i64 [ %4, %7 ], [ %132, %128 ]
  %12 = mul nsw i64 %11, 6
  %13 = getelementptr inbounds double, ptr %5, i64 %12
  %14 = load i64, ptr %9, align 8
  %15 = mul nsw i64 %14, 6
  %16 = getelementptr inbounds double, ptr %0, i64 %15
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(48) %13, ptr noundef nonnull align 8 dereferenceable(48) %16, i64 48, i1 false)
  %17 = icmp sgt i64 %10, 1
  br i1 %17, label %18, label %24

18:                                               ; preds = %8, %26
  %19 = phi i64 [ %27, %26 ], [ 1, %8 ]
  %20 = getelementptr inbounds i64, ptr %9, i64 %19
  %21 = load i64, ptr %20, align 8
  %22 = mul nsw i64 %21, 6
  %23 = getelementptr inbounds double, ptr %0, i64 %22
  br label %29

24:                                               ; preds = %26, %8
  %25 = icmp eq i64 %10, 1
  br i1 %25, label %48, label %137

26:                                               ; preds = %45
  %27 = add nuw nsw i64 %19, 1
  %28 = icmp eq i64 %27, %10
  br i1 %28, label %24, label %18

29:                                               ; preds = %18, %45
  %30 = phi i64 [ 0, %18 ], [ %46, %45 ]
  %31 = getelementptr inbounds double, ptr %23, i64 %30
  %32 = load double, ptr %31, align 8
  %33 = getelementptr inbounds double, ptr %13, i64 %30
  %34 = load double, ptr %33, align 8
  %35 = fcmp olt double %32, %34
  br i1 %35, label %36, label %37

36:                                               ; preds = %29
  store double %32, ptr %33, align 8
  br label %37

37:                                               ; preds = %36, %29
  %38 = add nuw nsw i64 %30, 3
  %39 = getelementptr inbounds double, ptr %23, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = getelementptr inbounds double, ptr %13, i64 %38
  %42 = load double, ptr %41, align 8
  %43 = fcmp ogt double %40, %42
  br i1 %43, label %44, label %45

44:                                               ; preds = %37
  store double %40, ptr %41, align 8
  br label %45

45:                                               ; preds = %44, %37
  %46 = add nuw nsw i64 %30, 1
  %47 = icmp eq i64 %46, 3
  br i1 %47, label %26, label %29

48:                                               ; preds = %24
  %49 = shl nsw i64 %11, 1
  %50 = getelementptr inbounds i64, ptr %6, i64 %49
  store i64 -1, ptr %50, align 8
  %51 = load i64, ptr %9, align 8
  %52 = getelementptr inbounds i64, ptr %3, i64 %51
  %53 = load i64, ptr %52, align 8
  %54 = or i64 %49, 1
  %55 = getelementptr inbounds i64, ptr %6, i64 %54
  store i64 %53, ptr %55, align 8
  %56 = add nsw i64 %11, 1
  ret i64 %56

57:                                               ; preds = %137
  %58 = sdiv i64 %10, 2
  br i1 %17, label %59, label %128

59:                                               ; preds = %57
  %60 = add nsw i64 %10, -1
  %61 = sext i32 %156 to i64
  %62 = add nsw i32 %156, 3
  %63 = sext i32 %62 to i64
  br label %64

64:                                               ; preds = %124, %59
  %65 = phi i64 [ 0, %59 ], [ %126, %124 ]
  %66 = phi i64 [ %60, %59 ], [ %125, %124 ]
  %67 = add nsw i64 %66, %65
  %68 = sdiv i64 %67, 2
  %69 = getelementptr inbounds i64, ptr %9, i64 %68
  %70 = load i64, ptr %69, align 8
  %71 = mul nsw i64 %70, 6
  %72 = getelementptr inbounds double, ptr %0, i64 %71
  %73 = getelementptr inbounds double, ptr %72, i64 %61
  %74 = load double, ptr %73, align 8
  %75 = getelementptr inbounds double, ptr %72, i64 %63
  %76 = load double, ptr %75, align 8
  %77 = fadd double %74, %76
  %78 = icmp sgt i64 %65, %66
  br i1 %78, label %118, label %79

79:                                               ; preds = %64, %114
  %80 = phi i64 [ %116, %114 ], [ %66, %64 ]
  %81 = phi i64 [ %115, %114 ], [ %65, %64 ]
  br label %82

82:                                               ; preds = %82, %79
  %83 = phi i64 [ %94, %82 ], [ %81, %79 ]
  %84 = getelementptr inbounds i64, ptr %9, i64 %83
  %85 = load i64, ptr %84, align 8
  %86 = mul nsw i64 %85, 6
  %87 = getelementptr inbounds double, ptr %0, i64 %86
  %88 = getelementptr inbounds double, ptr %87, i64 %61
  %89 = load double, ptr %88, align 8
  %90 = getelementptr inbounds double, ptr %87, i64 %63
  %91 = load double, ptr %90, align 8
  %92 = fadd double %89, %91
  %93 = fcmp olt double %92, %77
  %94 = add nsw i64 %83, 1
  br i1 %93, label %82, label %95

95:                                               ; preds = %82
  %96 = getelementptr inbounds i64, ptr %9, i64 %83
  br label %97

97:                                               ; preds = %95, %97
  %98 = phi i64 [ %109, %97 ], [ %80, %95 ]
  %99 = getelementptr inbounds i64, ptr %9, i64 %98
  %100 = load i64, ptr %99, align 8
  %101 = mul nsw i64 %100, 6
  %102 = getelementptr inbounds double, ptr %0, i64 %101
  %103 = getelementptr inbounds double, ptr %102, i64 %61
  %104 = load double, ptr %103, align 8
  %105 = getelementptr inbounds double, ptr %102, i64 %63
  %106 = load double, ptr %105, align 8
  %107 = fadd double %104, %106
  %108 = fcmp ogt double %107, %77
  %109 = add nsw i64 %98, -1
  br i1 %108, label %97, label %110

110:                                              ; preds = %97
  %111 = icmp sgt i64 %83, %98
  br i1 %111, label %114, label %112

112:                                              ; preds = %110
  %113 = getelementptr inbounds i64, ptr %9, i64 %98
  store i64 %100, ptr %96, align 8
  store i64 %85, ptr %113, align 8
  br label %114

114:                                              ; preds = %112, %110
  %115 = phi i64 [ %94, %112 ], [ %83, %110 ]
  %116 = phi i64 [ %109, %112 ], [ %98, %110 ]
  %117 = icmp sgt i64 %115, %116
  br i1 %117, label %118, label %79

118:                                              ; preds = %114, %64
  %119 = phi i64 [ %65, %64 ], [ %115, %114 ]
  %120 = phi i64 [ %66, %64 ], [ %116, %114 ]
  %121 = icmp slt i64 %120, %58
  br i1 %121, label %122, label %124

122:                                              ; preds = %118
  %123 = icmp sgt i64 %119, %58
  br i1 %123, label %128, label %124

124:                                              ; preds = %122, %118
  %125 = phi i64 [ %120, %118 ], [ %66, %122 ]
  %126 = phi i64 [ %65, %118 ], [ %119, %122 ]
  %127 = icmp slt i64 %126, %125
  br i1 %127, label %64, label %128

128:                                              ; preds = %122, %124, %57
  %129 = add nsw i64 %11, 1
  %130 = shl nsw i64 %11, 1
  %131 = getelementptr inbounds i64, ptr %6, i64 %130
  store i64 %129, ptr %131, align 8
  %132 = tail call i64 @manipplan_tree(ptr noundef %0, ptr noundef nonnull %9, i64 noundef %58, ptr noundef %3, i64 noundef %129, ptr noundef %5, ptr noundef %6)
  %133 = or i64 %130, 1
  %134 = getelementptr inbounds i64, ptr %6, i64 %133
  store i64 %132, ptr %134, align 8
  %135 = getelementptr inbounds i64, ptr %9, i64 %58
  %136 = sub nsw i64 %10, %58
  br label %8

137:                                              ; preds = %24, %137
  %138 = phi i64 [ %157, %137 ], [ 1, %24 ]
  %139 = phi i32 [ %156, %137 ], [ 0, %24 ]
  %140 = add nuw nsw i64 %138, 3
  %141 = getelementptr inbounds double, ptr %13, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = getelementptr inbounds double, ptr %13, i64 %138
  %144 = load double, ptr %143, align 8
  %145 = fsub double %142, %144
  %146 = add nsw i32 %139, 3
  %147 = sext i32 %146 to i64
  %148 = getelementptr inbounds double, ptr %13, i64 %147
  %149 = load double, ptr %148, align 8
  %150 = sext i32 %139 to i64
  %151 = getelementptr inbounds double, ptr %13, i64 %150
  %152 = load double, ptr %151, align 8
  %153 = fsub double %149, %152
  %154 = fcmp ogt double %145, %153
  %155 = trunc i64 %138 to i32
  %156 = select i1 %154, i32 %155, i32 %139
  %157 = add nuw nsw i64 %138, 1
  %158 = icmp eq i64 %157, 3
  br i1 %158, label %57, label %137
}

declare void @llvm.memcpy.p0.p0.i64(ptr noalias nocapture writeonly, ptr noalias nocapture readonly, i64, i1 immarg) #9

define internal fastcc i32 @is_near(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, i64 noundef %3) unnamed_addr #10 {
  %5 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 33
  %6 = load ptr, ptr %5, align 8
  %7 = mul nsw i64 %3, 6
  %8 = getelementptr inbounds double, ptr %6, i64 %7
  br label %9

9:                                                ; preds = %9, %4
  %10 = phi i64 [ 0, %4 ], [ %27, %9 ]
  %11 = phi double [ 0.000000e+00, %4 ], [ %26, %9 ]
  %12 = getelementptr inbounds double, ptr %8, i64 %10
  %13 = load double, ptr %12, align 8
  %14 = getelementptr inbounds double, ptr %1, i64 %10
  %15 = load double, ptr %14, align 8
  %16 = fsub double %13, %15
  %17 = add nuw nsw i64 %10, 3
  %18 = getelementptr inbounds double, ptr %8, i64 %17
  %19 = load double, ptr %18, align 8
  %20 = fsub double %15, %19
  %21 = fcmp ogt double %16, %20
  %22 = select i1 %21, double %16, double %20
  %23 = fcmp ogt double %22, 0.000000e+00
  %24 = select i1 %23, double %22, double 0.000000e+00
  %25 = fmul double %24, %24
  %26 = fadd double %11, %25
  %27 = add nuw nsw i64 %10, 1
  %28 = icmp eq i64 %27, 3
  br i1 %28, label %29, label %9

29:                                               ; preds = %9
  %30 = fcmp ogt double %26, %2
  br i1 %30, label %41, label %31

31:                                               ; preds = %29
  %32 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 34
  %33 = load ptr, ptr %32, align 8
  %34 = shl nsw i64 %3, 1
  %35 = getelementptr inbounds i64, ptr %33, i64 %34
  %36 = load i64, ptr %35, align 8
  %37 = icmp slt i64 %36, 0
  br i1 %37, label %41, label %38

38:                                               ; preds = %31
  %39 = tail call fastcc i32 @is_near(ptr noundef nonnull %0, ptr noundef nonnull %1, double noundef %2, i64 noundef %36)
  %40 = icmp eq i32 %39, 0
  br i1 %40, label %43, label %41

41:                                               ; preds = %31, %38, %29, %43
  %42 = phi i32 [ %48, %43 ], [ 0, %29 ], [ 1, %38 ], [ 1, %31 ]
  ret i32 %42

43:                                               ; preds = %38
  %44 = getelementptr inbounds i64, ptr %35, i64 1
  %45 = load i64, ptr %44, align 8
  %46 = tail call fastcc i32 @is_near(ptr noundef nonnull %0, ptr noundef nonnull %1, double noundef %2, i64 noundef %45)
  %47 = icmp ne i32 %46, 0
  %48 = zext i1 %47 to i32
  br label %41
}

define internal fastcc void @descend(ptr noundef %0, i64 noundef %1) unnamed_addr #0 {
  %3 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %4 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %5 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %6 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  br label %7

7:                                                ; preds = %66, %2
  %8 = phi i64 [ %1, %2 ], [ %68, %66 ]
  %9 = load ptr, ptr %0, align 8
  %10 = getelementptr inbounds %struct.World, ptr %9, i64 0, i32 33
  %11 = load ptr, ptr %10, align 8
  %12 = mul nsw i64 %8, 6
  %13 = getelementptr inbounds double, ptr %11, i64 %12
  %14 = load double, ptr %3, align 8
  %15 = getelementptr inbounds %struct.World, ptr %9, i64 0, i32 18
  %16 = load ptr, ptr %15, align 8
  %17 = load i64, ptr %4, align 8
  %18 = shl nsw i64 %17, 2
  %19 = or i64 %18, 3
  %20 = getelementptr inbounds double, ptr %16, i64 %19
  %21 = load double, ptr %20, align 8
  %22 = getelementptr inbounds %struct.World, ptr %9, i64 0, i32 43
  %23 = load ptr, ptr %22, align 8
  %24 = mul nsw i64 %17, 3
  %25 = getelementptr inbounds double, ptr %23, i64 %24
  br label %26

26:                                               ; preds = %26, %7
  %27 = phi i64 [ 0, %7 ], [ %44, %26 ]
  %28 = phi double [ 0.000000e+00, %7 ], [ %43, %26 ]
  %29 = getelementptr inbounds double, ptr %13, i64 %27
  %30 = load double, ptr %29, align 8
  %31 = getelementptr inbounds double, ptr %25, i64 %27
  %32 = load double, ptr %31, align 8
  %33 = fsub double %30, %32
  %34 = add nuw nsw i64 %27, 3
  %35 = getelementptr inbounds double, ptr %13, i64 %34
  %36 = load double, ptr %35, align 8
  %37 = fsub double %32, %36
  %38 = fcmp ogt double %33, %37
  %39 = select i1 %38, double %33, double %37
  %40 = fcmp ogt double %39, 0.000000e+00
  %41 = select i1 %40, double %39, double 0.000000e+00
  %42 = fmul double %41, %41
  %43 = fadd double %28, %42
  %44 = add nuw nsw i64 %27, 1
  %45 = icmp eq i64 %44, 3
  br i1 %45, label %46, label %26

46:                                               ; preds = %26
  %47 = fadd double %14, %21
  %48 = fmul double %47, %47
  %49 = fcmp ogt double %43, %48
  br i1 %49, label %69, label %50

50:                                               ; preds = %46
  %51 = load ptr, ptr %5, align 8
  %52 = icmp eq ptr %51, null
  br i1 %52, label %53, label %56

53:                                               ; preds = %50
  %54 = load i32, ptr %6, align 8
  %55 = icmp eq i32 %54, 1
  br i1 %55, label %69, label %56

56:                                               ; preds = %53, %50
  %57 = getelementptr inbounds %struct.World, ptr %9, i64 0, i32 34
  %58 = load ptr, ptr %57, align 8
  %59 = shl nsw i64 %8, 1
  %60 = getelementptr inbounds i64, ptr %58, i64 %59
  %61 = load i64, ptr %60, align 8
  %62 = icmp slt i64 %61, 0
  br i1 %62, label %63, label %66

63:                                               ; preds = %56
  %64 = getelementptr inbounds i64, ptr %60, i64 1
  %65 = load i64, ptr %64, align 8
  tail call fastcc void @look_at(ptr noundef nonnull %0, i64 noundef %65, ptr noundef nonnull %13)
  br label %69

66:                                               ; preds = %56
  tail call fastcc void @descend(ptr noundef nonnull %0, i64 noundef %61)
  %67 = getelementptr inbounds i64, ptr %60, i64 1
  %68 = load i64, ptr %67, align 8
  br label %7

69:                                               ; preds = %46, %53, %63
  ret void
}

define internal fastcc void @look_at(ptr noundef %0, i64 noundef %1, ptr noundef readonly %2) unnamed_addr #0 {
  %4 = alloca double, align 8
  %5 = alloca double, align 8
  %6 = alloca %struct.Core, align 8
  %7 = alloca %struct.Search, align 8
  %8 = alloca [3 x double], align 16
  %9 = alloca %struct.Core, align 8
  %10 = alloca %struct.Simplex, align 8
  %11 = alloca double, align 8
  %12 = load ptr, ptr %0, align 8
  %13 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %14 = load ptr, ptr %13, align 8
  %15 = icmp eq ptr %14, null
  %16 = getelementptr inbounds i64, ptr %14, i64 %1
  %17 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %18 = select i1 %15, ptr %17, ptr %16
  %19 = load i64, ptr %18, align 8
  %20 = icmp slt i64 %19, 0
  br i1 %20, label %368, label %21

21:                                               ; preds = %3
  %22 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %23 = load ptr, ptr %22, align 8
  %24 = icmp eq ptr %23, null
  br i1 %24, label %29, label %25

25:                                               ; preds = %21
  %26 = getelementptr inbounds double, ptr %23, i64 %19
  %27 = load double, ptr %26, align 8
  %28 = fcmp uno double %27, 0.000000e+00
  br i1 %28, label %368, label %33

29:                                               ; preds = %21
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %31 = load i32, ptr %30, align 8
  %32 = icmp eq i32 %31, 1
  br i1 %32, label %368, label %33

33:                                               ; preds = %25, %29
  %34 = getelementptr inbounds %struct.World, ptr %12, i64 0, i32 12
  %35 = load ptr, ptr %34, align 8
  %36 = getelementptr inbounds i64, ptr %35, i64 %1
  %37 = load i64, ptr %36, align 8
  %38 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %39 = load i64, ptr %38, align 8
  %40 = getelementptr inbounds i64, ptr %35, i64 %39
  %41 = load i64, ptr %40, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %4) #19
  store double 0xFFF0000000000000, ptr %4, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %5) #19
  store double 0x7FF0000000000000, ptr %5, align 8
  %42 = icmp eq i64 %37, 5
  %43 = icmp eq i64 %41, 5
  %44 = select i1 %42, i1 true, i1 %43
  %45 = icmp eq i64 %41, 3
  %46 = select i1 %44, i1 true, i1 %45
  br i1 %46, label %47, label %81

47:                                               ; preds = %33
  br i1 %24, label %68, label %48

48:                                               ; preds = %47
  %49 = getelementptr inbounds double, ptr %23, i64 %19
  %50 = load double, ptr %49, align 8
  %51 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %52 = load double, ptr %51, align 8
  %53 = tail call double @llvm.minnum.f64(double %50, double %52)
  %54 = fcmp ugt double %53, 0xFFF0000000000000
  br i1 %54, label %55, label %367

55:                                               ; preds = %48
  %56 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %57 = load ptr, ptr %56, align 8
  %58 = icmp ne ptr %57, null
  %59 = fcmp oeq double %50, 0x7FF0000000000000
  %60 = select i1 %58, i1 %59, i1 false
  br i1 %60, label %61, label %67

61:                                               ; preds = %55
  %62 = getelementptr inbounds %struct.World, ptr %12, i64 0, i32 45
  %63 = load ptr, ptr %62, align 8
  %64 = load i64, ptr %57, align 8
  %65 = add nsw i64 %64, 1
  store i64 %65, ptr %57, align 8
  %66 = getelementptr inbounds i64, ptr %63, i64 %64
  store i64 %19, ptr %66, align 8
  br label %67

67:                                               ; preds = %61, %55
  store double 0x7FF8000000000000, ptr %49, align 8
  br label %367

68:                                               ; preds = %47
  %69 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %70 = load double, ptr %69, align 8
  %71 = fcmp ult double %70, 0x7FF0000000000000
  br i1 %71, label %74, label %72

72:                                               ; preds = %68
  %73 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  store i32 1, ptr %73, align 8
  br label %367

74:                                               ; preds = %68
  %75 = fcmp ult double %70, 0xFFF0000000000000
  br i1 %75, label %367, label %76

76:                                               ; preds = %74
  %77 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %78 = load i32, ptr %77, align 8
  %79 = icmp eq i32 %78, 0
  br i1 %79, label %80, label %367

80:                                               ; preds = %76
  store i32 2, ptr %77, align 8
  br label %367

81:                                               ; preds = %33
  %82 = icmp eq i64 %37, 3
  br i1 %82, label %83, label %128

83:                                               ; preds = %81
  %84 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %85 = load ptr, ptr %84, align 8
  %86 = tail call fastcc double @over_plane(ptr noundef nonnull %12, i64 noundef %39, ptr noundef %85, i64 noundef %1)
  %87 = load ptr, ptr %22, align 8
  %88 = icmp eq ptr %87, null
  br i1 %88, label %89, label %93

89:                                               ; preds = %83
  %90 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %91 = load double, ptr %90, align 8
  %92 = fcmp ugt double %86, %91
  br i1 %92, label %367, label %126

93:                                               ; preds = %83
  %94 = load ptr, ptr %13, align 8
  %95 = icmp eq ptr %94, null
  %96 = getelementptr inbounds i64, ptr %94, i64 %1
  %97 = select i1 %95, ptr %17, ptr %96
  %98 = load i64, ptr %97, align 8
  %99 = getelementptr inbounds double, ptr %87, i64 %98
  %100 = load double, ptr %99, align 8
  %101 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %102 = load double, ptr %101, align 8
  %103 = fcmp ogt double %100, %102
  %104 = select i1 %103, double %102, double %100
  %105 = fcmp ugt double %86, %104
  br i1 %105, label %367, label %106

106:                                              ; preds = %93
  %107 = fsub double %86, %86
  %108 = fcmp ole double %107, 1.000000e-08
  %109 = tail call double @llvm.minnum.f64(double %100, double %102)
  %110 = fcmp ult double %86, %109
  br i1 %110, label %111, label %367

111:                                              ; preds = %106
  %112 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %113 = load ptr, ptr %112, align 8
  %114 = icmp ne ptr %113, null
  %115 = fcmp oeq double %100, 0x7FF0000000000000
  %116 = select i1 %114, i1 %115, i1 false
  br i1 %116, label %117, label %124

117:                                              ; preds = %111
  %118 = load ptr, ptr %0, align 8
  %119 = getelementptr inbounds %struct.World, ptr %118, i64 0, i32 45
  %120 = load ptr, ptr %119, align 8
  %121 = load i64, ptr %113, align 8
  %122 = add nsw i64 %121, 1
  store i64 %122, ptr %113, align 8
  %123 = getelementptr inbounds i64, ptr %120, i64 %121
  store i64 %98, ptr %123, align 8
  br label %124

124:                                              ; preds = %117, %111
  %125 = select i1 %108, double %86, double 0x7FF8000000000000
  store double %125, ptr %99, align 8
  br label %367

126:                                              ; preds = %89
  %127 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  store i32 1, ptr %127, align 8
  br label %367

128:                                              ; preds = %81
  %129 = icmp eq i64 %41, 4
  br i1 %129, label %130, label %161

130:                                              ; preds = %128
  br i1 %24, label %131, label %134

131:                                              ; preds = %130
  %132 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %133 = load double, ptr %132, align 8
  br label %141

134:                                              ; preds = %130
  %135 = getelementptr inbounds double, ptr %23, i64 %19
  %136 = load double, ptr %135, align 8
  %137 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %138 = load double, ptr %137, align 8
  %139 = fcmp ogt double %136, %138
  %140 = select i1 %139, double %138, double %136
  br label %141

141:                                              ; preds = %131, %134
  %142 = phi double [ %140, %134 ], [ %133, %131 ]
  %143 = tail call fastcc i32 @are_far(ptr noundef nonnull %12, i64 noundef %39, i64 noundef %1, double noundef %142)
  %144 = icmp eq i32 %143, 0
  br i1 %144, label %145, label %367

145:                                              ; preds = %141
  %146 = icmp eq i64 %37, 4
  br i1 %146, label %147, label %148

147:                                              ; preds = %145
  tail call fastcc void @look_at_solid(ptr noundef nonnull %0, i64 noundef %1)
  br label %367

148:                                              ; preds = %145
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %6) #19
  call void @llvm.lifetime.start.p0(i64 168, ptr nonnull %7) #19
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(168) %7, ptr noundef nonnull align 8 dereferenceable(168) %0, i64 168, i1 false)
  call fastcc void @core_of(ptr noundef nonnull %12, i64 noundef %1, ptr noundef nonnull %6)
  %149 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 1
  store i64 %1, ptr %149, align 8
  %150 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 2
  store ptr %6, ptr %150, align 8
  %151 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 3
  store ptr null, ptr %151, align 8
  %152 = load i64, ptr %18, align 8
  %153 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 4
  store i64 %152, ptr %153, align 8
  call fastcc void @look_at_solid(ptr noundef nonnull %7, i64 noundef %39)
  %154 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 8
  %155 = load i32, ptr %154, align 8
  %156 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  store i32 %155, ptr %156, align 8
  %157 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 9
  %158 = load i64, ptr %157, align 8
  %159 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 12
  store i64 %158, ptr %159, align 8
  %160 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  store i64 -1, ptr %160, align 8
  call void @llvm.lifetime.end.p0(i64 168, ptr nonnull %7) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %6) #19
  br label %367

161:                                              ; preds = %128
  %162 = icmp eq i64 %37, 4
  br i1 %162, label %163, label %185

163:                                              ; preds = %161
  %164 = getelementptr inbounds %struct.World, ptr %12, i64 0, i32 11
  %165 = load ptr, ptr %164, align 8
  %166 = getelementptr inbounds i64, ptr %165, i64 %1
  %167 = load i64, ptr %166, align 8
  %168 = icmp sgt i64 %167, 0
  br i1 %168, label %169, label %184

169:                                              ; preds = %163
  br i1 %24, label %170, label %173

170:                                              ; preds = %169
  %171 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %172 = load double, ptr %171, align 8
  br label %180

173:                                              ; preds = %169
  %174 = getelementptr inbounds double, ptr %23, i64 %19
  %175 = load double, ptr %174, align 8
  %176 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %177 = load double, ptr %176, align 8
  %178 = fcmp ogt double %175, %177
  %179 = select i1 %178, double %177, double %175
  br label %180

180:                                              ; preds = %170, %173
  %181 = phi double [ %179, %173 ], [ %172, %170 ]
  %182 = tail call fastcc i32 @are_far(ptr noundef nonnull %12, i64 noundef %39, i64 noundef %1, double noundef %181)
  %183 = icmp eq i32 %182, 0
  br i1 %183, label %184, label %367

184:                                              ; preds = %180, %163
  tail call fastcc void @look_at_solid(ptr noundef nonnull %0, i64 noundef %1)
  br label %367

185:                                              ; preds = %161
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  br i1 %24, label %186, label %189

186:                                              ; preds = %185
  %187 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %188 = load double, ptr %187, align 8
  br label %196

189:                                              ; preds = %185
  %190 = getelementptr inbounds double, ptr %23, i64 %19
  %191 = load double, ptr %190, align 8
  %192 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %193 = load double, ptr %192, align 8
  %194 = fcmp ogt double %191, %193
  %195 = select i1 %194, double %193, double %191
  br label %196

196:                                              ; preds = %186, %189
  %197 = phi double [ %188, %186 ], [ 0xFFF0000000000000, %189 ]
  %198 = phi double [ %188, %186 ], [ %195, %189 ]
  %199 = getelementptr inbounds %struct.World, ptr %12, i64 0, i32 43
  %200 = load ptr, ptr %199, align 8
  %201 = mul nsw i64 %39, 3
  %202 = getelementptr inbounds double, ptr %200, i64 %201
  %203 = mul nsw i64 %1, 3
  %204 = getelementptr inbounds double, ptr %200, i64 %203
  br label %208

205:                                              ; preds = %208
  %206 = tail call fastcc i32 @are_far(ptr noundef %12, i64 noundef %39, i64 noundef %1, double noundef %198)
  %207 = icmp eq i32 %206, 0
  br i1 %207, label %218, label %366

208:                                              ; preds = %196, %208
  %209 = phi i64 [ 0, %196 ], [ %216, %208 ]
  %210 = getelementptr inbounds double, ptr %202, i64 %209
  %211 = load double, ptr %210, align 8
  %212 = getelementptr inbounds double, ptr %204, i64 %209
  %213 = load double, ptr %212, align 8
  %214 = fsub double %211, %213
  %215 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %209
  store double %214, ptr %215, align 8
  %216 = add nuw nsw i64 %209, 1
  %217 = icmp eq i64 %216, 3
  br i1 %217, label %205, label %208

218:                                              ; preds = %205
  %219 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  %220 = load ptr, ptr %219, align 8
  %221 = icmp eq ptr %220, null
  br i1 %221, label %237, label %222

222:                                              ; preds = %218
  %223 = mul nsw i64 %19, 22
  %224 = getelementptr inbounds double, ptr %220, i64 %223
  %225 = load double, ptr %224, align 8
  %226 = fmul double %225, %225
  %227 = getelementptr inbounds double, ptr %224, i64 1
  %228 = load double, ptr %227, align 8
  %229 = fmul double %228, %228
  %230 = fadd double %226, %229
  %231 = getelementptr inbounds double, ptr %224, i64 2
  %232 = load double, ptr %231, align 8
  %233 = fmul double %232, %232
  %234 = fadd double %230, %233
  %235 = fcmp ogt double %234, 0.000000e+00
  br i1 %235, label %236, label %237

236:                                              ; preds = %222
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %8, ptr noundef nonnull align 8 dereferenceable(24) %224, i64 24, i1 false)
  br label %283

237:                                              ; preds = %218, %222
  %238 = phi ptr [ %224, %222 ], [ null, %218 ]
  %239 = icmp eq ptr %2, null
  br i1 %239, label %283, label %240

240:                                              ; preds = %237, %240
  %241 = phi i64 [ %258, %240 ], [ 0, %237 ]
  %242 = phi double [ %257, %240 ], [ 0.000000e+00, %237 ]
  %243 = getelementptr inbounds double, ptr %2, i64 %241
  %244 = load double, ptr %243, align 8
  %245 = getelementptr inbounds double, ptr %202, i64 %241
  %246 = load double, ptr %245, align 8
  %247 = fsub double %244, %246
  %248 = add nuw nsw i64 %241, 3
  %249 = getelementptr inbounds double, ptr %2, i64 %248
  %250 = load double, ptr %249, align 8
  %251 = fsub double %246, %250
  %252 = fcmp ogt double %247, %251
  %253 = select i1 %252, double %247, double %251
  %254 = fcmp ogt double %253, 0.000000e+00
  %255 = select i1 %254, double %253, double 0.000000e+00
  %256 = fmul double %255, %255
  %257 = fadd double %242, %256
  %258 = add nuw nsw i64 %241, 1
  %259 = icmp eq i64 %258, 3
  br i1 %259, label %260, label %240

260:                                              ; preds = %240
  %261 = fcmp ogt double %257, 0.000000e+00
  br i1 %261, label %262, label %283

262:                                              ; preds = %260, %278
  %263 = phi i64 [ %281, %278 ], [ 0, %260 ]
  %264 = getelementptr inbounds double, ptr %202, i64 %263
  %265 = load double, ptr %264, align 8
  %266 = getelementptr inbounds double, ptr %2, i64 %263
  %267 = load double, ptr %266, align 8
  %268 = fcmp olt double %265, %267
  br i1 %268, label %269, label %271

269:                                              ; preds = %262
  %270 = fsub double %265, %267
  br label %278

271:                                              ; preds = %262
  %272 = add nuw nsw i64 %263, 3
  %273 = getelementptr inbounds double, ptr %2, i64 %272
  %274 = load double, ptr %273, align 8
  %275 = fcmp ogt double %265, %274
  br i1 %275, label %276, label %278

276:                                              ; preds = %271
  %277 = fsub double %265, %274
  br label %278

278:                                              ; preds = %276, %271, %269
  %279 = phi double [ %270, %269 ], [ %277, %276 ], [ 0.000000e+00, %271 ]
  %280 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %263
  store double %279, ptr %280, align 8
  %281 = add nuw nsw i64 %263, 1
  %282 = icmp eq i64 %281, 3
  br i1 %282, label %283, label %262

283:                                              ; preds = %278, %237, %260, %236
  %284 = phi ptr [ %238, %237 ], [ %238, %260 ], [ %224, %236 ], [ %238, %278 ]
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %9) #19
  call fastcc void @core_of(ptr noundef %12, i64 noundef %1, ptr noundef nonnull %9)
  call void @llvm.lifetime.start.p0(i64 224, ptr nonnull %10) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %11) #19
  %285 = getelementptr inbounds %struct.World, ptr %12, i64 0, i32 15
  %286 = load ptr, ptr %285, align 8
  %287 = getelementptr inbounds double, ptr %286, i64 %39
  %288 = load double, ptr %287, align 8
  %289 = getelementptr inbounds double, ptr %286, i64 %1
  %290 = load double, ptr %289, align 8
  %291 = fadd double %288, %290
  br i1 %221, label %324, label %292

292:                                              ; preds = %283
  %293 = load double, ptr %284, align 8
  %294 = fmul double %293, %293
  %295 = getelementptr inbounds double, ptr %284, i64 1
  %296 = load double, ptr %295, align 8
  %297 = fmul double %296, %296
  %298 = fadd double %294, %297
  %299 = getelementptr inbounds double, ptr %284, i64 2
  %300 = load double, ptr %299, align 8
  %301 = fmul double %300, %300
  %302 = fadd double %298, %301
  %303 = fcmp ogt double %302, 0.000000e+00
  %304 = icmp ne ptr %23, null
  %305 = select i1 %303, i1 %304, i1 false
  br i1 %305, label %306, label %319

306:                                              ; preds = %292
  %307 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %308 = load ptr, ptr %307, align 8
  %309 = fadd double %198, %291
  %310 = call fastcc i32 @bounds_near(ptr noundef nonnull %284, ptr noundef %308, ptr noundef nonnull %9, ptr noundef nonnull %8, double noundef %309, ptr noundef nonnull %4, ptr noundef nonnull %5, ptr noundef nonnull %10)
  %311 = icmp eq i32 %310, 0
  br i1 %311, label %312, label %314

312:                                              ; preds = %306
  %313 = load i64, ptr %38, align 8
  br label %319

314:                                              ; preds = %306
  %315 = load double, ptr %4, align 8
  %316 = fsub double %315, %291
  store double %316, ptr %4, align 8
  %317 = load double, ptr %5, align 8
  %318 = fsub double %317, %291
  store double %318, ptr %5, align 8
  br label %328

319:                                              ; preds = %312, %292
  %320 = phi i64 [ %313, %312 ], [ %39, %292 ]
  %321 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %322 = load ptr, ptr %321, align 8
  %323 = call fastcc i32 @shape_bounds(ptr noundef nonnull %12, i64 noundef %320, ptr noundef %322, i64 noundef %1, ptr noundef nonnull %9, ptr noundef nonnull %8, double noundef %198, double noundef %197, ptr noundef nonnull %4, ptr noundef nonnull %5, ptr noundef null, ptr noundef nonnull %10)
  br label %328

324:                                              ; preds = %283
  %325 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %326 = load ptr, ptr %325, align 8
  %327 = call fastcc i32 @shape_bounds(ptr noundef nonnull %12, i64 noundef %39, ptr noundef %326, i64 noundef %1, ptr noundef nonnull %9, ptr noundef nonnull %8, double noundef %198, double noundef %197, ptr noundef nonnull %4, ptr noundef nonnull %5, ptr noundef null, ptr noundef nonnull %10)
  br label %332

328:                                              ; preds = %319, %314
  %329 = phi i32 [ 1, %314 ], [ %323, %319 ]
  %330 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %331 = load ptr, ptr %330, align 8
  call fastcc void @keep_guess(ptr noundef nonnull %284, ptr noundef %331, ptr noundef nonnull %9, ptr noundef nonnull %8, ptr noundef nonnull %10, i32 noundef %329)
  br label %332

332:                                              ; preds = %324, %328
  %333 = phi i32 [ %329, %328 ], [ %327, %324 ]
  %334 = icmp eq i32 %333, 0
  br i1 %334, label %337, label %335

335:                                              ; preds = %332
  %336 = load double, ptr %4, align 8
  br label %358

337:                                              ; preds = %332
  %338 = load ptr, ptr %22, align 8
  %339 = icmp eq ptr %338, null
  br i1 %339, label %356, label %340

340:                                              ; preds = %337
  %341 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %342 = load ptr, ptr %341, align 8
  %343 = call fastcc i32 @depth_of(ptr noundef %342, ptr noundef nonnull %9, ptr noundef nonnull %10, ptr noundef nonnull %11, ptr noundef null, ptr noundef null, ptr noundef null)
  %344 = icmp eq i32 %343, 0
  br i1 %344, label %356, label %345

345:                                              ; preds = %340
  %346 = load double, ptr %11, align 8
  %347 = fneg double %346
  %348 = load ptr, ptr %285, align 8
  %349 = load i64, ptr %38, align 8
  %350 = getelementptr inbounds double, ptr %348, i64 %349
  %351 = load double, ptr %350, align 8
  %352 = fsub double %347, %351
  %353 = getelementptr inbounds double, ptr %348, i64 %1
  %354 = load double, ptr %353, align 8
  %355 = fsub double %352, %354
  store double %355, ptr %5, align 8
  br label %358

356:                                              ; preds = %340, %337
  %357 = load double, ptr %4, align 8
  br label %361

358:                                              ; preds = %335, %345
  %359 = phi double [ %336, %335 ], [ %355, %345 ]
  %360 = fcmp ugt double %359, %198
  br i1 %360, label %365, label %361

361:                                              ; preds = %356, %358
  %362 = phi double [ %357, %356 ], [ %359, %358 ]
  %363 = phi i32 [ 0, %356 ], [ 1, %358 ]
  %364 = load double, ptr %5, align 8
  call fastcc void @tell(ptr noundef nonnull %0, i64 noundef %1, i32 noundef %363, double noundef %362, double noundef %364)
  br label %365

365:                                              ; preds = %358, %361
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %11) #19
  call void @llvm.lifetime.end.p0(i64 224, ptr nonnull %10) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %9) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  br label %367

366:                                              ; preds = %205
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  br label %367

367:                                              ; preds = %126, %124, %106, %93, %80, %76, %74, %72, %67, %48, %365, %148, %147, %184, %89, %366, %180, %141
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %5) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %4) #19
  br label %368

368:                                              ; preds = %25, %3, %29, %367
  ret void
}

define internal fastcc void @tell(ptr nocapture noundef %0, i64 noundef %1, i32 noundef %2, double noundef %3, double noundef %4) unnamed_addr #11 {
  %6 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %7 = load ptr, ptr %6, align 8
  %8 = icmp eq ptr %7, null
  br i1 %8, label %45, label %9

9:                                                ; preds = %5
  %10 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %11 = load ptr, ptr %10, align 8
  %12 = icmp eq ptr %11, null
  %13 = getelementptr inbounds i64, ptr %11, i64 %1
  %14 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %15 = select i1 %12, ptr %14, ptr %13
  %16 = load i64, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %7, i64 %16
  %18 = icmp ne i32 %2, 0
  %19 = fsub double %4, %3
  %20 = fcmp ole double %19, 1.000000e-08
  %21 = and i1 %18, %20
  br i1 %18, label %22, label %29

22:                                               ; preds = %9
  %23 = select i1 %21, double %4, double %3
  %24 = load double, ptr %17, align 8
  %25 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %26 = load double, ptr %25, align 8
  %27 = tail call double @llvm.minnum.f64(double %24, double %26)
  %28 = fcmp ult double %23, %27
  br i1 %28, label %29, label %60

29:                                               ; preds = %22, %9
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %31 = load ptr, ptr %30, align 8
  %32 = icmp eq ptr %31, null
  br i1 %32, label %43, label %33

33:                                               ; preds = %29
  %34 = load double, ptr %17, align 8
  %35 = fcmp oeq double %34, 0x7FF0000000000000
  br i1 %35, label %36, label %43

36:                                               ; preds = %33
  %37 = load ptr, ptr %0, align 8
  %38 = getelementptr inbounds %struct.World, ptr %37, i64 0, i32 45
  %39 = load ptr, ptr %38, align 8
  %40 = load i64, ptr %31, align 8
  %41 = add nsw i64 %40, 1
  store i64 %41, ptr %31, align 8
  %42 = getelementptr inbounds i64, ptr %39, i64 %40
  store i64 %16, ptr %42, align 8
  br label %43

43:                                               ; preds = %29, %33, %36
  %44 = select i1 %21, double %4, double 0x7FF8000000000000
  store double %44, ptr %17, align 8
  br label %60

45:                                               ; preds = %5
  %46 = icmp eq i32 %2, 0
  br i1 %46, label %51, label %47

47:                                               ; preds = %45
  %48 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %49 = load double, ptr %48, align 8
  %50 = fcmp ult double %49, %4
  br i1 %50, label %53, label %51

51:                                               ; preds = %47, %45
  %52 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  store i32 1, ptr %52, align 8
  br label %60

53:                                               ; preds = %47
  %54 = fcmp ult double %49, %3
  br i1 %54, label %60, label %55

55:                                               ; preds = %53
  %56 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %57 = load i32, ptr %56, align 8
  %58 = icmp eq i32 %57, 0
  br i1 %58, label %59, label %60

59:                                               ; preds = %55
  store i32 2, ptr %56, align 8
  br label %60

60:                                               ; preds = %53, %55, %59, %51, %43, %22
  ret void
}

define internal fastcc i32 @are_far(ptr nocapture noundef readonly %0, i64 noundef %1, i64 noundef %2, double noundef %3) unnamed_addr #10 {
  %5 = alloca [3 x double], align 16
  %6 = alloca [3 x double], align 16
  %7 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 43
  %8 = load ptr, ptr %7, align 8
  %9 = mul nsw i64 %1, 3
  %10 = getelementptr inbounds double, ptr %8, i64 %9
  %11 = mul nsw i64 %2, 3
  %12 = getelementptr inbounds double, ptr %8, i64 %11
  %13 = load double, ptr %10, align 8
  %14 = load double, ptr %12, align 8
  %15 = fsub double %13, %14
  %16 = getelementptr inbounds double, ptr %10, i64 1
  %17 = load double, ptr %16, align 8
  %18 = getelementptr inbounds double, ptr %12, i64 1
  %19 = load double, ptr %18, align 8
  %20 = fsub double %17, %19
  %21 = getelementptr inbounds double, ptr %10, i64 2
  %22 = load double, ptr %21, align 8
  %23 = getelementptr inbounds double, ptr %12, i64 2
  %24 = load double, ptr %23, align 8
  %25 = fsub double %22, %24
  %26 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 18
  %27 = load ptr, ptr %26, align 8
  %28 = shl nsw i64 %1, 2
  %29 = or i64 %28, 3
  %30 = getelementptr inbounds double, ptr %27, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = fadd double %31, %3
  %33 = shl nsw i64 %2, 2
  %34 = or i64 %33, 3
  %35 = getelementptr inbounds double, ptr %27, i64 %34
  %36 = load double, ptr %35, align 8
  %37 = fadd double %32, %36
  %38 = fmul double %15, %15
  %39 = fmul double %20, %20
  %40 = fadd double %38, %39
  %41 = fmul double %25, %25
  %42 = fadd double %40, %41
  %43 = fmul double %37, %37
  %44 = fcmp ogt double %42, %43
  br i1 %44, label %169, label %45

45:                                               ; preds = %4
  %46 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 42
  %47 = load ptr, ptr %46, align 8
  %48 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %49 = load ptr, ptr %48, align 8
  %50 = getelementptr inbounds i64, ptr %49, i64 %1
  %51 = load i64, ptr %50, align 8
  %52 = mul nsw i64 %51, 12
  %53 = getelementptr inbounds double, ptr %47, i64 %52
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #19
  %54 = getelementptr inbounds double, ptr %53, i64 9
  %55 = load double, ptr %54, align 8
  %56 = fsub double %14, %55
  %57 = getelementptr inbounds double, ptr %53, i64 10
  %58 = load double, ptr %57, align 8
  %59 = fsub double %19, %58
  %60 = getelementptr inbounds double, ptr %53, i64 11
  %61 = load double, ptr %60, align 8
  %62 = fsub double %24, %61
  br label %63

63:                                               ; preds = %63, %45
  %64 = phi i64 [ 0, %45 ], [ %79, %63 ]
  %65 = getelementptr inbounds double, ptr %53, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = fmul double %56, %66
  %68 = add nuw nsw i64 %64, 3
  %69 = getelementptr inbounds double, ptr %53, i64 %68
  %70 = load double, ptr %69, align 8
  %71 = fmul double %59, %70
  %72 = fadd double %67, %71
  %73 = add nuw nsw i64 %64, 6
  %74 = getelementptr inbounds double, ptr %53, i64 %73
  %75 = load double, ptr %74, align 8
  %76 = fmul double %62, %75
  %77 = fadd double %72, %76
  %78 = getelementptr inbounds double, ptr %6, i64 %64
  store double %77, ptr %78, align 8
  %79 = add nuw nsw i64 %64, 1
  %80 = icmp eq i64 %79, 3
  br i1 %80, label %81, label %63

81:                                               ; preds = %63
  %82 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 19
  %83 = load ptr, ptr %82, align 8
  %84 = mul nsw i64 %1, 6
  %85 = getelementptr inbounds double, ptr %83, i64 %84
  br label %86

86:                                               ; preds = %86, %81
  %87 = phi i64 [ 0, %81 ], [ %104, %86 ]
  %88 = phi double [ 0.000000e+00, %81 ], [ %103, %86 ]
  %89 = getelementptr inbounds double, ptr %85, i64 %87
  %90 = load double, ptr %89, align 8
  %91 = getelementptr inbounds double, ptr %6, i64 %87
  %92 = load double, ptr %91, align 8
  %93 = fsub double %90, %92
  %94 = add nuw nsw i64 %87, 3
  %95 = getelementptr inbounds double, ptr %85, i64 %94
  %96 = load double, ptr %95, align 8
  %97 = fsub double %92, %96
  %98 = fcmp ogt double %93, %97
  %99 = select i1 %98, double %93, double %97
  %100 = fcmp ogt double %99, 0.000000e+00
  %101 = select i1 %100, double %99, double 0.000000e+00
  %102 = fmul double %101, %101
  %103 = fadd double %88, %102
  %104 = add nuw nsw i64 %87, 1
  %105 = icmp eq i64 %104, 3
  br i1 %105, label %106, label %86

106:                                              ; preds = %86
  %107 = fadd double %36, %3
  %108 = fmul double %107, %107
  %109 = fcmp ule double %103, %108
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #19
  br i1 %109, label %110, label %169

110:                                              ; preds = %106
  %111 = getelementptr inbounds i64, ptr %49, i64 %2
  %112 = load i64, ptr %111, align 8
  %113 = mul nsw i64 %112, 12
  %114 = getelementptr inbounds double, ptr %47, i64 %113
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %5) #19
  %115 = getelementptr inbounds double, ptr %114, i64 9
  %116 = load double, ptr %115, align 8
  %117 = fsub double %13, %116
  %118 = getelementptr inbounds double, ptr %114, i64 10
  %119 = load double, ptr %118, align 8
  %120 = fsub double %17, %119
  %121 = getelementptr inbounds double, ptr %114, i64 11
  %122 = load double, ptr %121, align 8
  %123 = fsub double %22, %122
  br label %124

124:                                              ; preds = %124, %110
  %125 = phi i64 [ 0, %110 ], [ %140, %124 ]
  %126 = getelementptr inbounds double, ptr %114, i64 %125
  %127 = load double, ptr %126, align 8
  %128 = fmul double %117, %127
  %129 = add nuw nsw i64 %125, 3
  %130 = getelementptr inbounds double, ptr %114, i64 %129
  %131 = load double, ptr %130, align 8
  %132 = fmul double %120, %131
  %133 = fadd double %128, %132
  %134 = add nuw nsw i64 %125, 6
  %135 = getelementptr inbounds double, ptr %114, i64 %134
  %136 = load double, ptr %135, align 8
  %137 = fmul double %123, %136
  %138 = fadd double %133, %137
  %139 = getelementptr inbounds double, ptr %5, i64 %125
  store double %138, ptr %139, align 8
  %140 = add nuw nsw i64 %125, 1
  %141 = icmp eq i64 %140, 3
  br i1 %141, label %142, label %124

142:                                              ; preds = %124
  %143 = mul nsw i64 %2, 6
  %144 = getelementptr inbounds double, ptr %83, i64 %143
  br label %145

145:                                              ; preds = %145, %142
  %146 = phi i64 [ 0, %142 ], [ %163, %145 ]
  %147 = phi double [ 0.000000e+00, %142 ], [ %162, %145 ]
  %148 = getelementptr inbounds double, ptr %144, i64 %146
  %149 = load double, ptr %148, align 8
  %150 = getelementptr inbounds double, ptr %5, i64 %146
  %151 = load double, ptr %150, align 8
  %152 = fsub double %149, %151
  %153 = add nuw nsw i64 %146, 3
  %154 = getelementptr inbounds double, ptr %144, i64 %153
  %155 = load double, ptr %154, align 8
  %156 = fsub double %151, %155
  %157 = fcmp ogt double %152, %156
  %158 = select i1 %157, double %152, double %156
  %159 = fcmp ogt double %158, 0.000000e+00
  %160 = select i1 %159, double %158, double 0.000000e+00
  %161 = fmul double %160, %160
  %162 = fadd double %147, %161
  %163 = add nuw nsw i64 %146, 1
  %164 = icmp eq i64 %163, 3
  br i1 %164, label %165, label %145

165:                                              ; preds = %145
  %166 = fmul double %32, %32
  %167 = fcmp ogt double %162, %166
  %168 = zext i1 %167 to i32
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5) #19
  br label %169

169:                                              ; preds = %165, %106, %4
  %170 = phi i32 [ 1, %106 ], [ 1, %4 ], [ %168, %165 ]
  ret i32 %170
}

define internal fastcc void @look_at_solid(ptr noundef %0, i64 noundef %1) unnamed_addr #0 {
  %3 = alloca %struct.Plane, align 8
  %4 = alloca %struct.Plane, align 8
  %5 = alloca %struct.Core, align 8
  %6 = alloca %struct.Two, align 8
  %7 = alloca [12 x double], align 16
  %8 = alloca [3 x double], align 16
  %9 = alloca [3 x double], align 16
  %10 = alloca [12 x double], align 16
  %11 = alloca double, align 8
  %12 = alloca %struct.Search, align 8
  %13 = alloca %struct.Plane, align 8
  %14 = alloca %struct.Plane, align 8
  %15 = load ptr, ptr %0, align 8
  %16 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 12
  %17 = load ptr, ptr %16, align 8
  %18 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %19 = load i64, ptr %18, align 8
  %20 = getelementptr inbounds i64, ptr %17, i64 %19
  %21 = load i64, ptr %20, align 8
  %22 = icmp eq i64 %21, 4
  %23 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %24 = load ptr, ptr %23, align 8
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %5) #19
  call void @llvm.lifetime.start.p0(i64 216, ptr nonnull %6) #19
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %7) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  %25 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 15
  %26 = load ptr, ptr %25, align 8
  %27 = getelementptr inbounds double, ptr %26, i64 %19
  %28 = load double, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %26, i64 %1
  %30 = load double, ptr %29, align 8
  %31 = fadd double %28, %30
  %32 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %33 = load ptr, ptr %32, align 8
  %34 = icmp eq ptr %33, null
  br i1 %34, label %44, label %35

35:                                               ; preds = %2
  %36 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %37 = load ptr, ptr %36, align 8
  %38 = icmp eq ptr %37, null
  %39 = getelementptr inbounds i64, ptr %37, i64 %1
  %40 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %41 = select i1 %38, ptr %40, ptr %39
  %42 = load i64, ptr %41, align 8
  %43 = getelementptr inbounds double, ptr %33, i64 %42
  br label %44

44:                                               ; preds = %2, %35
  %45 = phi ptr [ %43, %35 ], [ null, %2 ]
  %46 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 12
  store i64 -1, ptr %46, align 8
  %47 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  store i64 -1, ptr %47, align 8
  %48 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  store i32 0, ptr %48, align 8
  %49 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  store i32 0, ptr %49, align 4
  %50 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 13
  store i32 0, ptr %50, align 8
  %51 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 18
  store double 0.000000e+00, ptr %51, align 8
  br i1 %22, label %52, label %53

52:                                               ; preds = %44
  call fastcc void @look_at_surfaces(ptr noundef nonnull %0, i64 noundef %1, ptr noundef nonnull %6)
  br label %362

53:                                               ; preds = %44
  %54 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 42
  %55 = load ptr, ptr %54, align 8
  %56 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 11
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i64, ptr %57, i64 %1
  %59 = load i64, ptr %58, align 8
  %60 = getelementptr inbounds i64, ptr %57, i64 %19
  %61 = load i64, ptr %60, align 8
  %62 = mul nsw i64 %61, 12
  %63 = getelementptr inbounds double, ptr %55, i64 %62
  %64 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  store ptr %63, ptr %64, align 8
  %65 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 43
  %66 = load ptr, ptr %65, align 8
  %67 = mul nsw i64 %19, 3
  %68 = getelementptr inbounds double, ptr %66, i64 %67
  %69 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 16
  store ptr %68, ptr %69, align 8
  %70 = icmp sgt i64 %59, 0
  br i1 %70, label %71, label %234

71:                                               ; preds = %53
  %72 = mul nsw i64 %59, 12
  %73 = getelementptr inbounds double, ptr %55, i64 %72
  br label %74

74:                                               ; preds = %117, %71
  %75 = phi i64 [ 0, %71 ], [ %118, %117 ]
  %76 = getelementptr inbounds double, ptr %73, i64 %75
  %77 = add nuw nsw i64 %75, 3
  %78 = getelementptr inbounds double, ptr %73, i64 %77
  %79 = add nuw nsw i64 %75, 6
  %80 = getelementptr inbounds double, ptr %73, i64 %79
  %81 = mul nuw nsw i64 %75, 3
  br label %120

82:                                               ; preds = %117
  %83 = getelementptr inbounds double, ptr %63, i64 9
  %84 = getelementptr inbounds double, ptr %7, i64 9
  %85 = load double, ptr %83, align 8
  %86 = getelementptr inbounds double, ptr %73, i64 9
  %87 = load double, ptr %86, align 8
  %88 = fsub double %85, %87
  %89 = getelementptr inbounds double, ptr %63, i64 10
  %90 = load double, ptr %89, align 8
  %91 = getelementptr inbounds double, ptr %73, i64 10
  %92 = load double, ptr %91, align 8
  %93 = fsub double %90, %92
  %94 = getelementptr inbounds double, ptr %63, i64 11
  %95 = load double, ptr %94, align 8
  %96 = getelementptr inbounds double, ptr %73, i64 11
  %97 = load double, ptr %96, align 8
  %98 = fsub double %95, %97
  br label %99

99:                                               ; preds = %99, %82
  %100 = phi i64 [ 0, %82 ], [ %115, %99 ]
  %101 = getelementptr inbounds double, ptr %73, i64 %100
  %102 = load double, ptr %101, align 8
  %103 = fmul double %88, %102
  %104 = add nuw nsw i64 %100, 3
  %105 = getelementptr inbounds double, ptr %73, i64 %104
  %106 = load double, ptr %105, align 8
  %107 = fmul double %93, %106
  %108 = fadd double %103, %107
  %109 = add nuw nsw i64 %100, 6
  %110 = getelementptr inbounds double, ptr %73, i64 %109
  %111 = load double, ptr %110, align 8
  %112 = fmul double %98, %111
  %113 = fadd double %108, %112
  %114 = getelementptr inbounds double, ptr %84, i64 %100
  store double %113, ptr %114, align 8
  %115 = add nuw nsw i64 %100, 1
  %116 = icmp eq i64 %115, 3
  br i1 %116, label %142, label %99

117:                                              ; preds = %120
  %118 = add nuw nsw i64 %75, 1
  %119 = icmp eq i64 %118, 3
  br i1 %119, label %82, label %74

120:                                              ; preds = %120, %74
  %121 = phi i64 [ 0, %74 ], [ %140, %120 ]
  %122 = load double, ptr %76, align 8
  %123 = getelementptr inbounds double, ptr %63, i64 %121
  %124 = load double, ptr %123, align 8
  %125 = fmul double %122, %124
  %126 = load double, ptr %78, align 8
  %127 = add nuw nsw i64 %121, 3
  %128 = getelementptr inbounds double, ptr %63, i64 %127
  %129 = load double, ptr %128, align 8
  %130 = fmul double %126, %129
  %131 = fadd double %125, %130
  %132 = load double, ptr %80, align 8
  %133 = add nuw nsw i64 %121, 6
  %134 = getelementptr inbounds double, ptr %63, i64 %133
  %135 = load double, ptr %134, align 8
  %136 = fmul double %132, %135
  %137 = fadd double %131, %136
  %138 = add nuw nsw i64 %121, %81
  %139 = getelementptr inbounds double, ptr %7, i64 %138
  store double %137, ptr %139, align 8
  %140 = add nuw nsw i64 %121, 1
  %141 = icmp eq i64 %140, 3
  br i1 %141, label %117, label %120

142:                                              ; preds = %99
  %143 = load double, ptr %68, align 8
  %144 = load double, ptr %86, align 8
  %145 = fsub double %143, %144
  %146 = getelementptr inbounds double, ptr %68, i64 1
  %147 = load double, ptr %146, align 8
  %148 = load double, ptr %91, align 8
  %149 = fsub double %147, %148
  %150 = getelementptr inbounds double, ptr %68, i64 2
  %151 = load double, ptr %150, align 8
  %152 = load double, ptr %96, align 8
  %153 = fsub double %151, %152
  br label %154

154:                                              ; preds = %154, %142
  %155 = phi i64 [ 0, %142 ], [ %170, %154 ]
  %156 = getelementptr inbounds double, ptr %73, i64 %155
  %157 = load double, ptr %156, align 8
  %158 = fmul double %145, %157
  %159 = add nuw nsw i64 %155, 3
  %160 = getelementptr inbounds double, ptr %73, i64 %159
  %161 = load double, ptr %160, align 8
  %162 = fmul double %149, %161
  %163 = fadd double %158, %162
  %164 = add nuw nsw i64 %155, 6
  %165 = getelementptr inbounds double, ptr %73, i64 %164
  %166 = load double, ptr %165, align 8
  %167 = fmul double %153, %166
  %168 = fadd double %163, %167
  %169 = getelementptr inbounds double, ptr %8, i64 %155
  store double %168, ptr %169, align 8
  %170 = add nuw nsw i64 %155, 1
  %171 = icmp eq i64 %170, 3
  br i1 %171, label %172, label %154

172:                                              ; preds = %154
  store ptr %7, ptr %64, align 8
  store ptr %8, ptr %69, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(152) %5, ptr noundef nonnull align 8 dereferenceable(152) %24, i64 152, i1 false)
  %173 = getelementptr inbounds %struct.Core, ptr %5, i64 0, i32 5
  store ptr %7, ptr %173, align 8
  %174 = load i64, ptr %5, align 8
  %175 = icmp eq i64 %174, 0
  br i1 %175, label %232, label %176

176:                                              ; preds = %172
  %177 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 16
  %178 = load ptr, ptr %177, align 8
  %179 = mul nsw i64 %19, 12
  %180 = getelementptr inbounds double, ptr %178, i64 %179
  %181 = getelementptr inbounds %struct.Core, ptr %5, i64 0, i32 7
  %182 = getelementptr inbounds double, ptr %180, i64 9
  %183 = getelementptr inbounds double, ptr %180, i64 10
  %184 = getelementptr inbounds double, ptr %180, i64 11
  br label %185

185:                                              ; preds = %196, %176
  %186 = phi i64 [ 0, %176 ], [ %210, %196 ]
  %187 = mul nuw nsw i64 %186, 3
  %188 = getelementptr inbounds double, ptr %7, i64 %187
  %189 = add nuw nsw i64 %187, 1
  %190 = getelementptr inbounds double, ptr %7, i64 %189
  %191 = add nuw nsw i64 %187, 2
  %192 = getelementptr inbounds double, ptr %7, i64 %191
  %193 = load double, ptr %188, align 8
  %194 = load double, ptr %190, align 8
  %195 = load double, ptr %192, align 8
  br label %212

196:                                              ; preds = %212
  %197 = load double, ptr %182, align 8
  %198 = fmul double %193, %197
  %199 = load double, ptr %183, align 8
  %200 = fmul double %194, %199
  %201 = fadd double %198, %200
  %202 = load double, ptr %184, align 8
  %203 = fmul double %195, %202
  %204 = fadd double %201, %203
  %205 = add nuw nsw i64 %186, 9
  %206 = getelementptr inbounds double, ptr %7, i64 %205
  %207 = load double, ptr %206, align 8
  %208 = fadd double %207, %204
  %209 = getelementptr inbounds double, ptr %181, i64 %205
  store double %208, ptr %209, align 8
  %210 = add nuw nsw i64 %186, 1
  %211 = icmp eq i64 %210, 3
  br i1 %211, label %231, label %185

212:                                              ; preds = %212, %185
  %213 = phi i64 [ 0, %185 ], [ %229, %212 ]
  %214 = getelementptr inbounds double, ptr %180, i64 %213
  %215 = load double, ptr %214, align 8
  %216 = fmul double %193, %215
  %217 = add nuw nsw i64 %213, 3
  %218 = getelementptr inbounds double, ptr %180, i64 %217
  %219 = load double, ptr %218, align 8
  %220 = fmul double %194, %219
  %221 = fadd double %216, %220
  %222 = add nuw nsw i64 %213, 6
  %223 = getelementptr inbounds double, ptr %180, i64 %222
  %224 = load double, ptr %223, align 8
  %225 = fmul double %195, %224
  %226 = fadd double %221, %225
  %227 = add nuw nsw i64 %213, %187
  %228 = getelementptr inbounds double, ptr %181, i64 %227
  store double %226, ptr %228, align 8
  %229 = add nuw nsw i64 %213, 1
  %230 = icmp eq i64 %229, 3
  br i1 %230, label %196, label %212

231:                                              ; preds = %196
  store ptr %181, ptr %173, align 8
  br label %232

232:                                              ; preds = %172, %231
  store ptr %5, ptr %23, align 8
  %233 = select i1 %34, double 0.000000e+00, double 1.000000e-10
  store double %233, ptr %51, align 8
  store i32 1, ptr %48, align 8
  br label %234

234:                                              ; preds = %232, %53
  %235 = phi ptr [ %8, %232 ], [ %68, %53 ]
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %3) #19
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %4) #19
  %236 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 33
  %237 = load ptr, ptr %236, align 8
  %238 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 35
  %239 = load ptr, ptr %238, align 8
  %240 = getelementptr inbounds i64, ptr %239, i64 %1
  %241 = load i64, ptr %240, align 8
  %242 = mul nsw i64 %241, 6
  %243 = getelementptr inbounds double, ptr %237, i64 %242
  %244 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 18
  %245 = load ptr, ptr %244, align 8
  br label %249

246:                                              ; preds = %249
  %247 = call double @llvm.sqrt.f64(double %264)
  %248 = fcmp ogt double %247, 0.000000e+00
  br label %267

249:                                              ; preds = %249, %234
  %250 = phi i64 [ 0, %234 ], [ %265, %249 ]
  %251 = phi double [ 0.000000e+00, %234 ], [ %264, %249 ]
  %252 = getelementptr inbounds double, ptr %235, i64 %250
  %253 = load double, ptr %252, align 8
  %254 = getelementptr inbounds double, ptr %243, i64 %250
  %255 = load double, ptr %254, align 8
  %256 = add nuw nsw i64 %250, 3
  %257 = getelementptr inbounds double, ptr %243, i64 %256
  %258 = load double, ptr %257, align 8
  %259 = fadd double %255, %258
  %260 = fmul double %259, 5.000000e-01
  %261 = fsub double %253, %260
  %262 = getelementptr inbounds [3 x double], ptr %4, i64 0, i64 %250
  store double %261, ptr %262, align 8
  %263 = fmul double %261, %261
  %264 = fadd double %251, %263
  %265 = add nuw nsw i64 %250, 1
  %266 = icmp eq i64 %265, 3
  br i1 %266, label %246, label %249

267:                                              ; preds = %276, %246
  %268 = phi i64 [ 0, %246 ], [ %279, %276 ]
  br i1 %248, label %269, label %273

269:                                              ; preds = %267
  %270 = getelementptr inbounds [3 x double], ptr %4, i64 0, i64 %268
  %271 = load double, ptr %270, align 8
  %272 = fdiv double %271, %247
  br label %276

273:                                              ; preds = %267
  %274 = icmp eq i64 %268, 0
  %275 = uitofp i1 %274 to double
  br label %276

276:                                              ; preds = %273, %269
  %277 = phi double [ %272, %269 ], [ %275, %273 ]
  %278 = getelementptr inbounds [3 x double], ptr %4, i64 0, i64 %268
  store double %277, ptr %278, align 8
  %279 = add nuw nsw i64 %268, 1
  %280 = icmp eq i64 %279, 3
  br i1 %280, label %281, label %267

281:                                              ; preds = %276
  %282 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10
  %283 = shl nsw i64 %19, 2
  %284 = getelementptr inbounds double, ptr %245, i64 %283
  %285 = load double, ptr %4, align 8
  %286 = load double, ptr %235, align 8
  %287 = fmul double %285, %286
  %288 = getelementptr inbounds double, ptr %4, i64 1
  %289 = load double, ptr %288, align 8
  %290 = getelementptr inbounds double, ptr %235, i64 1
  %291 = load double, ptr %290, align 8
  %292 = fmul double %289, %291
  %293 = fadd double %287, %292
  %294 = getelementptr inbounds double, ptr %4, i64 2
  %295 = load double, ptr %294, align 8
  %296 = getelementptr inbounds double, ptr %235, i64 2
  %297 = load double, ptr %296, align 8
  %298 = fmul double %295, %297
  %299 = fadd double %293, %298
  %300 = getelementptr inbounds double, ptr %284, i64 3
  %301 = load double, ptr %300, align 8
  %302 = load ptr, ptr %25, align 8
  %303 = getelementptr inbounds double, ptr %302, i64 %19
  %304 = load double, ptr %303, align 8
  %305 = fsub double %301, %304
  %306 = fsub double %299, %305
  %307 = getelementptr inbounds %struct.Plane, ptr %4, i64 0, i32 1
  store double %306, ptr %307, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %282, ptr noundef nonnull align 8 dereferenceable(32) %4, i64 32, i1 false)
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %4) #19
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %3, ptr noundef nonnull align 8 dereferenceable(32) %282, i64 32, i1 false)
  %308 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  %309 = load ptr, ptr %308, align 8
  %310 = icmp eq ptr %309, null
  br i1 %310, label %343, label %311

311:                                              ; preds = %281
  %312 = load ptr, ptr %56, align 8
  %313 = getelementptr inbounds i64, ptr %312, i64 %1
  %314 = load i64, ptr %313, align 8
  %315 = icmp sgt i64 %314, 0
  br i1 %315, label %316, label %343

316:                                              ; preds = %311
  %317 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %318 = load ptr, ptr %317, align 8
  %319 = icmp eq ptr %318, null
  %320 = getelementptr inbounds i64, ptr %318, i64 %1
  %321 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %322 = select i1 %319, ptr %321, ptr %320
  %323 = load i64, ptr %322, align 8
  %324 = mul nsw i64 %323, 22
  %325 = getelementptr inbounds double, ptr %309, i64 %324
  %326 = load double, ptr %325, align 8
  %327 = fcmp ogt double %326, 0.000000e+00
  br i1 %327, label %328, label %343

328:                                              ; preds = %316
  %329 = fptosi double %326 to i64
  %330 = add nsw i64 %329, -1
  br i1 %34, label %331, label %334

331:                                              ; preds = %328
  %332 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %333 = load double, ptr %332, align 8
  br label %341

334:                                              ; preds = %328
  %335 = getelementptr inbounds double, ptr %33, i64 %323
  %336 = load double, ptr %335, align 8
  %337 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %338 = load double, ptr %337, align 8
  %339 = fcmp ogt double %336, %338
  %340 = select i1 %339, double %338, double %336
  br label %341

341:                                              ; preds = %334, %331
  %342 = phi double [ %340, %334 ], [ %333, %331 ]
  call fastcc void @one_leaf(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %330, double noundef %342, ptr noundef nonnull %3)
  br label %343

343:                                              ; preds = %341, %316, %311, %281
  %344 = phi i1 [ false, %341 ], [ false, %316 ], [ true, %311 ], [ true, %281 ]
  %345 = phi ptr [ %325, %341 ], [ %325, %316 ], [ null, %311 ], [ null, %281 ]
  %346 = load ptr, ptr %238, align 8
  %347 = getelementptr inbounds i64, ptr %346, i64 %1
  %348 = load i64, ptr %347, align 8
  %349 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 13
  %350 = load ptr, ptr %349, align 8
  %351 = getelementptr inbounds i64, ptr %350, i64 %1
  %352 = load i64, ptr %351, align 8
  %353 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 14
  %354 = load ptr, ptr %353, align 8
  %355 = getelementptr inbounds i64, ptr %354, i64 %1
  %356 = load i64, ptr %355, align 8
  call fastcc void @surface(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %348, i64 noundef %352, i64 noundef %356, ptr noundef nonnull %3)
  br i1 %344, label %361, label %357

357:                                              ; preds = %343
  %358 = load i64, ptr %47, align 8
  %359 = add nsw i64 %358, 1
  %360 = sitofp i64 %359 to double
  store double %360, ptr %345, align 8
  br label %361

361:                                              ; preds = %343, %357
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %3) #19
  br label %362

362:                                              ; preds = %361, %52
  %363 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 17
  %364 = load ptr, ptr %363, align 8
  %365 = mul nsw i64 %1, 3
  %366 = getelementptr inbounds double, ptr %364, i64 %365
  %367 = load double, ptr %366, align 8
  %368 = fcmp ogt double %367, 0.000000e+00
  %369 = icmp ne ptr %45, null
  br i1 %369, label %370, label %377

370:                                              ; preds = %362
  %371 = load double, ptr %45, align 8
  %372 = fneg double %31
  %373 = fcmp ogt double %371, %372
  br i1 %373, label %377, label %374

374:                                              ; preds = %370
  %375 = load i64, ptr %47, align 8
  %376 = icmp slt i64 %375, 0
  br label %377

377:                                              ; preds = %374, %370, %362
  %378 = phi i1 [ true, %370 ], [ true, %362 ], [ %376, %374 ]
  %379 = load ptr, ptr %32, align 8
  %380 = icmp eq ptr %379, null
  br i1 %380, label %392, label %381

381:                                              ; preds = %377
  %382 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %383 = load ptr, ptr %382, align 8
  %384 = icmp eq ptr %383, null
  %385 = getelementptr inbounds i64, ptr %383, i64 %1
  %386 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %387 = select i1 %384, ptr %386, ptr %385
  %388 = load i64, ptr %387, align 8
  %389 = getelementptr inbounds double, ptr %379, i64 %388
  %390 = load double, ptr %389, align 8
  %391 = fcmp uno double %390, 0.000000e+00
  br label %396

392:                                              ; preds = %377
  %393 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %394 = load i32, ptr %393, align 8
  %395 = icmp eq i32 %394, 1
  br label %396

396:                                              ; preds = %381, %392
  %397 = phi i1 [ %391, %381 ], [ %395, %392 ]
  %398 = xor i1 %397, true
  %399 = select i1 %398, i1 %378, i1 false
  br i1 %399, label %400, label %578

400:                                              ; preds = %396
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #19
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %10) #19
  %401 = load i32, ptr %49, align 4
  %402 = icmp eq i32 %401, 0
  br i1 %402, label %429, label %403

403:                                              ; preds = %400
  br i1 %380, label %427, label %404

404:                                              ; preds = %403
  %405 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %406 = load ptr, ptr %405, align 8
  %407 = icmp eq ptr %406, null
  %408 = getelementptr inbounds i64, ptr %406, i64 %1
  %409 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %410 = select i1 %407, ptr %409, ptr %408
  %411 = load i64, ptr %410, align 8
  %412 = getelementptr inbounds double, ptr %379, i64 %411
  %413 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %414 = load ptr, ptr %413, align 8
  %415 = icmp eq ptr %414, null
  br i1 %415, label %426, label %416

416:                                              ; preds = %404
  %417 = load double, ptr %412, align 8
  %418 = fcmp oeq double %417, 0x7FF0000000000000
  br i1 %418, label %419, label %426

419:                                              ; preds = %416
  %420 = load ptr, ptr %0, align 8
  %421 = getelementptr inbounds %struct.World, ptr %420, i64 0, i32 45
  %422 = load ptr, ptr %421, align 8
  %423 = load i64, ptr %414, align 8
  %424 = add nsw i64 %423, 1
  store i64 %424, ptr %414, align 8
  %425 = getelementptr inbounds i64, ptr %422, i64 %423
  store i64 %411, ptr %425, align 8
  br label %426

426:                                              ; preds = %419, %416, %404
  store double 0x7FF8000000000000, ptr %412, align 8
  br label %577

427:                                              ; preds = %403
  %428 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  store i32 1, ptr %428, align 8
  br label %577

429:                                              ; preds = %400
  br i1 %22, label %430, label %528

430:                                              ; preds = %429
  br i1 %368, label %431, label %437

431:                                              ; preds = %430
  %432 = load i64, ptr %18, align 8
  %433 = getelementptr inbounds %struct.Two, ptr %6, i64 0, i32 2
  %434 = call fastcc i32 @is_around(ptr noundef nonnull %15, i64 noundef %1, i64 noundef %432, ptr noundef nonnull %433)
  %435 = icmp ne i32 %434, 0
  %436 = zext i1 %435 to i32
  store i32 %436, ptr %50, align 8
  br i1 %435, label %577, label %439

437:                                              ; preds = %430
  store i32 0, ptr %50, align 8
  %438 = load i64, ptr %18, align 8
  br label %439

439:                                              ; preds = %437, %431
  %440 = phi i64 [ %438, %437 ], [ %432, %431 ]
  %441 = mul nsw i64 %440, 3
  %442 = getelementptr inbounds double, ptr %364, i64 %441
  %443 = load double, ptr %442, align 8
  %444 = fcmp ogt double %443, 0.000000e+00
  br i1 %444, label %445, label %577

445:                                              ; preds = %439
  %446 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 42
  %447 = load ptr, ptr %446, align 8
  %448 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 11
  %449 = load ptr, ptr %448, align 8
  %450 = getelementptr inbounds i64, ptr %449, i64 %440
  %451 = load i64, ptr %450, align 8
  %452 = mul nsw i64 %451, 12
  %453 = getelementptr inbounds double, ptr %447, i64 %452
  %454 = getelementptr inbounds i64, ptr %449, i64 %1
  %455 = load i64, ptr %454, align 8
  %456 = mul nsw i64 %455, 12
  %457 = getelementptr inbounds double, ptr %447, i64 %456
  br label %458

458:                                              ; preds = %504, %445
  %459 = phi i64 [ 0, %445 ], [ %505, %504 ]
  %460 = getelementptr inbounds double, ptr %453, i64 %459
  %461 = add nuw nsw i64 %459, 3
  %462 = getelementptr inbounds double, ptr %453, i64 %461
  %463 = add nuw nsw i64 %459, 6
  %464 = getelementptr inbounds double, ptr %453, i64 %463
  %465 = mul nuw nsw i64 %459, 3
  %466 = load double, ptr %460, align 8
  %467 = load double, ptr %462, align 8
  %468 = load double, ptr %464, align 8
  br label %507

469:                                              ; preds = %504
  %470 = getelementptr inbounds double, ptr %457, i64 9
  %471 = getelementptr inbounds double, ptr %10, i64 9
  %472 = load double, ptr %470, align 8
  %473 = getelementptr inbounds double, ptr %453, i64 9
  %474 = load double, ptr %473, align 8
  %475 = fsub double %472, %474
  %476 = getelementptr inbounds double, ptr %457, i64 10
  %477 = load double, ptr %476, align 8
  %478 = getelementptr inbounds double, ptr %453, i64 10
  %479 = load double, ptr %478, align 8
  %480 = fsub double %477, %479
  %481 = getelementptr inbounds double, ptr %457, i64 11
  %482 = load double, ptr %481, align 8
  %483 = getelementptr inbounds double, ptr %453, i64 11
  %484 = load double, ptr %483, align 8
  %485 = fsub double %482, %484
  br label %486

486:                                              ; preds = %486, %469
  %487 = phi i64 [ 0, %469 ], [ %502, %486 ]
  %488 = getelementptr inbounds double, ptr %453, i64 %487
  %489 = load double, ptr %488, align 8
  %490 = fmul double %475, %489
  %491 = add nuw nsw i64 %487, 3
  %492 = getelementptr inbounds double, ptr %453, i64 %491
  %493 = load double, ptr %492, align 8
  %494 = fmul double %480, %493
  %495 = fadd double %490, %494
  %496 = add nuw nsw i64 %487, 6
  %497 = getelementptr inbounds double, ptr %453, i64 %496
  %498 = load double, ptr %497, align 8
  %499 = fmul double %485, %498
  %500 = fadd double %495, %499
  %501 = getelementptr inbounds double, ptr %471, i64 %487
  store double %500, ptr %501, align 8
  %502 = add nuw nsw i64 %487, 1
  %503 = icmp eq i64 %502, 3
  br i1 %503, label %526, label %486

504:                                              ; preds = %507
  %505 = add nuw nsw i64 %459, 1
  %506 = icmp eq i64 %505, 3
  br i1 %506, label %469, label %458

507:                                              ; preds = %507, %458
  %508 = phi i64 [ 0, %458 ], [ %524, %507 ]
  %509 = getelementptr inbounds double, ptr %457, i64 %508
  %510 = load double, ptr %509, align 8
  %511 = fmul double %466, %510
  %512 = add nuw nsw i64 %508, 3
  %513 = getelementptr inbounds double, ptr %457, i64 %512
  %514 = load double, ptr %513, align 8
  %515 = fmul double %467, %514
  %516 = fadd double %511, %515
  %517 = add nuw nsw i64 %508, 6
  %518 = getelementptr inbounds double, ptr %457, i64 %517
  %519 = load double, ptr %518, align 8
  %520 = fmul double %468, %519
  %521 = fadd double %516, %520
  %522 = add nuw nsw i64 %508, %465
  %523 = getelementptr inbounds double, ptr %10, i64 %522
  store double %521, ptr %523, align 8
  %524 = add nuw nsw i64 %508, 1
  %525 = icmp eq i64 %524, 3
  br i1 %525, label %504, label %507

526:                                              ; preds = %486
  %527 = call fastcc i32 @is_around(ptr noundef %15, i64 noundef %440, i64 noundef %1, ptr noundef nonnull %10)
  store i32 %527, ptr %50, align 8
  br label %577

528:                                              ; preds = %429
  br i1 %368, label %529, label %577

529:                                              ; preds = %528
  %530 = load ptr, ptr %23, align 8
  call fastcc void @support(ptr noundef %530, ptr noundef nonnull @__const.nearest_of.share, ptr noundef nonnull %9)
  %531 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 33
  %532 = load ptr, ptr %531, align 8
  %533 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 35
  %534 = load ptr, ptr %533, align 8
  %535 = getelementptr inbounds i64, ptr %534, i64 %1
  %536 = load i64, ptr %535, align 8
  %537 = mul nsw i64 %536, 6
  %538 = getelementptr inbounds double, ptr %532, i64 %537
  br label %539

539:                                              ; preds = %539, %529
  %540 = phi i64 [ 0, %529 ], [ %557, %539 ]
  %541 = phi double [ 0.000000e+00, %529 ], [ %556, %539 ]
  %542 = getelementptr inbounds double, ptr %538, i64 %540
  %543 = load double, ptr %542, align 8
  %544 = getelementptr inbounds double, ptr %9, i64 %540
  %545 = load double, ptr %544, align 8
  %546 = fsub double %543, %545
  %547 = add nuw nsw i64 %540, 3
  %548 = getelementptr inbounds double, ptr %538, i64 %547
  %549 = load double, ptr %548, align 8
  %550 = fsub double %545, %549
  %551 = fcmp ogt double %546, %550
  %552 = select i1 %551, double %546, double %550
  %553 = fcmp ogt double %552, 0.000000e+00
  %554 = select i1 %553, double %552, double 0.000000e+00
  %555 = fmul double %554, %554
  %556 = fadd double %541, %555
  %557 = add nuw nsw i64 %540, 1
  %558 = icmp eq i64 %557, 3
  br i1 %558, label %559, label %539

559:                                              ; preds = %539
  %560 = call double @llvm.sqrt.f64(double %556)
  %561 = fcmp ogt double %560, 0.000000e+00
  br i1 %561, label %575, label %565

562:                                              ; preds = %565
  %563 = icmp ugt i32 %572, 1
  %564 = zext i1 %563 to i32
  br label %575

565:                                              ; preds = %559, %565
  %566 = phi i64 [ %573, %565 ], [ 0, %559 ]
  %567 = phi i32 [ %572, %565 ], [ 0, %559 ]
  %568 = getelementptr inbounds [3 x [3 x double]], ptr @within.ray, i64 0, i64 %566
  %569 = call fastcc i32 @leaves(ptr noundef %15, i64 noundef %536, ptr noundef nonnull %9, ptr noundef nonnull %568)
  %570 = icmp ne i32 %569, 0
  %571 = zext i1 %570 to i32
  %572 = add nuw nsw i32 %567, %571
  %573 = add nuw nsw i64 %566, 1
  %574 = icmp eq i64 %573, 3
  br i1 %574, label %562, label %565

575:                                              ; preds = %559, %562
  %576 = phi i32 [ %564, %562 ], [ 0, %559 ]
  store i32 %576, ptr %50, align 8
  br label %577

577:                                              ; preds = %427, %426, %526, %439, %431, %575, %528
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %10) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #19
  br label %578

578:                                              ; preds = %577, %396
  %579 = load i32, ptr %50, align 8
  %580 = icmp eq i32 %579, 0
  %581 = or i1 %369, %580
  br i1 %581, label %608, label %582

582:                                              ; preds = %578
  br i1 %380, label %606, label %583

583:                                              ; preds = %582
  %584 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %585 = load ptr, ptr %584, align 8
  %586 = icmp eq ptr %585, null
  %587 = getelementptr inbounds i64, ptr %585, i64 %1
  %588 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %589 = select i1 %586, ptr %588, ptr %587
  %590 = load i64, ptr %589, align 8
  %591 = getelementptr inbounds double, ptr %379, i64 %590
  %592 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %593 = load ptr, ptr %592, align 8
  %594 = icmp eq ptr %593, null
  br i1 %594, label %605, label %595

595:                                              ; preds = %583
  %596 = load double, ptr %591, align 8
  %597 = fcmp oeq double %596, 0x7FF0000000000000
  br i1 %597, label %598, label %605

598:                                              ; preds = %595
  %599 = load ptr, ptr %0, align 8
  %600 = getelementptr inbounds %struct.World, ptr %599, i64 0, i32 45
  %601 = load ptr, ptr %600, align 8
  %602 = load i64, ptr %593, align 8
  %603 = add nsw i64 %602, 1
  store i64 %603, ptr %593, align 8
  %604 = getelementptr inbounds i64, ptr %601, i64 %602
  store i64 %590, ptr %604, align 8
  br label %605

605:                                              ; preds = %598, %595, %583
  store double 0x7FF8000000000000, ptr %591, align 8
  br label %768

606:                                              ; preds = %582
  %607 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  store i32 1, ptr %607, align 8
  br label %768

608:                                              ; preds = %578
  br i1 %580, label %768, label %609

609:                                              ; preds = %608
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %11) #19
  store double 0x7FF0000000000000, ptr %11, align 8
  %610 = load i64, ptr %47, align 8
  %611 = icmp sgt i64 %610, -1
  br i1 %611, label %612, label %618

612:                                              ; preds = %609
  %613 = load double, ptr %45, align 8
  %614 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %615 = load double, ptr %614, align 8
  %616 = fcmp olt double %613, %615
  br i1 %616, label %617, label %618

617:                                              ; preds = %612
  store double %613, ptr %11, align 8
  br label %719

618:                                              ; preds = %612, %609
  call void @llvm.lifetime.start.p0(i64 168, ptr nonnull %12) #19
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(168) %12, ptr noundef nonnull align 8 dereferenceable(168) %0, i64 168, i1 false)
  %619 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 3
  %620 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 5
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %619, i8 0, i64 16, i1 false)
  store double 0x7FF0000000000000, ptr %620, align 8
  %621 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 6
  store ptr %11, ptr %621, align 8
  %622 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 7
  store ptr null, ptr %622, align 8
  %623 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 11
  store ptr null, ptr %623, align 8
  br i1 %22, label %624, label %625

624:                                              ; preds = %618
  call fastcc void @look_at_surfaces(ptr noundef nonnull %12, i64 noundef %1, ptr noundef nonnull %6)
  br label %710

625:                                              ; preds = %618
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %13) #19
  %626 = load i64, ptr %18, align 8
  %627 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 16
  %628 = load ptr, ptr %627, align 8
  %629 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 33
  %630 = load ptr, ptr %629, align 8
  %631 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 35
  %632 = load ptr, ptr %631, align 8
  %633 = getelementptr inbounds i64, ptr %632, i64 %1
  %634 = load i64, ptr %633, align 8
  %635 = mul nsw i64 %634, 6
  %636 = getelementptr inbounds double, ptr %630, i64 %635
  %637 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 18
  %638 = load ptr, ptr %637, align 8
  br label %642

639:                                              ; preds = %642
  %640 = call double @llvm.sqrt.f64(double %657)
  %641 = fcmp ogt double %640, 0.000000e+00
  br label %660

642:                                              ; preds = %642, %625
  %643 = phi i64 [ 0, %625 ], [ %658, %642 ]
  %644 = phi double [ 0.000000e+00, %625 ], [ %657, %642 ]
  %645 = getelementptr inbounds double, ptr %628, i64 %643
  %646 = load double, ptr %645, align 8
  %647 = getelementptr inbounds double, ptr %636, i64 %643
  %648 = load double, ptr %647, align 8
  %649 = add nuw nsw i64 %643, 3
  %650 = getelementptr inbounds double, ptr %636, i64 %649
  %651 = load double, ptr %650, align 8
  %652 = fadd double %648, %651
  %653 = fmul double %652, 5.000000e-01
  %654 = fsub double %646, %653
  %655 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %643
  store double %654, ptr %655, align 8
  %656 = fmul double %654, %654
  %657 = fadd double %644, %656
  %658 = add nuw nsw i64 %643, 1
  %659 = icmp eq i64 %658, 3
  br i1 %659, label %639, label %642

660:                                              ; preds = %669, %639
  %661 = phi i64 [ 0, %639 ], [ %672, %669 ]
  br i1 %641, label %662, label %666

662:                                              ; preds = %660
  %663 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %661
  %664 = load double, ptr %663, align 8
  %665 = fdiv double %664, %640
  br label %669

666:                                              ; preds = %660
  %667 = icmp eq i64 %661, 0
  %668 = uitofp i1 %667 to double
  br label %669

669:                                              ; preds = %666, %662
  %670 = phi double [ %665, %662 ], [ %668, %666 ]
  %671 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %661
  store double %670, ptr %671, align 8
  %672 = add nuw nsw i64 %661, 1
  %673 = icmp eq i64 %672, 3
  br i1 %673, label %674, label %660

674:                                              ; preds = %669
  %675 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 10
  %676 = shl nsw i64 %626, 2
  %677 = getelementptr inbounds double, ptr %638, i64 %676
  %678 = load double, ptr %13, align 8
  %679 = load double, ptr %628, align 8
  %680 = fmul double %678, %679
  %681 = getelementptr inbounds double, ptr %13, i64 1
  %682 = load double, ptr %681, align 8
  %683 = getelementptr inbounds double, ptr %628, i64 1
  %684 = load double, ptr %683, align 8
  %685 = fmul double %682, %684
  %686 = fadd double %680, %685
  %687 = getelementptr inbounds double, ptr %13, i64 2
  %688 = load double, ptr %687, align 8
  %689 = getelementptr inbounds double, ptr %628, i64 2
  %690 = load double, ptr %689, align 8
  %691 = fmul double %688, %690
  %692 = fadd double %686, %691
  %693 = getelementptr inbounds double, ptr %677, i64 3
  %694 = load double, ptr %693, align 8
  %695 = load ptr, ptr %25, align 8
  %696 = getelementptr inbounds double, ptr %695, i64 %626
  %697 = load double, ptr %696, align 8
  %698 = fsub double %694, %697
  %699 = fsub double %692, %698
  %700 = getelementptr inbounds %struct.Plane, ptr %13, i64 0, i32 1
  store double %699, ptr %700, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %675, ptr noundef nonnull align 8 dereferenceable(32) %13, i64 32, i1 false)
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %13) #19
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %14) #19
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %14, ptr noundef nonnull align 8 dereferenceable(32) %675, i64 32, i1 false)
  %701 = load i64, ptr %633, align 8
  %702 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 13
  %703 = load ptr, ptr %702, align 8
  %704 = getelementptr inbounds i64, ptr %703, i64 %1
  %705 = load i64, ptr %704, align 8
  %706 = getelementptr inbounds %struct.World, ptr %15, i64 0, i32 14
  %707 = load ptr, ptr %706, align 8
  %708 = getelementptr inbounds i64, ptr %707, i64 %1
  %709 = load i64, ptr %708, align 8
  call fastcc void @surface(ptr noundef nonnull %12, i64 noundef %1, i64 noundef %701, i64 noundef %705, i64 noundef %709, ptr noundef nonnull %14)
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %14) #19
  br label %710

710:                                              ; preds = %674, %624
  %711 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 9
  %712 = load i64, ptr %711, align 8
  store i64 %712, ptr %47, align 8
  %713 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 12
  %714 = load i64, ptr %713, align 8
  store i64 %714, ptr %46, align 8
  %715 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10
  %716 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 10
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %715, ptr noundef nonnull align 8 dereferenceable(32) %716, i64 32, i1 false)
  call void @llvm.lifetime.end.p0(i64 168, ptr nonnull %12) #19
  %717 = load double, ptr %11, align 8
  %718 = load ptr, ptr %32, align 8
  br label %719

719:                                              ; preds = %710, %617
  %720 = phi ptr [ %718, %710 ], [ %379, %617 ]
  %721 = phi double [ %717, %710 ], [ %613, %617 ]
  %722 = fcmp ord double %721, 0.000000e+00
  %723 = call double @llvm.fabs.f64(double %721)
  %724 = fneg double %723
  %725 = icmp eq ptr %720, null
  br i1 %725, label %760, label %726

726:                                              ; preds = %719
  %727 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %728 = load ptr, ptr %727, align 8
  %729 = icmp eq ptr %728, null
  %730 = getelementptr inbounds i64, ptr %728, i64 %1
  %731 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %732 = select i1 %729, ptr %731, ptr %730
  %733 = load i64, ptr %732, align 8
  %734 = getelementptr inbounds double, ptr %720, i64 %733
  %735 = fsub double %723, %723
  %736 = fcmp ole double %735, 1.000000e-08
  %737 = and i1 %722, %736
  br i1 %722, label %738, label %744

738:                                              ; preds = %726
  %739 = load double, ptr %734, align 8
  %740 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %741 = load double, ptr %740, align 8
  %742 = call double @llvm.minnum.f64(double %739, double %741)
  %743 = fcmp ugt double %742, %724
  br i1 %743, label %744, label %767

744:                                              ; preds = %738, %726
  %745 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %746 = load ptr, ptr %745, align 8
  %747 = icmp eq ptr %746, null
  br i1 %747, label %758, label %748

748:                                              ; preds = %744
  %749 = load double, ptr %734, align 8
  %750 = fcmp oeq double %749, 0x7FF0000000000000
  br i1 %750, label %751, label %758

751:                                              ; preds = %748
  %752 = load ptr, ptr %0, align 8
  %753 = getelementptr inbounds %struct.World, ptr %752, i64 0, i32 45
  %754 = load ptr, ptr %753, align 8
  %755 = load i64, ptr %746, align 8
  %756 = add nsw i64 %755, 1
  store i64 %756, ptr %746, align 8
  %757 = getelementptr inbounds i64, ptr %754, i64 %755
  store i64 %733, ptr %757, align 8
  br label %758

758:                                              ; preds = %751, %748, %744
  %759 = select i1 %737, double %724, double 0x7FF8000000000000
  store double %759, ptr %734, align 8
  br label %767

760:                                              ; preds = %719
  br i1 %722, label %761, label %765

761:                                              ; preds = %760
  %762 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %763 = load double, ptr %762, align 8
  %764 = fcmp ult double %763, %724
  br i1 %764, label %767, label %765

765:                                              ; preds = %761, %760
  %766 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  store i32 1, ptr %766, align 8
  br label %767

767:                                              ; preds = %761, %738, %758, %765
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %11) #19
  br label %768

768:                                              ; preds = %606, %605, %608, %767
  br i1 %22, label %769, label %772

769:                                              ; preds = %768
  %770 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10
  %771 = getelementptr inbounds %struct.Two, ptr %6, i64 0, i32 5
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %770, ptr noundef nonnull align 8 dereferenceable(24) %771, i64 24, i1 false)
  br label %772

772:                                              ; preds = %769, %768
  store ptr %24, ptr %23, align 8
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %7) #19
  call void @llvm.lifetime.end.p0(i64 216, ptr nonnull %6) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %5) #19
  ret void
}

define internal fastcc i32 @bounds_near(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef writeonly %3, double noundef %4, ptr nocapture noundef %5, ptr nocapture noundef %6, ptr noundef %7) unnamed_addr #6 {
  %9 = alloca [3 x double], align 16
  %10 = alloca [3 x double], align 16
  %11 = getelementptr inbounds double, ptr %0, i64 3
  %12 = load double, ptr %11, align 8
  %13 = fptosi double %12 to i32
  %14 = getelementptr inbounds %struct.Simplex, ptr %7, i64 0, i32 2
  store i32 %13, ptr %14, align 8
  %15 = icmp eq i32 %13, 0
  br i1 %15, label %117, label %16

16:                                               ; preds = %8
  %17 = icmp sgt i32 %13, 0
  br i1 %17, label %18, label %26

18:                                               ; preds = %16
  %19 = getelementptr inbounds %struct.Core, ptr %1, i64 0, i32 5
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds double, ptr %0, i64 4
  %22 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 5
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds double, ptr %0, i64 7
  %25 = zext i32 %13 to i64
  br label %29

26:                                               ; preds = %92, %16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %10) #19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %10, i8 0, i64 24, i1 false)
  %27 = call fastcc i32 @bounds_from(ptr noundef %1, ptr noundef %2, ptr noundef nonnull %10, double noundef %4, double noundef 0xFFF0000000000000, double noundef 1.000000e-15, ptr noundef %5, ptr noundef %6, ptr noundef null, ptr noundef nonnull %7, i32 noundef 1)
  %28 = icmp eq i32 %27, 0
  br i1 %28, label %115, label %105

29:                                               ; preds = %18, %92
  %30 = phi i64 [ 0, %18 ], [ %93, %92 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #19
  %31 = mul nuw nsw i64 %30, 6
  %32 = getelementptr inbounds double, ptr %21, i64 %31
  %33 = getelementptr inbounds %struct.Simplex, ptr %7, i64 0, i32 1, i64 %30
  %34 = getelementptr inbounds double, ptr %32, i64 1
  %35 = getelementptr inbounds double, ptr %32, i64 2
  br label %36

36:                                               ; preds = %36, %29
  %37 = phi i64 [ 0, %29 ], [ %60, %36 ]
  %38 = mul nuw nsw i64 %37, 3
  %39 = getelementptr inbounds double, ptr %20, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = load double, ptr %32, align 8
  %42 = fmul double %40, %41
  %43 = add nuw nsw i64 %38, 1
  %44 = getelementptr inbounds double, ptr %20, i64 %43
  %45 = load double, ptr %44, align 8
  %46 = load double, ptr %34, align 8
  %47 = fmul double %45, %46
  %48 = fadd double %42, %47
  %49 = add nuw nsw i64 %38, 2
  %50 = getelementptr inbounds double, ptr %20, i64 %49
  %51 = load double, ptr %50, align 8
  %52 = load double, ptr %35, align 8
  %53 = fmul double %51, %52
  %54 = fadd double %48, %53
  %55 = add nuw nsw i64 %37, 9
  %56 = getelementptr inbounds double, ptr %20, i64 %55
  %57 = load double, ptr %56, align 8
  %58 = fadd double %57, %54
  %59 = getelementptr inbounds double, ptr %33, i64 %37
  store double %58, ptr %59, align 8
  %60 = add nuw nsw i64 %37, 1
  %61 = icmp eq i64 %60, 3
  br i1 %61, label %62, label %36

62:                                               ; preds = %36
  %63 = getelementptr inbounds double, ptr %24, i64 %31
  %64 = getelementptr inbounds double, ptr %63, i64 1
  %65 = getelementptr inbounds double, ptr %63, i64 2
  %66 = load double, ptr %63, align 8
  %67 = load double, ptr %64, align 8
  %68 = load double, ptr %65, align 8
  br label %69

69:                                               ; preds = %69, %62
  %70 = phi i64 [ 0, %62 ], [ %90, %69 ]
  %71 = mul nuw nsw i64 %70, 3
  %72 = getelementptr inbounds double, ptr %23, i64 %71
  %73 = load double, ptr %72, align 8
  %74 = fmul double %73, %66
  %75 = add nuw nsw i64 %71, 1
  %76 = getelementptr inbounds double, ptr %23, i64 %75
  %77 = load double, ptr %76, align 8
  %78 = fmul double %77, %67
  %79 = fadd double %74, %78
  %80 = add nuw nsw i64 %71, 2
  %81 = getelementptr inbounds double, ptr %23, i64 %80
  %82 = load double, ptr %81, align 8
  %83 = fmul double %82, %68
  %84 = fadd double %79, %83
  %85 = add nuw nsw i64 %70, 9
  %86 = getelementptr inbounds double, ptr %23, i64 %85
  %87 = load double, ptr %86, align 8
  %88 = fadd double %87, %84
  %89 = getelementptr inbounds double, ptr %9, i64 %70
  store double %88, ptr %89, align 8
  %90 = add nuw nsw i64 %70, 1
  %91 = icmp eq i64 %90, 3
  br i1 %91, label %95, label %69

92:                                               ; preds = %95
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #19
  %93 = add nuw nsw i64 %30, 1
  %94 = icmp eq i64 %93, %25
  br i1 %94, label %26, label %29

95:                                               ; preds = %69, %95
  %96 = phi i64 [ %103, %95 ], [ 0, %69 ]
  %97 = getelementptr inbounds %struct.Simplex, ptr %7, i64 0, i32 1, i64 %30, i64 %96
  %98 = load double, ptr %97, align 8
  %99 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %96
  %100 = load double, ptr %99, align 8
  %101 = fsub double %98, %100
  %102 = getelementptr inbounds [4 x [3 x double]], ptr %7, i64 0, i64 %30, i64 %96
  store double %101, ptr %102, align 8
  %103 = add nuw nsw i64 %96, 1
  %104 = icmp eq i64 %103, 3
  br i1 %104, label %92, label %95

105:                                              ; preds = %26
  %106 = load double, ptr %6, align 8
  %107 = fcmp ogt double %106, 0x3EB0C6F7A0B5ED8D
  br i1 %107, label %108, label %115

108:                                              ; preds = %105
  %109 = load double, ptr %5, align 8
  %110 = fcmp ule double %109, %4
  %111 = fsub double %106, %109
  %112 = fcmp ugt double %111, 0x3DA5FD7FE1796495
  %113 = select i1 %110, i1 %112, i1 false
  br i1 %113, label %115, label %114

114:                                              ; preds = %108
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %3, ptr noundef nonnull align 16 dereferenceable(24) %10, i64 24, i1 false)
  br label %115

115:                                              ; preds = %26, %105, %108, %114
  %116 = phi i32 [ 1, %114 ], [ 0, %108 ], [ 0, %105 ], [ 0, %26 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %10) #19
  br label %117

117:                                              ; preds = %8, %115
  %118 = phi i32 [ %116, %115 ], [ 0, %8 ]
  ret i32 %118
}

define internal fastcc void @keep_guess(ptr nocapture noundef %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, i32 noundef %5) unnamed_addr #7 {
  %7 = alloca [3 x double], align 16
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %0, ptr noundef nonnull align 8 dereferenceable(24) %3, i64 24, i1 false)
  %8 = icmp eq i32 %5, 0
  br i1 %8, label %15, label %9

9:                                                ; preds = %6
  %10 = getelementptr inbounds %struct.Simplex, ptr %4, i64 0, i32 2
  %11 = load i32, ptr %10, align 8
  %12 = icmp slt i32 %11, 4
  br i1 %12, label %13, label %15

13:                                               ; preds = %9
  %14 = sitofp i32 %11 to double
  br label %15

15:                                               ; preds = %6, %9, %13
  %16 = phi double [ %14, %13 ], [ 0.000000e+00, %9 ], [ 0.000000e+00, %6 ]
  %17 = getelementptr inbounds double, ptr %0, i64 3
  store double %16, ptr %17, align 8
  %18 = fptosi double %16 to i32
  %19 = icmp sgt i32 %18, 0
  br i1 %19, label %20, label %36

20:                                               ; preds = %15
  %21 = getelementptr inbounds %struct.Core, ptr %1, i64 0, i32 5
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr inbounds double, ptr %0, i64 4
  %24 = getelementptr inbounds double, ptr %22, i64 9
  %25 = getelementptr inbounds double, ptr %22, i64 10
  %26 = getelementptr inbounds double, ptr %22, i64 11
  %27 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 5
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %0, i64 7
  %30 = getelementptr inbounds double, ptr %28, i64 9
  %31 = getelementptr inbounds double, ptr %7, i64 1
  %32 = getelementptr inbounds double, ptr %28, i64 10
  %33 = getelementptr inbounds double, ptr %7, i64 2
  %34 = getelementptr inbounds double, ptr %28, i64 11
  %35 = zext i32 %18 to i64
  br label %37

36:                                               ; preds = %102, %15
  ret void

37:                                               ; preds = %20, %102
  %38 = phi i64 [ 0, %20 ], [ %103, %102 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  br label %105

39:                                               ; preds = %105
  %40 = getelementptr inbounds %struct.Simplex, ptr %4, i64 0, i32 1, i64 %38
  %41 = mul i64 %38, 6
  %42 = and i64 %41, 4294967294
  %43 = getelementptr inbounds double, ptr %23, i64 %42
  %44 = load double, ptr %40, align 8
  %45 = load double, ptr %24, align 8
  %46 = fsub double %44, %45
  %47 = getelementptr inbounds double, ptr %40, i64 1
  %48 = load double, ptr %47, align 8
  %49 = load double, ptr %25, align 8
  %50 = fsub double %48, %49
  %51 = getelementptr inbounds double, ptr %40, i64 2
  %52 = load double, ptr %51, align 8
  %53 = load double, ptr %26, align 8
  %54 = fsub double %52, %53
  br label %55

55:                                               ; preds = %55, %39
  %56 = phi i64 [ 0, %39 ], [ %71, %55 ]
  %57 = getelementptr inbounds double, ptr %22, i64 %56
  %58 = load double, ptr %57, align 8
  %59 = fmul double %46, %58
  %60 = add nuw nsw i64 %56, 3
  %61 = getelementptr inbounds double, ptr %22, i64 %60
  %62 = load double, ptr %61, align 8
  %63 = fmul double %50, %62
  %64 = fadd double %59, %63
  %65 = add nuw nsw i64 %56, 6
  %66 = getelementptr inbounds double, ptr %22, i64 %65
  %67 = load double, ptr %66, align 8
  %68 = fmul double %54, %67
  %69 = fadd double %64, %68
  %70 = getelementptr inbounds double, ptr %43, i64 %56
  store double %69, ptr %70, align 8
  %71 = add nuw nsw i64 %56, 1
  %72 = icmp eq i64 %71, 3
  br i1 %72, label %73, label %55

73:                                               ; preds = %55
  %74 = getelementptr inbounds double, ptr %29, i64 %42
  %75 = load double, ptr %7, align 16
  %76 = load double, ptr %30, align 8
  %77 = fsub double %75, %76
  %78 = load double, ptr %31, align 8
  %79 = load double, ptr %32, align 8
  %80 = fsub double %78, %79
  %81 = load double, ptr %33, align 16
  %82 = load double, ptr %34, align 8
  %83 = fsub double %81, %82
  br label %84

84:                                               ; preds = %84, %73
  %85 = phi i64 [ 0, %73 ], [ %100, %84 ]
  %86 = getelementptr inbounds double, ptr %28, i64 %85
  %87 = load double, ptr %86, align 8
  %88 = fmul double %77, %87
  %89 = add nuw nsw i64 %85, 3
  %90 = getelementptr inbounds double, ptr %28, i64 %89
  %91 = load double, ptr %90, align 8
  %92 = fmul double %80, %91
  %93 = fadd double %88, %92
  %94 = add nuw nsw i64 %85, 6
  %95 = getelementptr inbounds double, ptr %28, i64 %94
  %96 = load double, ptr %95, align 8
  %97 = fmul double %83, %96
  %98 = fadd double %93, %97
  %99 = getelementptr inbounds double, ptr %74, i64 %85
  store double %98, ptr %99, align 8
  %100 = add nuw nsw i64 %85, 1
  %101 = icmp eq i64 %100, 3
  br i1 %101, label %102, label %84

102:                                              ; preds = %84
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  %103 = add nuw nsw i64 %38, 1
  %104 = icmp eq i64 %103, %35
  br i1 %104, label %36, label %37

105:                                              ; preds = %37, %105
  %106 = phi i64 [ 0, %37 ], [ %113, %105 ]
  %107 = getelementptr inbounds %struct.Simplex, ptr %4, i64 0, i32 1, i64 %38, i64 %106
  %108 = load double, ptr %107, align 8
  %109 = getelementptr inbounds [4 x [3 x double]], ptr %4, i64 0, i64 %38, i64 %106
  %110 = load double, ptr %109, align 8
  %111 = fsub double %108, %110
  %112 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %106
  store double %111, ptr %112, align 8
  %113 = add nuw nsw i64 %106, 1
  %114 = icmp eq i64 %113, 3
  br i1 %114, label %39, label %105
}

define internal fastcc i32 @depth_of(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef %3, ptr noundef %4, ptr nocapture noundef %5, ptr nocapture noundef writeonly %6) unnamed_addr #12 {
  %8 = alloca [3 x double], align 16
  %9 = alloca [3 x double], align 16
  %10 = alloca [3 x double], align 16
  %11 = alloca [384 x [2 x i32]], align 16
  %12 = alloca [3 x double], align 16
  %13 = alloca [3 x double], align 16
  %14 = alloca [3 x double], align 16
  %15 = alloca [3 x double], align 16
  %16 = alloca [3 x double], align 16
  %17 = alloca [3 x double], align 16
  %18 = alloca [3 x double], align 16
  %19 = alloca [3 x double], align 16
  %20 = alloca [3 x double], align 16
  %21 = alloca [3 x double], align 16
  %22 = alloca [3 x double], align 16
  %23 = alloca [3 x double], align 16
  %24 = alloca [3 x double], align 16
  %25 = alloca [3 x double], align 16
  %26 = alloca [128 x [3 x double]], align 16
  %27 = alloca [128 x [3 x double]], align 16
  %28 = alloca [256 x %struct.Face], align 16
  %29 = alloca [3 x double], align 16
  %30 = alloca [3 x double], align 16
  %31 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 3072, ptr nonnull %26) #19
  call void @llvm.lifetime.start.p0(i64 3072, ptr nonnull %27) #19
  call void @llvm.lifetime.start.p0(i64 12288, ptr nonnull %28) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %20) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %21) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %22) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %23) #19
  %32 = getelementptr inbounds %struct.Simplex, ptr %2, i64 0, i32 2
  %33 = load i32, ptr %32, align 8
  %34 = icmp slt i32 %33, 2
  br i1 %34, label %379, label %35

35:                                               ; preds = %7
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(96) %26, ptr noundef nonnull align 8 dereferenceable(96) %2, i64 96, i1 false)
  %36 = getelementptr inbounds %struct.Simplex, ptr %2, i64 0, i32 1
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(96) %27, ptr noundef nonnull align 8 dereferenceable(96) %36, i64 96, i1 false)
  %37 = icmp eq i32 %33, 2
  br label %41

38:                                               ; preds = %53
  %39 = icmp eq i32 %33, 4
  %40 = select i1 %39, i64 4, i64 5
  switch i32 %33, label %275 [
    i32 2, label %138
    i32 3, label %196
  ]

41:                                               ; preds = %53, %35
  %42 = phi i64 [ 0, %35 ], [ %56, %53 ]
  %43 = getelementptr inbounds [3 x double], ptr %26, i64 1, i64 %42
  %44 = load double, ptr %43, align 8
  %45 = getelementptr inbounds [3 x double], ptr %26, i64 0, i64 %42
  %46 = load double, ptr %45, align 8
  %47 = fsub double %44, %46
  %48 = getelementptr inbounds [3 x double], ptr %20, i64 0, i64 %42
  store double %47, ptr %48, align 8
  br i1 %37, label %53, label %49

49:                                               ; preds = %41
  %50 = getelementptr inbounds [3 x double], ptr %26, i64 2, i64 %42
  %51 = load double, ptr %50, align 8
  %52 = fsub double %51, %46
  br label %53

53:                                               ; preds = %49, %41
  %54 = phi double [ %52, %49 ], [ 0.000000e+00, %41 ]
  %55 = getelementptr inbounds [3 x double], ptr %21, i64 0, i64 %42
  store double %54, ptr %55, align 8
  %56 = add nuw nsw i64 %42, 1
  %57 = icmp eq i64 %56, 3
  br i1 %57, label %38, label %41

58:                                               ; preds = %138
  %59 = sext i32 %150 to i64
  %60 = getelementptr inbounds [3 x double], ptr %21, i64 0, i64 %59
  store double 1.000000e+00, ptr %60, align 8
  br label %61

61:                                               ; preds = %61, %58
  %62 = phi i64 [ 0, %58 ], [ %63, %61 ]
  %63 = add nuw nsw i64 %62, 1
  %64 = icmp ult i64 %62, 2
  %65 = add nuw nsw i64 %62, 4294967294
  %66 = select i1 %64, i64 %63, i64 %65
  %67 = and i64 %66, 4294967295
  %68 = getelementptr inbounds double, ptr %20, i64 %67
  %69 = load double, ptr %68, align 8
  %70 = icmp eq i64 %62, 0
  %71 = add nuw nsw i64 %62, 4294967295
  %72 = and i64 %71, 4294967295
  %73 = select i1 %70, i64 2, i64 %72
  %74 = getelementptr inbounds double, ptr %21, i64 %73
  %75 = load double, ptr %74, align 8
  %76 = fmul double %69, %75
  %77 = getelementptr inbounds double, ptr %20, i64 %73
  %78 = load double, ptr %77, align 8
  %79 = getelementptr inbounds double, ptr %21, i64 %67
  %80 = load double, ptr %79, align 8
  %81 = fmul double %78, %80
  %82 = fsub double %76, %81
  %83 = getelementptr inbounds double, ptr %22, i64 %62
  store double %82, ptr %83, align 8
  %84 = icmp eq i64 %63, 3
  br i1 %84, label %85, label %61

85:                                               ; preds = %61, %85
  %86 = phi i64 [ %87, %85 ], [ 0, %61 ]
  %87 = add nuw nsw i64 %86, 1
  %88 = icmp ult i64 %86, 2
  %89 = add nuw nsw i64 %86, 4294967294
  %90 = select i1 %88, i64 %87, i64 %89
  %91 = and i64 %90, 4294967295
  %92 = getelementptr inbounds double, ptr %20, i64 %91
  %93 = load double, ptr %92, align 8
  %94 = icmp eq i64 %86, 0
  %95 = add nuw nsw i64 %86, 4294967295
  %96 = and i64 %95, 4294967295
  %97 = select i1 %94, i64 2, i64 %96
  %98 = getelementptr inbounds double, ptr %22, i64 %97
  %99 = load double, ptr %98, align 8
  %100 = fmul double %93, %99
  %101 = getelementptr inbounds double, ptr %20, i64 %97
  %102 = load double, ptr %101, align 8
  %103 = getelementptr inbounds double, ptr %22, i64 %91
  %104 = load double, ptr %103, align 8
  %105 = fmul double %102, %104
  %106 = fsub double %100, %105
  %107 = getelementptr inbounds double, ptr %23, i64 %86
  store double %106, ptr %107, align 8
  %108 = icmp eq i64 %87, 3
  br i1 %108, label %109, label %85

109:                                              ; preds = %85
  %110 = load double, ptr %22, align 16
  %111 = fmul double %110, %110
  %112 = getelementptr inbounds double, ptr %22, i64 1
  %113 = load double, ptr %112, align 8
  %114 = fmul double %113, %113
  %115 = fadd double %111, %114
  %116 = getelementptr inbounds double, ptr %22, i64 2
  %117 = load double, ptr %116, align 16
  %118 = fmul double %117, %117
  %119 = fadd double %115, %118
  %120 = fmul double %119, 7.500000e-01
  %121 = load double, ptr %23, align 16
  %122 = fmul double %121, %121
  %123 = getelementptr inbounds double, ptr %23, i64 1
  %124 = load double, ptr %123, align 8
  %125 = fmul double %124, %124
  %126 = fadd double %122, %125
  %127 = getelementptr inbounds double, ptr %23, i64 2
  %128 = load double, ptr %127, align 16
  %129 = fmul double %128, %128
  %130 = fadd double %126, %129
  %131 = fdiv double %120, %130
  %132 = tail call double @llvm.sqrt.f64(double %131)
  %133 = fneg double %132
  %134 = getelementptr inbounds double, ptr %18, i64 1
  %135 = getelementptr inbounds double, ptr %24, i64 1
  %136 = getelementptr inbounds double, ptr %18, i64 2
  %137 = getelementptr inbounds double, ptr %24, i64 2
  br label %153

138:                                              ; preds = %38, %138
  %139 = phi i64 [ %151, %138 ], [ 1, %38 ]
  %140 = phi i32 [ %150, %138 ], [ 0, %38 ]
  %141 = getelementptr inbounds [3 x double], ptr %20, i64 0, i64 %139
  %142 = load double, ptr %141, align 8
  %143 = tail call double @llvm.fabs.f64(double %142)
  %144 = sext i32 %140 to i64
  %145 = getelementptr inbounds [3 x double], ptr %20, i64 0, i64 %144
  %146 = load double, ptr %145, align 8
  %147 = tail call double @llvm.fabs.f64(double %146)
  %148 = fcmp olt double %143, %147
  %149 = trunc i64 %139 to i32
  %150 = select i1 %148, i32 %149, i32 %140
  %151 = add nuw nsw i64 %139, 1
  %152 = icmp eq i64 %151, 3
  br i1 %152, label %58, label %138

153:                                              ; preds = %178, %109
  %154 = phi i64 [ 0, %109 ], [ %179, %178 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %24) #19
  %155 = icmp eq i64 %154, 0
  %156 = icmp eq i64 %154, 1
  %157 = select i1 %156, double %132, double %133
  br label %181

158:                                              ; preds = %191
  %159 = add nuw nsw i64 %154, 2
  %160 = getelementptr inbounds [3 x double], ptr %26, i64 %159
  %161 = getelementptr inbounds [3 x double], ptr %27, i64 %159
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %18) #19
  %162 = load double, ptr %24, align 16
  %163 = fneg double %162
  store double %163, ptr %18, align 16
  %164 = load double, ptr %135, align 8
  %165 = fneg double %164
  store double %165, ptr %134, align 8
  %166 = load double, ptr %137, align 16
  %167 = fneg double %166
  store double %167, ptr %136, align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %19) #19
  call fastcc void @support(ptr noundef %0, ptr noundef nonnull %24, ptr noundef nonnull %161)
  call fastcc void @support(ptr noundef %1, ptr noundef nonnull %18, ptr noundef nonnull %19)
  br label %168

168:                                              ; preds = %168, %158
  %169 = phi i64 [ 0, %158 ], [ %176, %168 ]
  %170 = getelementptr inbounds double, ptr %161, i64 %169
  %171 = load double, ptr %170, align 8
  %172 = getelementptr inbounds [3 x double], ptr %19, i64 0, i64 %169
  %173 = load double, ptr %172, align 8
  %174 = fsub double %171, %173
  %175 = getelementptr inbounds double, ptr %160, i64 %169
  store double %174, ptr %175, align 8
  %176 = add nuw nsw i64 %169, 1
  %177 = icmp eq i64 %176, 3
  br i1 %177, label %178, label %168

178:                                              ; preds = %168
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %19) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %18) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %24) #19
  %179 = add nuw nsw i64 %154, 1
  %180 = icmp eq i64 %179, 3
  br i1 %180, label %275, label %153

181:                                              ; preds = %191, %153
  %182 = phi i64 [ 0, %153 ], [ %194, %191 ]
  %183 = getelementptr inbounds [3 x double], ptr %22, i64 0, i64 %182
  %184 = load double, ptr %183, align 8
  br i1 %155, label %191, label %185

185:                                              ; preds = %181
  %186 = fmul double %184, 5.000000e-01
  %187 = getelementptr inbounds [3 x double], ptr %23, i64 0, i64 %182
  %188 = load double, ptr %187, align 8
  %189 = fmul double %157, %188
  %190 = fsub double %189, %186
  br label %191

191:                                              ; preds = %185, %181
  %192 = phi double [ %190, %185 ], [ %184, %181 ]
  %193 = getelementptr inbounds [3 x double], ptr %24, i64 0, i64 %182
  store double %192, ptr %193, align 8
  %194 = add nuw nsw i64 %182, 1
  %195 = icmp eq i64 %194, 3
  br i1 %195, label %158, label %181

196:                                              ; preds = %38, %196
  %197 = phi i64 [ %198, %196 ], [ 0, %38 ]
  %198 = add nuw nsw i64 %197, 1
  %199 = icmp ult i64 %197, 2
  %200 = add nuw nsw i64 %197, 4294967294
  %201 = select i1 %199, i64 %198, i64 %200
  %202 = and i64 %201, 4294967295
  %203 = getelementptr inbounds double, ptr %20, i64 %202
  %204 = load double, ptr %203, align 8
  %205 = icmp eq i64 %197, 0
  %206 = add nuw nsw i64 %197, 4294967295
  %207 = and i64 %206, 4294967295
  %208 = select i1 %205, i64 2, i64 %207
  %209 = getelementptr inbounds double, ptr %21, i64 %208
  %210 = load double, ptr %209, align 8
  %211 = fmul double %204, %210
  %212 = getelementptr inbounds double, ptr %20, i64 %208
  %213 = load double, ptr %212, align 8
  %214 = getelementptr inbounds double, ptr %21, i64 %202
  %215 = load double, ptr %214, align 8
  %216 = fmul double %213, %215
  %217 = fsub double %211, %216
  %218 = getelementptr inbounds double, ptr %22, i64 %197
  store double %217, ptr %218, align 8
  %219 = icmp eq i64 %198, 3
  br i1 %219, label %267, label %196

220:                                              ; preds = %267
  %221 = getelementptr inbounds [3 x double], ptr %26, i64 3
  %222 = getelementptr inbounds [3 x double], ptr %27, i64 3
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %16) #19
  %223 = load double, ptr %22, align 16
  %224 = fneg double %223
  store double %224, ptr %16, align 16
  %225 = getelementptr inbounds double, ptr %16, i64 1
  %226 = getelementptr inbounds double, ptr %22, i64 1
  %227 = load double, ptr %226, align 8
  %228 = fneg double %227
  store double %228, ptr %225, align 8
  %229 = getelementptr inbounds double, ptr %16, i64 2
  %230 = getelementptr inbounds double, ptr %22, i64 2
  %231 = load double, ptr %230, align 16
  %232 = fneg double %231
  store double %232, ptr %229, align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %17) #19
  call fastcc void @support(ptr noundef %0, ptr noundef nonnull %22, ptr noundef nonnull %222)
  call fastcc void @support(ptr noundef %1, ptr noundef nonnull %16, ptr noundef nonnull %17)
  br label %233

233:                                              ; preds = %233, %220
  %234 = phi i64 [ 0, %220 ], [ %241, %233 ]
  %235 = getelementptr inbounds double, ptr %222, i64 %234
  %236 = load double, ptr %235, align 8
  %237 = getelementptr inbounds [3 x double], ptr %17, i64 0, i64 %234
  %238 = load double, ptr %237, align 8
  %239 = fsub double %236, %238
  %240 = getelementptr inbounds double, ptr %221, i64 %234
  store double %239, ptr %240, align 8
  %241 = add nuw nsw i64 %234, 1
  %242 = icmp eq i64 %241, 3
  br i1 %242, label %243, label %233

243:                                              ; preds = %233
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %17) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %16) #19
  %244 = getelementptr inbounds [3 x double], ptr %26, i64 4
  %245 = getelementptr inbounds [3 x double], ptr %27, i64 4
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %14) #19
  %246 = load double, ptr %23, align 16
  %247 = fneg double %246
  store double %247, ptr %14, align 16
  %248 = getelementptr inbounds double, ptr %14, i64 1
  %249 = getelementptr inbounds double, ptr %23, i64 1
  %250 = load double, ptr %249, align 8
  %251 = fneg double %250
  store double %251, ptr %248, align 8
  %252 = getelementptr inbounds double, ptr %14, i64 2
  %253 = getelementptr inbounds double, ptr %23, i64 2
  %254 = load double, ptr %253, align 16
  %255 = fneg double %254
  store double %255, ptr %252, align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %15) #19
  call fastcc void @support(ptr noundef %0, ptr noundef nonnull %23, ptr noundef nonnull %245)
  call fastcc void @support(ptr noundef %1, ptr noundef nonnull %14, ptr noundef nonnull %15)
  br label %256

256:                                              ; preds = %256, %243
  %257 = phi i64 [ 0, %243 ], [ %264, %256 ]
  %258 = getelementptr inbounds double, ptr %245, i64 %257
  %259 = load double, ptr %258, align 8
  %260 = getelementptr inbounds [3 x double], ptr %15, i64 0, i64 %257
  %261 = load double, ptr %260, align 8
  %262 = fsub double %259, %261
  %263 = getelementptr inbounds double, ptr %244, i64 %257
  store double %262, ptr %263, align 8
  %264 = add nuw nsw i64 %257, 1
  %265 = icmp eq i64 %264, 3
  br i1 %265, label %266, label %256

266:                                              ; preds = %256
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %15) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %14) #19
  br label %275

267:                                              ; preds = %196, %267
  %268 = phi i64 [ %273, %267 ], [ 0, %196 ]
  %269 = getelementptr inbounds [3 x double], ptr %22, i64 0, i64 %268
  %270 = load double, ptr %269, align 8
  %271 = fneg double %270
  %272 = getelementptr inbounds [3 x double], ptr %23, i64 0, i64 %268
  store double %271, ptr %272, align 8
  %273 = add nuw nsw i64 %268, 1
  %274 = icmp eq i64 %273, 3
  br i1 %274, label %220, label %267

275:                                              ; preds = %178, %266, %38
  %276 = icmp eq i32 %33, 3
  %277 = select i1 %276, ptr @begin.beside, ptr @begin.around
  %278 = select i1 %39, ptr @begin.solid, ptr %277
  %279 = select i1 %39, i32 4, i32 6
  br i1 %39, label %280, label %333

280:                                              ; preds = %275
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %25) #19
  br label %305

281:                                              ; preds = %305, %281
  %282 = phi i64 [ %283, %281 ], [ 0, %305 ]
  %283 = add nuw nsw i64 %282, 1
  %284 = icmp ult i64 %282, 2
  %285 = add nuw nsw i64 %282, 4294967294
  %286 = select i1 %284, i64 %283, i64 %285
  %287 = and i64 %286, 4294967295
  %288 = getelementptr inbounds double, ptr %20, i64 %287
  %289 = load double, ptr %288, align 8
  %290 = icmp eq i64 %282, 0
  %291 = add nuw nsw i64 %282, 4294967295
  %292 = and i64 %291, 4294967295
  %293 = select i1 %290, i64 2, i64 %292
  %294 = getelementptr inbounds double, ptr %21, i64 %293
  %295 = load double, ptr %294, align 8
  %296 = fmul double %289, %295
  %297 = getelementptr inbounds double, ptr %20, i64 %293
  %298 = load double, ptr %297, align 8
  %299 = getelementptr inbounds double, ptr %21, i64 %287
  %300 = load double, ptr %299, align 8
  %301 = fmul double %298, %300
  %302 = fsub double %296, %301
  %303 = getelementptr inbounds double, ptr %22, i64 %282
  store double %302, ptr %303, align 8
  %304 = icmp eq i64 %283, 3
  br i1 %304, label %315, label %281

305:                                              ; preds = %305, %280
  %306 = phi i64 [ 0, %280 ], [ %313, %305 ]
  %307 = getelementptr inbounds [3 x double], ptr %26, i64 3, i64 %306
  %308 = load double, ptr %307, align 8
  %309 = getelementptr inbounds [3 x double], ptr %26, i64 0, i64 %306
  %310 = load double, ptr %309, align 8
  %311 = fsub double %308, %310
  %312 = getelementptr inbounds [3 x double], ptr %25, i64 0, i64 %306
  store double %311, ptr %312, align 8
  %313 = add nuw nsw i64 %306, 1
  %314 = icmp eq i64 %313, 3
  br i1 %314, label %281, label %305

315:                                              ; preds = %281
  %316 = load double, ptr %22, align 16
  %317 = load double, ptr %25, align 16
  %318 = fmul double %316, %317
  %319 = getelementptr inbounds double, ptr %22, i64 1
  %320 = load double, ptr %319, align 8
  %321 = getelementptr inbounds double, ptr %25, i64 1
  %322 = load double, ptr %321, align 8
  %323 = fmul double %320, %322
  %324 = fadd double %318, %323
  %325 = getelementptr inbounds double, ptr %22, i64 2
  %326 = load double, ptr %325, align 16
  %327 = getelementptr inbounds double, ptr %25, i64 2
  %328 = load double, ptr %327, align 16
  %329 = fmul double %326, %328
  %330 = fadd double %324, %329
  %331 = freeze double %330
  %332 = fcmp uge double %331, 0.000000e+00
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %25) #19
  br i1 %332, label %333, label %334

333:                                              ; preds = %315, %275
  br label %334

334:                                              ; preds = %333, %315
  %335 = phi i64 [ 2, %333 ], [ 1, %315 ]
  %336 = phi i64 [ 1, %333 ], [ 2, %315 ]
  %337 = zext i32 %279 to i64
  br label %338

338:                                              ; preds = %376, %334
  %339 = phi i64 [ 0, %334 ], [ %377, %376 ]
  %340 = getelementptr inbounds [3 x i32], ptr %278, i64 %339
  %341 = load i32, ptr %340, align 4
  %342 = getelementptr inbounds [3 x i32], ptr %278, i64 %339, i64 %336
  %343 = load i32, ptr %342, align 4
  %344 = getelementptr inbounds [3 x i32], ptr %278, i64 %339, i64 %335
  %345 = load i32, ptr %344, align 4
  %346 = getelementptr inbounds %struct.Face, ptr %28, i64 %339
  %347 = call fastcc i32 @make_face(ptr noundef nonnull %26, i32 noundef %341, i32 noundef %343, i32 noundef %345, ptr noundef nonnull %346)
  %348 = icmp eq i32 %347, 0
  br i1 %348, label %379, label %349

349:                                              ; preds = %338
  %350 = getelementptr inbounds %struct.Face, ptr %28, i64 %339, i32 1
  %351 = load double, ptr %350, align 16
  %352 = getelementptr inbounds double, ptr %350, i64 1
  %353 = load double, ptr %352, align 8
  %354 = getelementptr inbounds double, ptr %350, i64 2
  %355 = load double, ptr %354, align 16
  %356 = getelementptr inbounds %struct.Face, ptr %28, i64 %339, i32 2
  %357 = load double, ptr %356, align 8
  br label %361

358:                                              ; preds = %361
  %359 = add nuw nsw i64 %362, 1
  %360 = icmp eq i64 %359, %40
  br i1 %360, label %376, label %361

361:                                              ; preds = %358, %349
  %362 = phi i64 [ 0, %349 ], [ %359, %358 ]
  %363 = getelementptr inbounds [3 x double], ptr %26, i64 %362
  %364 = load double, ptr %363, align 8
  %365 = fmul double %351, %364
  %366 = getelementptr inbounds double, ptr %363, i64 1
  %367 = load double, ptr %366, align 8
  %368 = fmul double %353, %367
  %369 = fadd double %365, %368
  %370 = getelementptr inbounds double, ptr %363, i64 2
  %371 = load double, ptr %370, align 8
  %372 = fmul double %355, %371
  %373 = fadd double %369, %372
  %374 = fsub double %373, %357
  %375 = fcmp ogt double %374, 1.000000e-13
  br i1 %375, label %379, label %358

376:                                              ; preds = %358
  %377 = add nuw nsw i64 %339, 1
  %378 = icmp eq i64 %377, %337
  br i1 %378, label %380, label %338

379:                                              ; preds = %338, %361, %7
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %23) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %22) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %21) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %20) #19
  br label %748

380:                                              ; preds = %376
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %23) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %22) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %21) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %20) #19
  %381 = getelementptr inbounds double, ptr %12, i64 1
  %382 = getelementptr inbounds double, ptr %12, i64 2
  %383 = getelementptr inbounds double, ptr %29, i64 1
  %384 = getelementptr inbounds double, ptr %29, i64 2
  br label %385

385:                                              ; preds = %380, %746
  %386 = phi i64 [ %40, %380 ], [ %460, %746 ]
  %387 = phi i32 [ %279, %380 ], [ %558, %746 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %29) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %30) #19
  %388 = icmp sgt i32 %387, 1
  br i1 %388, label %389, label %391

389:                                              ; preds = %385
  %390 = zext i32 %387 to i64
  br label %414

391:                                              ; preds = %414, %385
  %392 = phi i32 [ 0, %385 ], [ %424, %414 ]
  %393 = sext i32 %392 to i64
  %394 = getelementptr inbounds %struct.Face, ptr %28, i64 %393, i32 1
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %12) #19
  %395 = load double, ptr %394, align 16
  %396 = fneg double %395
  store double %396, ptr %12, align 16
  %397 = getelementptr inbounds double, ptr %394, i64 1
  %398 = load double, ptr %397, align 8
  %399 = fneg double %398
  store double %399, ptr %381, align 8
  %400 = getelementptr inbounds double, ptr %394, i64 2
  %401 = load double, ptr %400, align 16
  %402 = fneg double %401
  store double %402, ptr %382, align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %13) #19
  call fastcc void @support(ptr noundef %0, ptr noundef nonnull %394, ptr noundef nonnull %30)
  call fastcc void @support(ptr noundef %1, ptr noundef nonnull %12, ptr noundef nonnull %13)
  br label %403

403:                                              ; preds = %403, %391
  %404 = phi i64 [ 0, %391 ], [ %411, %403 ]
  %405 = getelementptr inbounds double, ptr %30, i64 %404
  %406 = load double, ptr %405, align 8
  %407 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %404
  %408 = load double, ptr %407, align 8
  %409 = fsub double %406, %408
  %410 = getelementptr inbounds double, ptr %29, i64 %404
  store double %409, ptr %410, align 8
  %411 = add nuw nsw i64 %404, 1
  %412 = icmp eq i64 %411, 3
  br i1 %412, label %413, label %403

413:                                              ; preds = %403
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %13) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %12) #19
  br label %432

414:                                              ; preds = %389, %414
  %415 = phi i64 [ 1, %389 ], [ %425, %414 ]
  %416 = phi i32 [ 0, %389 ], [ %424, %414 ]
  %417 = getelementptr inbounds [256 x %struct.Face], ptr %28, i64 0, i64 %415, i32 2
  %418 = load double, ptr %417, align 8
  %419 = sext i32 %416 to i64
  %420 = getelementptr inbounds [256 x %struct.Face], ptr %28, i64 0, i64 %419, i32 2
  %421 = load double, ptr %420, align 8
  %422 = fcmp olt double %418, %421
  %423 = trunc i64 %415 to i32
  %424 = select i1 %422, i32 %423, i32 %416
  %425 = add nuw nsw i64 %415, 1
  %426 = icmp eq i64 %425, %390
  br i1 %426, label %391, label %414

427:                                              ; preds = %432
  %428 = icmp eq i32 %439, 0
  br i1 %428, label %442, label %429

429:                                              ; preds = %427
  %430 = getelementptr inbounds %struct.Face, ptr %28, i64 %393, i32 2
  %431 = load double, ptr %430, align 8
  br label %579

432:                                              ; preds = %413, %432
  %433 = phi i64 [ 0, %413 ], [ %440, %432 ]
  %434 = phi i32 [ 0, %413 ], [ %439, %432 ]
  %435 = getelementptr inbounds [128 x [3 x double]], ptr %26, i64 0, i64 %433
  %436 = call i32 @bcmp(ptr noundef nonnull dereferenceable(24) %435, ptr noundef nonnull dereferenceable(24) %29, i64 24)
  %437 = icmp eq i32 %436, 0
  %438 = zext i1 %437 to i32
  %439 = or i32 %434, %438
  %440 = add nuw nsw i64 %433, 1
  %441 = icmp eq i64 %440, %386
  br i1 %441, label %427, label %432

442:                                              ; preds = %427
  %443 = load double, ptr %29, align 16
  %444 = fmul double %395, %443
  %445 = load double, ptr %383, align 8
  %446 = fmul double %398, %445
  %447 = fadd double %444, %446
  %448 = load double, ptr %384, align 16
  %449 = fmul double %401, %448
  %450 = fadd double %447, %449
  %451 = getelementptr inbounds %struct.Face, ptr %28, i64 %393, i32 2
  %452 = load double, ptr %451, align 8
  %453 = fsub double %450, %452
  %454 = fcmp ogt double %453, 1.000000e-10
  br i1 %454, label %455, label %579

455:                                              ; preds = %442
  %456 = icmp eq i64 %386, 128
  br i1 %456, label %743, label %457

457:                                              ; preds = %455
  %458 = getelementptr inbounds [128 x [3 x double]], ptr %26, i64 0, i64 %386
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %458, ptr noundef nonnull align 16 dereferenceable(24) %29, i64 24, i1 false)
  %459 = getelementptr inbounds [128 x [3 x double]], ptr %27, i64 0, i64 %386
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %459, ptr noundef nonnull align 16 dereferenceable(24) %30, i64 24, i1 false)
  %460 = add nuw nsw i64 %386, 1
  call void @llvm.lifetime.start.p0(i64 3072, ptr nonnull %11) #19
  %461 = icmp sgt i32 %387, 0
  br i1 %461, label %462, label %745

462:                                              ; preds = %457
  %463 = getelementptr inbounds double, ptr %458, i64 1
  %464 = getelementptr inbounds double, ptr %458, i64 2
  %465 = zext i32 %387 to i64
  %466 = load double, ptr %458, align 8
  %467 = load double, ptr %463, align 8
  %468 = load double, ptr %464, align 8
  br label %469

469:                                              ; preds = %547, %462
  %470 = phi i64 [ 0, %462 ], [ %550, %547 ]
  %471 = phi i1 [ true, %462 ], [ %551, %547 ]
  %472 = phi i32 [ 0, %462 ], [ %549, %547 ]
  %473 = phi i32 [ 0, %462 ], [ %548, %547 ]
  %474 = getelementptr inbounds %struct.Face, ptr %28, i64 %470
  %475 = getelementptr inbounds %struct.Face, ptr %28, i64 %470, i32 1
  %476 = load double, ptr %475, align 16
  %477 = fmul double %476, %466
  %478 = getelementptr inbounds double, ptr %475, i64 1
  %479 = load double, ptr %478, align 8
  %480 = fmul double %479, %467
  %481 = fadd double %477, %480
  %482 = getelementptr inbounds double, ptr %475, i64 2
  %483 = load double, ptr %482, align 16
  %484 = fmul double %483, %468
  %485 = fadd double %481, %484
  %486 = getelementptr inbounds %struct.Face, ptr %28, i64 %470, i32 2
  %487 = load double, ptr %486, align 8
  %488 = fsub double %485, %487
  %489 = fcmp olt double %488, -1.000000e-13
  br i1 %489, label %490, label %494

490:                                              ; preds = %469
  %491 = add nsw i32 %473, 1
  %492 = sext i32 %473 to i64
  %493 = getelementptr inbounds %struct.Face, ptr %28, i64 %492
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(48) %493, ptr noundef nonnull align 16 dereferenceable(48) %474, i64 48, i1 false)
  br label %547

494:                                              ; preds = %469, %542
  %495 = phi i64 [ %501, %542 ], [ 0, %469 ]
  %496 = phi i1 [ %544, %542 ], [ false, %469 ]
  %497 = phi i32 [ %543, %542 ], [ %472, %469 ]
  %498 = phi i32 [ %502, %542 ], [ 0, %469 ]
  %499 = getelementptr inbounds [3 x i32], ptr %474, i64 0, i64 %495
  %500 = load i32, ptr %499, align 4
  %501 = add nuw nsw i64 %495, 1
  %502 = add nuw nsw i32 %498, 1
  %503 = icmp ult i64 %495, 2
  %504 = trunc i64 %495 to i32
  %505 = add i32 %504, -2
  %506 = select i1 %503, i32 %502, i32 %505
  %507 = zext i32 %506 to i64
  %508 = getelementptr inbounds [3 x i32], ptr %474, i64 0, i64 %507
  %509 = load i32, ptr %508, align 4
  %510 = icmp sgt i32 %497, 0
  br i1 %510, label %511, label %537

511:                                              ; preds = %494
  %512 = zext i32 %497 to i64
  br label %513

513:                                              ; preds = %522, %511
  %514 = phi i64 [ 0, %511 ], [ %523, %522 ]
  %515 = getelementptr inbounds [384 x [2 x i32]], ptr %11, i64 0, i64 %514
  %516 = load i32, ptr %515, align 8
  %517 = icmp eq i32 %516, %509
  br i1 %517, label %518, label %522

518:                                              ; preds = %513
  %519 = getelementptr inbounds [384 x [2 x i32]], ptr %11, i64 0, i64 %514, i64 1
  %520 = load i32, ptr %519, align 4
  %521 = icmp eq i32 %520, %500
  br i1 %521, label %525, label %522

522:                                              ; preds = %518, %513
  %523 = add nuw nsw i64 %514, 1
  %524 = icmp eq i64 %523, %512
  br i1 %524, label %535, label %513

525:                                              ; preds = %518
  %526 = and i64 %514, 4294967295
  %527 = getelementptr inbounds [384 x [2 x i32]], ptr %11, i64 0, i64 %526
  %528 = getelementptr inbounds [384 x [2 x i32]], ptr %11, i64 0, i64 %526, i64 1
  %529 = add nsw i32 %497, -1
  %530 = sext i32 %529 to i64
  %531 = getelementptr inbounds [384 x [2 x i32]], ptr %11, i64 0, i64 %530
  %532 = load i32, ptr %531, align 8
  store i32 %532, ptr %527, align 8
  %533 = getelementptr inbounds [384 x [2 x i32]], ptr %11, i64 0, i64 %530, i64 1
  %534 = load i32, ptr %533, align 4
  store i32 %534, ptr %528, align 4
  br label %542

535:                                              ; preds = %522
  %536 = icmp eq i32 %497, 384
  br i1 %536, label %546, label %537

537:                                              ; preds = %535, %494
  %538 = sext i32 %497 to i64
  %539 = getelementptr inbounds [384 x [2 x i32]], ptr %11, i64 0, i64 %538
  store i32 %500, ptr %539, align 8
  %540 = getelementptr inbounds [384 x [2 x i32]], ptr %11, i64 0, i64 %538, i64 1
  store i32 %509, ptr %540, align 4
  %541 = add nsw i32 %497, 1
  br label %542

542:                                              ; preds = %537, %525
  %543 = phi i32 [ %529, %525 ], [ %541, %537 ]
  %544 = icmp ugt i64 %495, 1
  %545 = icmp eq i64 %501, 3
  br i1 %545, label %547, label %494

546:                                              ; preds = %535
  br i1 %496, label %547, label %553

547:                                              ; preds = %542, %546, %490
  %548 = phi i32 [ %491, %490 ], [ %473, %546 ], [ %473, %542 ]
  %549 = phi i32 [ %472, %490 ], [ 384, %546 ], [ %543, %542 ]
  %550 = add nuw nsw i64 %470, 1
  %551 = icmp ult i64 %550, %465
  %552 = icmp eq i64 %550, %465
  br i1 %552, label %554, label %469

553:                                              ; preds = %546
  br i1 %471, label %745, label %554

554:                                              ; preds = %547, %553
  %555 = phi i32 [ %473, %553 ], [ %548, %547 ]
  %556 = phi i32 [ 384, %553 ], [ %549, %547 ]
  %557 = icmp slt i32 %556, 3
  %558 = add i32 %556, %555
  %559 = icmp sgt i32 %558, 256
  %560 = select i1 %557, i1 true, i1 %559
  br i1 %560, label %745, label %561

561:                                              ; preds = %554
  %562 = sext i32 %555 to i64
  %563 = zext i32 %556 to i64
  %564 = trunc i64 %386 to i32
  br label %565

565:                                              ; preds = %575, %561
  %566 = phi i64 [ %562, %561 ], [ %576, %575 ]
  %567 = phi i64 [ 0, %561 ], [ %577, %575 ]
  %568 = getelementptr inbounds [384 x [2 x i32]], ptr %11, i64 0, i64 %567
  %569 = load i32, ptr %568, align 8
  %570 = getelementptr inbounds [384 x [2 x i32]], ptr %11, i64 0, i64 %567, i64 1
  %571 = load i32, ptr %570, align 4
  %572 = getelementptr inbounds %struct.Face, ptr %28, i64 %566
  %573 = call fastcc i32 @make_face(ptr noundef nonnull %26, i32 noundef %569, i32 noundef %571, i32 noundef %564, ptr noundef nonnull %572)
  %574 = icmp eq i32 %573, 0
  br i1 %574, label %745, label %575

575:                                              ; preds = %565
  %576 = add nsw i64 %566, 1
  %577 = add nuw nsw i64 %567, 1
  %578 = icmp eq i64 %577, %563
  br i1 %578, label %746, label %565

579:                                              ; preds = %442, %429
  %580 = phi double [ %431, %429 ], [ %452, %442 ]
  %581 = getelementptr inbounds %struct.Face, ptr %28, i64 %393
  store double %580, ptr %3, align 8
  %582 = icmp eq ptr %4, null
  br i1 %582, label %743, label %583

583:                                              ; preds = %579
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %31) #19
  %584 = icmp sgt i32 %387, 0
  br i1 %584, label %585, label %597

585:                                              ; preds = %583
  %586 = fadd double %580, 1.000000e-13
  %587 = getelementptr inbounds double, ptr %8, i64 1
  %588 = getelementptr inbounds double, ptr %8, i64 2
  %589 = getelementptr inbounds double, ptr %9, i64 1
  %590 = getelementptr inbounds double, ptr %9, i64 2
  %591 = getelementptr inbounds double, ptr %10, i64 1
  %592 = getelementptr inbounds double, ptr %10, i64 2
  %593 = getelementptr inbounds i8, ptr %31, i64 8
  %594 = getelementptr inbounds i8, ptr %31, i64 16
  %595 = zext i32 %387 to i64
  br label %600

596:                                              ; preds = %705
  store double %707, ptr %593, align 8
  store double %706, ptr %594, align 16
  br label %597

597:                                              ; preds = %596, %583
  %598 = phi double [ %708, %596 ], [ undef, %583 ]
  %599 = phi ptr [ %709, %596 ], [ %581, %583 ]
  store double %598, ptr %31, align 16
  br label %714

600:                                              ; preds = %585, %705
  %601 = phi i64 [ 0, %585 ], [ %711, %705 ]
  %602 = phi double [ undef, %585 ], [ %706, %705 ]
  %603 = phi double [ undef, %585 ], [ %707, %705 ]
  %604 = phi double [ 0xFFF0000000000000, %585 ], [ %710, %705 ]
  %605 = phi ptr [ %581, %585 ], [ %709, %705 ]
  %606 = phi double [ undef, %585 ], [ %708, %705 ]
  %607 = getelementptr inbounds [256 x %struct.Face], ptr %28, i64 0, i64 %601, i32 2
  %608 = load double, ptr %607, align 8
  %609 = fcmp ogt double %608, %586
  br i1 %609, label %705, label %610

610:                                              ; preds = %600
  %611 = getelementptr inbounds [256 x %struct.Face], ptr %28, i64 0, i64 %601, i32 1
  %612 = load double, ptr %611, align 16
  %613 = fmul double %612, %395
  %614 = getelementptr inbounds double, ptr %611, i64 1
  %615 = load double, ptr %614, align 8
  %616 = fmul double %615, %398
  %617 = fadd double %613, %616
  %618 = getelementptr inbounds double, ptr %611, i64 2
  %619 = load double, ptr %618, align 16
  %620 = fmul double %619, %401
  %621 = fadd double %617, %620
  %622 = fcmp olt double %621, 0x3FEFFFFFFFFFFC7B
  br i1 %622, label %705, label %623

623:                                              ; preds = %610
  %624 = getelementptr inbounds %struct.Face, ptr %28, i64 %601
  %625 = load i32, ptr %624, align 16
  %626 = sext i32 %625 to i64
  %627 = getelementptr inbounds [3 x double], ptr %26, i64 %626
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %10) #19
  %628 = getelementptr inbounds [3 x i32], ptr %624, i64 0, i64 1
  %629 = load i32, ptr %628, align 4
  %630 = sext i32 %629 to i64
  %631 = getelementptr inbounds [3 x i32], ptr %624, i64 0, i64 2
  %632 = load i32, ptr %631, align 8
  %633 = sext i32 %632 to i64
  br label %634

634:                                              ; preds = %634, %623
  %635 = phi i64 [ 0, %623 ], [ %651, %634 ]
  %636 = getelementptr inbounds [3 x double], ptr %26, i64 %630, i64 %635
  %637 = load double, ptr %636, align 8
  %638 = getelementptr inbounds double, ptr %627, i64 %635
  %639 = load double, ptr %638, align 8
  %640 = fsub double %637, %639
  %641 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %635
  store double %640, ptr %641, align 8
  %642 = getelementptr inbounds [3 x double], ptr %26, i64 %633, i64 %635
  %643 = load double, ptr %642, align 8
  %644 = fsub double %643, %639
  %645 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %635
  store double %644, ptr %645, align 8
  %646 = getelementptr inbounds %struct.Face, ptr %28, i64 %601, i32 1, i64 %635
  %647 = load double, ptr %646, align 8
  %648 = fmul double %608, %647
  %649 = fsub double %648, %639
  %650 = getelementptr inbounds [3 x double], ptr %10, i64 0, i64 %635
  store double %649, ptr %650, align 8
  %651 = add nuw nsw i64 %635, 1
  %652 = icmp eq i64 %651, 3
  br i1 %652, label %653, label %634

653:                                              ; preds = %634
  %654 = load double, ptr %8, align 16
  %655 = fmul double %654, %654
  %656 = load double, ptr %587, align 8
  %657 = fmul double %656, %656
  %658 = fadd double %655, %657
  %659 = load double, ptr %588, align 16
  %660 = fmul double %659, %659
  %661 = fadd double %658, %660
  %662 = load double, ptr %9, align 16
  %663 = fmul double %654, %662
  %664 = load double, ptr %589, align 8
  %665 = fmul double %656, %664
  %666 = fadd double %663, %665
  %667 = load double, ptr %590, align 16
  %668 = fmul double %659, %667
  %669 = fadd double %666, %668
  %670 = fmul double %662, %662
  %671 = fmul double %664, %664
  %672 = fadd double %670, %671
  %673 = fmul double %667, %667
  %674 = fadd double %672, %673
  %675 = fmul double %661, %674
  %676 = fmul double %669, %669
  %677 = fsub double %675, %676
  %678 = load double, ptr %10, align 16
  %679 = fmul double %654, %678
  %680 = load double, ptr %591, align 8
  %681 = fmul double %656, %680
  %682 = fadd double %679, %681
  %683 = load double, ptr %592, align 16
  %684 = fmul double %659, %683
  %685 = fadd double %682, %684
  %686 = fmul double %674, %685
  %687 = fmul double %662, %678
  %688 = fmul double %664, %680
  %689 = fadd double %687, %688
  %690 = fmul double %667, %683
  %691 = fadd double %689, %690
  %692 = fmul double %669, %691
  %693 = fsub double %686, %692
  %694 = fdiv double %693, %677
  %695 = fmul double %661, %691
  %696 = fmul double %669, %685
  %697 = fsub double %695, %696
  %698 = fdiv double %697, %677
  %699 = fsub double 1.000000e+00, %694
  %700 = fsub double %699, %698
  %701 = tail call double @llvm.minnum.f64(double %694, double %698)
  %702 = tail call double @llvm.minnum.f64(double %700, double %701)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %10) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  %703 = fcmp ogt double %702, %604
  br i1 %703, label %704, label %705

704:                                              ; preds = %653
  br label %705

705:                                              ; preds = %653, %704, %600, %610
  %706 = phi double [ %602, %600 ], [ %602, %610 ], [ %698, %704 ], [ %602, %653 ]
  %707 = phi double [ %603, %600 ], [ %603, %610 ], [ %694, %704 ], [ %603, %653 ]
  %708 = phi double [ %606, %600 ], [ %606, %610 ], [ %700, %704 ], [ %606, %653 ]
  %709 = phi ptr [ %605, %600 ], [ %605, %610 ], [ %624, %704 ], [ %605, %653 ]
  %710 = phi double [ %604, %600 ], [ %604, %610 ], [ %702, %704 ], [ %604, %653 ]
  %711 = add nuw nsw i64 %601, 1
  %712 = icmp eq i64 %711, %595
  br i1 %712, label %596, label %600

713:                                              ; preds = %721
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %31) #19
  br label %743

714:                                              ; preds = %597, %721
  %715 = phi i64 [ 0, %597 ], [ %727, %721 ]
  %716 = getelementptr inbounds [256 x %struct.Face], ptr %28, i64 0, i64 %393, i32 1, i64 %715
  %717 = load double, ptr %716, align 8
  %718 = fneg double %717
  %719 = getelementptr inbounds double, ptr %4, i64 %715
  store double %718, ptr %719, align 8
  %720 = getelementptr inbounds double, ptr %5, i64 %715
  br label %729

721:                                              ; preds = %729
  store double %740, ptr %720, align 8
  %722 = load double, ptr %3, align 8
  %723 = load double, ptr %719, align 8
  %724 = fmul double %722, %723
  %725 = fadd double %740, %724
  %726 = getelementptr inbounds double, ptr %6, i64 %715
  store double %725, ptr %726, align 8
  %727 = add nuw nsw i64 %715, 1
  %728 = icmp eq i64 %727, 3
  br i1 %728, label %713, label %714

729:                                              ; preds = %714, %729
  %730 = phi i64 [ 0, %714 ], [ %741, %729 ]
  %731 = phi double [ 0.000000e+00, %714 ], [ %740, %729 ]
  %732 = getelementptr inbounds [3 x double], ptr %31, i64 0, i64 %730
  %733 = load double, ptr %732, align 8
  %734 = getelementptr inbounds [3 x i32], ptr %599, i64 0, i64 %730
  %735 = load i32, ptr %734, align 4
  %736 = sext i32 %735 to i64
  %737 = getelementptr inbounds [128 x [3 x double]], ptr %27, i64 0, i64 %736, i64 %715
  %738 = load double, ptr %737, align 8
  %739 = fmul double %733, %738
  %740 = fadd double %731, %739
  %741 = add nuw nsw i64 %730, 1
  %742 = icmp eq i64 %741, 3
  br i1 %742, label %721, label %729

743:                                              ; preds = %455, %713, %579
  %744 = phi i32 [ 1, %579 ], [ 1, %713 ], [ 0, %455 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %30) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %29) #19
  br label %748

745:                                              ; preds = %553, %554, %457, %565
  call void @llvm.lifetime.end.p0(i64 3072, ptr nonnull %11) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %30) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %29) #19
  br label %748

746:                                              ; preds = %575
  call void @llvm.lifetime.end.p0(i64 3072, ptr nonnull %11) #19
  %747 = icmp eq i32 %558, 0
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %30) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %29) #19
  br i1 %747, label %748, label %385

748:                                              ; preds = %746, %745, %743, %379
  %749 = phi i32 [ 0, %379 ], [ %744, %743 ], [ 0, %745 ], [ 0, %746 ]
  call void @llvm.lifetime.end.p0(i64 12288, ptr nonnull %28) #19
  call void @llvm.lifetime.end.p0(i64 3072, ptr nonnull %27) #19
  call void @llvm.lifetime.end.p0(i64 3072, ptr nonnull %26) #19
  ret i32 %749
}

declare double @llvm.minnum.f64(double, double) #4

define internal fastcc void @look_at_surfaces(ptr noundef %0, i64 noundef %1, ptr noundef %2) unnamed_addr #0 {
  %4 = alloca %struct.Part, align 8
  %5 = alloca %struct.Part, align 8
  %6 = load ptr, ptr %0, align 8
  %7 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %8 = load i64, ptr %7, align 8
  store ptr %0, ptr %2, align 8
  %9 = getelementptr inbounds %struct.Two, ptr %2, i64 0, i32 1
  store i64 %1, ptr %9, align 8
  %10 = getelementptr inbounds %struct.World, ptr %6, i64 0, i32 15
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds double, ptr %11, i64 %8
  %13 = load double, ptr %12, align 8
  %14 = getelementptr inbounds double, ptr %11, i64 %1
  %15 = load double, ptr %14, align 8
  %16 = fadd double %13, %15
  %17 = getelementptr inbounds %struct.Two, ptr %2, i64 0, i32 4
  store double %16, ptr %17, align 8
  %18 = getelementptr inbounds %struct.World, ptr %6, i64 0, i32 42
  %19 = load ptr, ptr %18, align 8
  %20 = getelementptr inbounds %struct.World, ptr %6, i64 0, i32 11
  %21 = load ptr, ptr %20, align 8
  %22 = getelementptr inbounds i64, ptr %21, i64 %1
  %23 = load i64, ptr %22, align 8
  %24 = mul nsw i64 %23, 12
  %25 = getelementptr inbounds double, ptr %19, i64 %24
  %26 = getelementptr inbounds i64, ptr %21, i64 %8
  %27 = load i64, ptr %26, align 8
  %28 = mul nsw i64 %27, 12
  %29 = getelementptr inbounds double, ptr %19, i64 %28
  %30 = getelementptr inbounds %struct.Two, ptr %2, i64 0, i32 2
  br label %31

31:                                               ; preds = %74, %3
  %32 = phi i64 [ 0, %3 ], [ %75, %74 ]
  %33 = getelementptr inbounds double, ptr %25, i64 %32
  %34 = add nuw nsw i64 %32, 3
  %35 = getelementptr inbounds double, ptr %25, i64 %34
  %36 = add nuw nsw i64 %32, 6
  %37 = getelementptr inbounds double, ptr %25, i64 %36
  %38 = mul nuw nsw i64 %32, 3
  br label %77

39:                                               ; preds = %74
  %40 = getelementptr inbounds double, ptr %29, i64 9
  %41 = getelementptr inbounds %struct.Two, ptr %2, i64 0, i32 2, i64 9
  %42 = load double, ptr %40, align 8
  %43 = getelementptr inbounds double, ptr %25, i64 9
  %44 = load double, ptr %43, align 8
  %45 = fsub double %42, %44
  %46 = getelementptr inbounds double, ptr %29, i64 10
  %47 = load double, ptr %46, align 8
  %48 = getelementptr inbounds double, ptr %25, i64 10
  %49 = load double, ptr %48, align 8
  %50 = fsub double %47, %49
  %51 = getelementptr inbounds double, ptr %29, i64 11
  %52 = load double, ptr %51, align 8
  %53 = getelementptr inbounds double, ptr %25, i64 11
  %54 = load double, ptr %53, align 8
  %55 = fsub double %52, %54
  br label %56

56:                                               ; preds = %56, %39
  %57 = phi i64 [ 0, %39 ], [ %72, %56 ]
  %58 = getelementptr inbounds double, ptr %25, i64 %57
  %59 = load double, ptr %58, align 8
  %60 = fmul double %45, %59
  %61 = add nuw nsw i64 %57, 3
  %62 = getelementptr inbounds double, ptr %25, i64 %61
  %63 = load double, ptr %62, align 8
  %64 = fmul double %50, %63
  %65 = fadd double %60, %64
  %66 = add nuw nsw i64 %57, 6
  %67 = getelementptr inbounds double, ptr %25, i64 %66
  %68 = load double, ptr %67, align 8
  %69 = fmul double %55, %68
  %70 = fadd double %65, %69
  %71 = getelementptr inbounds double, ptr %41, i64 %57
  store double %70, ptr %71, align 8
  %72 = add nuw nsw i64 %57, 1
  %73 = icmp eq i64 %72, 3
  br i1 %73, label %103, label %56

74:                                               ; preds = %77
  %75 = add nuw nsw i64 %32, 1
  %76 = icmp eq i64 %75, 3
  br i1 %76, label %39, label %31

77:                                               ; preds = %77, %31
  %78 = phi i64 [ 0, %31 ], [ %97, %77 ]
  %79 = load double, ptr %33, align 8
  %80 = getelementptr inbounds double, ptr %29, i64 %78
  %81 = load double, ptr %80, align 8
  %82 = fmul double %79, %81
  %83 = load double, ptr %35, align 8
  %84 = add nuw nsw i64 %78, 3
  %85 = getelementptr inbounds double, ptr %29, i64 %84
  %86 = load double, ptr %85, align 8
  %87 = fmul double %83, %86
  %88 = fadd double %82, %87
  %89 = load double, ptr %37, align 8
  %90 = add nuw nsw i64 %78, 6
  %91 = getelementptr inbounds double, ptr %29, i64 %90
  %92 = load double, ptr %91, align 8
  %93 = fmul double %89, %92
  %94 = fadd double %88, %93
  %95 = add nuw nsw i64 %78, %38
  %96 = getelementptr inbounds double, ptr %30, i64 %95
  store double %94, ptr %96, align 8
  %97 = add nuw nsw i64 %78, 1
  %98 = icmp eq i64 %97, 3
  br i1 %98, label %74, label %77

99:                                               ; preds = %103
  %100 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  %101 = load ptr, ptr %100, align 8
  %102 = icmp eq ptr %101, null
  br i1 %102, label %121, label %111

103:                                              ; preds = %56, %103
  %104 = phi i64 [ %109, %103 ], [ 0, %56 ]
  %105 = getelementptr inbounds %struct.Two, ptr %2, i64 0, i32 2, i64 %104
  %106 = load double, ptr %105, align 8
  %107 = tail call double @llvm.fabs.f64(double %106)
  %108 = getelementptr inbounds %struct.Two, ptr %2, i64 0, i32 3, i64 %104
  store double %107, ptr %108, align 8
  %109 = add nuw nsw i64 %104, 1
  %110 = icmp eq i64 %109, 9
  br i1 %110, label %99, label %103

111:                                              ; preds = %99
  %112 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %113 = load ptr, ptr %112, align 8
  %114 = icmp eq ptr %113, null
  %115 = getelementptr inbounds i64, ptr %113, i64 %1
  %116 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %117 = select i1 %114, ptr %116, ptr %115
  %118 = load i64, ptr %117, align 8
  %119 = mul nsw i64 %118, 22
  %120 = getelementptr inbounds double, ptr %101, i64 %119
  br label %121

121:                                              ; preds = %99, %111
  %122 = phi ptr [ %120, %111 ], [ null, %99 ]
  %123 = getelementptr inbounds %struct.World, ptr %6, i64 0, i32 43
  %124 = load ptr, ptr %123, align 8
  %125 = mul nsw i64 %8, 3
  %126 = getelementptr inbounds double, ptr %124, i64 %125
  %127 = getelementptr inbounds %struct.Two, ptr %2, i64 0, i32 5
  %128 = load double, ptr %126, align 8
  %129 = load double, ptr %43, align 8
  %130 = fsub double %128, %129
  %131 = getelementptr inbounds double, ptr %126, i64 1
  %132 = load double, ptr %131, align 8
  %133 = load double, ptr %48, align 8
  %134 = fsub double %132, %133
  %135 = getelementptr inbounds double, ptr %126, i64 2
  %136 = load double, ptr %135, align 8
  %137 = load double, ptr %53, align 8
  %138 = fsub double %136, %137
  br label %139

139:                                              ; preds = %139, %121
  %140 = phi i64 [ 0, %121 ], [ %155, %139 ]
  %141 = getelementptr inbounds double, ptr %25, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = fmul double %130, %142
  %144 = add nuw nsw i64 %140, 3
  %145 = getelementptr inbounds double, ptr %25, i64 %144
  %146 = load double, ptr %145, align 8
  %147 = fmul double %134, %146
  %148 = fadd double %143, %147
  %149 = add nuw nsw i64 %140, 6
  %150 = getelementptr inbounds double, ptr %25, i64 %149
  %151 = load double, ptr %150, align 8
  %152 = fmul double %138, %151
  %153 = fadd double %148, %152
  %154 = getelementptr inbounds double, ptr %127, i64 %140
  store double %153, ptr %154, align 8
  %155 = add nuw nsw i64 %140, 1
  %156 = icmp eq i64 %155, 3
  br i1 %156, label %157, label %139

157:                                              ; preds = %139
  %158 = getelementptr inbounds %struct.World, ptr %6, i64 0, i32 18
  %159 = load ptr, ptr %158, align 8
  %160 = shl nsw i64 %1, 2
  br label %163

161:                                              ; preds = %163
  %162 = icmp eq ptr %122, null
  br i1 %162, label %215, label %173

163:                                              ; preds = %157, %163
  %164 = phi i64 [ 0, %157 ], [ %171, %163 ]
  %165 = add nuw nsw i64 %160, %164
  %166 = getelementptr inbounds double, ptr %159, i64 %165
  %167 = load double, ptr %166, align 8
  %168 = getelementptr inbounds %struct.Two, ptr %2, i64 0, i32 5, i64 %164
  %169 = load double, ptr %168, align 8
  %170 = fsub double %169, %167
  store double %170, ptr %168, align 8
  %171 = add nuw nsw i64 %164, 1
  %172 = icmp eq i64 %171, 3
  br i1 %172, label %161, label %163

173:                                              ; preds = %161
  %174 = load double, ptr %122, align 8
  %175 = fcmp ogt double %174, 0.000000e+00
  br i1 %175, label %176, label %183

176:                                              ; preds = %173
  %177 = fptosi double %174 to i64
  %178 = add nsw i64 %177, -1
  %179 = getelementptr inbounds double, ptr %122, i64 1
  %180 = load double, ptr %179, align 8
  %181 = fptosi double %180 to i64
  %182 = add nsw i64 %181, -1
  tail call fastcc void @two_leaves(ptr noundef nonnull %2, i64 noundef %178, i64 noundef %182)
  br label %183

183:                                              ; preds = %173, %176
  %184 = getelementptr inbounds %struct.World, ptr %6, i64 0, i32 35
  %185 = load ptr, ptr %184, align 8
  %186 = getelementptr inbounds i64, ptr %185, i64 %8
  %187 = load i64, ptr %186, align 8
  store i64 %187, ptr %4, align 8
  %188 = getelementptr inbounds %struct.Part, ptr %4, i64 0, i32 1
  %189 = getelementptr inbounds %struct.World, ptr %6, i64 0, i32 13
  %190 = load ptr, ptr %189, align 8
  %191 = getelementptr inbounds i64, ptr %190, i64 %8
  %192 = load i64, ptr %191, align 8
  store i64 %192, ptr %188, align 8
  %193 = getelementptr inbounds %struct.Part, ptr %4, i64 0, i32 2
  %194 = getelementptr inbounds %struct.World, ptr %6, i64 0, i32 14
  %195 = load ptr, ptr %194, align 8
  %196 = getelementptr inbounds i64, ptr %195, i64 %8
  %197 = load i64, ptr %196, align 8
  store i64 %197, ptr %193, align 8
  %198 = getelementptr inbounds i64, ptr %185, i64 %1
  %199 = load i64, ptr %198, align 8
  store i64 %199, ptr %5, align 8
  %200 = getelementptr inbounds %struct.Part, ptr %5, i64 0, i32 1
  %201 = getelementptr inbounds i64, ptr %190, i64 %1
  %202 = load i64, ptr %201, align 8
  store i64 %202, ptr %200, align 8
  %203 = getelementptr inbounds %struct.Part, ptr %5, i64 0, i32 2
  %204 = getelementptr inbounds i64, ptr %195, i64 %1
  %205 = load i64, ptr %204, align 8
  store i64 %205, ptr %203, align 8
  tail call fastcc void @two_nodes(ptr noundef nonnull %2, ptr noundef nonnull byval(%struct.Part) align 8 %4, ptr noundef nonnull byval(%struct.Part) align 8 %5, double noundef 0xFFF0000000000000)
  %206 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 12
  %207 = load i64, ptr %206, align 8
  %208 = add nsw i64 %207, 1
  %209 = sitofp i64 %208 to double
  store double %209, ptr %122, align 8
  %210 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  %211 = load i64, ptr %210, align 8
  %212 = add nsw i64 %211, 1
  %213 = sitofp i64 %212 to double
  %214 = getelementptr inbounds double, ptr %122, i64 1
  store double %213, ptr %214, align 8
  br label %238

215:                                              ; preds = %161
  %216 = getelementptr inbounds %struct.World, ptr %6, i64 0, i32 35
  %217 = load ptr, ptr %216, align 8
  %218 = getelementptr inbounds i64, ptr %217, i64 %8
  %219 = load i64, ptr %218, align 8
  store i64 %219, ptr %4, align 8
  %220 = getelementptr inbounds %struct.Part, ptr %4, i64 0, i32 1
  %221 = getelementptr inbounds %struct.World, ptr %6, i64 0, i32 13
  %222 = load ptr, ptr %221, align 8
  %223 = getelementptr inbounds i64, ptr %222, i64 %8
  %224 = load i64, ptr %223, align 8
  store i64 %224, ptr %220, align 8
  %225 = getelementptr inbounds %struct.Part, ptr %4, i64 0, i32 2
  %226 = getelementptr inbounds %struct.World, ptr %6, i64 0, i32 14
  %227 = load ptr, ptr %226, align 8
  %228 = getelementptr inbounds i64, ptr %227, i64 %8
  %229 = load i64, ptr %228, align 8
  store i64 %229, ptr %225, align 8
  %230 = getelementptr inbounds i64, ptr %217, i64 %1
  %231 = load i64, ptr %230, align 8
  store i64 %231, ptr %5, align 8
  %232 = getelementptr inbounds %struct.Part, ptr %5, i64 0, i32 1
  %233 = getelementptr inbounds i64, ptr %222, i64 %1
  %234 = load i64, ptr %233, align 8
  store i64 %234, ptr %232, align 8
  %235 = getelementptr inbounds %struct.Part, ptr %5, i64 0, i32 2
  %236 = getelementptr inbounds i64, ptr %227, i64 %1
  %237 = load i64, ptr %236, align 8
  store i64 %237, ptr %235, align 8
  tail call fastcc void @two_nodes(ptr noundef nonnull %2, ptr noundef nonnull byval(%struct.Part) align 8 %4, ptr noundef nonnull byval(%struct.Part) align 8 %5, double noundef 0xFFF0000000000000)
  br label %238

238:                                              ; preds = %215, %183
  ret void
}

define internal fastcc i32 @is_around(ptr noundef readonly %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3) unnamed_addr #10 {
  %5 = alloca [3 x double], align 16
  %6 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 40
  %7 = load ptr, ptr %6, align 8
  %8 = shl nsw i64 %2, 1
  %9 = getelementptr inbounds i64, ptr %7, i64 %8
  %10 = getelementptr inbounds i64, ptr %9, i64 1
  %11 = load i64, ptr %10, align 8
  %12 = icmp sgt i64 %11, 0
  br i1 %12, label %13, label %100

13:                                               ; preds = %4
  %14 = load i64, ptr %9, align 8
  %15 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 41
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 33
  %18 = load ptr, ptr %17, align 8
  %19 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 35
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds i64, ptr %20, i64 %1
  br label %22

22:                                               ; preds = %13, %94
  %23 = phi i64 [ %14, %13 ], [ %95, %94 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %5) #19
  %24 = mul nsw i64 %23, 3
  %25 = getelementptr inbounds double, ptr %16, i64 %24
  %26 = getelementptr inbounds double, ptr %25, i64 1
  %27 = getelementptr inbounds double, ptr %25, i64 2
  br label %28

28:                                               ; preds = %28, %22
  %29 = phi i64 [ 0, %22 ], [ %52, %28 ]
  %30 = mul nuw nsw i64 %29, 3
  %31 = getelementptr inbounds double, ptr %3, i64 %30
  %32 = load double, ptr %31, align 8
  %33 = load double, ptr %25, align 8
  %34 = fmul double %32, %33
  %35 = add nuw nsw i64 %30, 1
  %36 = getelementptr inbounds double, ptr %3, i64 %35
  %37 = load double, ptr %36, align 8
  %38 = load double, ptr %26, align 8
  %39 = fmul double %37, %38
  %40 = fadd double %34, %39
  %41 = add nuw nsw i64 %30, 2
  %42 = getelementptr inbounds double, ptr %3, i64 %41
  %43 = load double, ptr %42, align 8
  %44 = load double, ptr %27, align 8
  %45 = fmul double %43, %44
  %46 = fadd double %40, %45
  %47 = add nuw nsw i64 %29, 9
  %48 = getelementptr inbounds double, ptr %3, i64 %47
  %49 = load double, ptr %48, align 8
  %50 = fadd double %49, %46
  %51 = getelementptr inbounds double, ptr %5, i64 %29
  store double %50, ptr %51, align 8
  %52 = add nuw nsw i64 %29, 1
  %53 = icmp eq i64 %52, 3
  br i1 %53, label %54, label %28

54:                                               ; preds = %28
  %55 = load i64, ptr %21, align 8
  %56 = mul nsw i64 %55, 6
  %57 = getelementptr inbounds double, ptr %18, i64 %56
  br label %58

58:                                               ; preds = %58, %54
  %59 = phi i64 [ 0, %54 ], [ %76, %58 ]
  %60 = phi double [ 0.000000e+00, %54 ], [ %75, %58 ]
  %61 = getelementptr inbounds double, ptr %57, i64 %59
  %62 = load double, ptr %61, align 8
  %63 = getelementptr inbounds double, ptr %5, i64 %59
  %64 = load double, ptr %63, align 8
  %65 = fsub double %62, %64
  %66 = add nuw nsw i64 %59, 3
  %67 = getelementptr inbounds double, ptr %57, i64 %66
  %68 = load double, ptr %67, align 8
  %69 = fsub double %64, %68
  %70 = fcmp ogt double %65, %69
  %71 = select i1 %70, double %65, double %69
  %72 = fcmp ogt double %71, 0.000000e+00
  %73 = select i1 %72, double %71, double 0.000000e+00
  %74 = fmul double %73, %73
  %75 = fadd double %60, %74
  %76 = add nuw nsw i64 %59, 1
  %77 = icmp eq i64 %76, 3
  br i1 %77, label %78, label %58

78:                                               ; preds = %58
  %79 = call double @llvm.sqrt.f64(double %75)
  %80 = fcmp ogt double %79, 0.000000e+00
  br i1 %80, label %81, label %82

81:                                               ; preds = %78
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5) #19
  br label %94

82:                                               ; preds = %78, %82
  %83 = phi i64 [ %90, %82 ], [ 0, %78 ]
  %84 = phi i32 [ %89, %82 ], [ 0, %78 ]
  %85 = getelementptr inbounds [3 x [3 x double]], ptr @within.ray, i64 0, i64 %83
  %86 = call fastcc i32 @leaves(ptr noundef %0, i64 noundef %55, ptr noundef nonnull %5, ptr noundef nonnull %85)
  %87 = icmp ne i32 %86, 0
  %88 = zext i1 %87 to i32
  %89 = add nuw nsw i32 %84, %88
  %90 = add nuw nsw i64 %83, 1
  %91 = icmp eq i64 %90, 3
  br i1 %91, label %92, label %82

92:                                               ; preds = %82
  %93 = icmp ult i32 %89, 2
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5) #19
  br i1 %93, label %94, label %100

94:                                               ; preds = %81, %92
  %95 = add nsw i64 %23, 1
  %96 = load i64, ptr %9, align 8
  %97 = load i64, ptr %10, align 8
  %98 = add nsw i64 %97, %96
  %99 = icmp slt i64 %95, %98
  br i1 %99, label %22, label %100

100:                                              ; preds = %92, %94, %4
  %101 = phi i32 [ 0, %4 ], [ 0, %94 ], [ 1, %92 ]
  ret i32 %101
}

define internal fastcc void @surface(ptr nocapture noundef %0, i64 noundef %1, i64 noundef %2, i64 noundef %3, i64 noundef %4, ptr nocapture noundef readonly %5) unnamed_addr #6 {
  %7 = alloca [3 x double], align 16
  %8 = alloca %struct.Plane, align 8
  %9 = alloca [3 x double], align 16
  %10 = alloca double, align 8
  %11 = alloca double, align 8
  %12 = alloca %struct.Core, align 8
  %13 = alloca [3 x double], align 16
  %14 = load ptr, ptr %0, align 8
  %15 = getelementptr inbounds %struct.World, ptr %14, i64 0, i32 33
  %16 = load ptr, ptr %15, align 8
  %17 = mul nsw i64 %2, 6
  %18 = getelementptr inbounds double, ptr %16, i64 %17
  %19 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 16
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds %struct.World, ptr %14, i64 0, i32 15
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr inbounds double, ptr %22, i64 %1
  %24 = load double, ptr %23, align 8
  %25 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %26 = load ptr, ptr %25, align 8
  %27 = icmp eq ptr %26, null
  br i1 %27, label %28, label %31

28:                                               ; preds = %6
  %29 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %30 = load double, ptr %29, align 8
  br label %45

31:                                               ; preds = %6
  %32 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %33 = load ptr, ptr %32, align 8
  %34 = icmp eq ptr %33, null
  %35 = getelementptr inbounds i64, ptr %33, i64 %1
  %36 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %37 = select i1 %34, ptr %36, ptr %35
  %38 = load i64, ptr %37, align 8
  %39 = getelementptr inbounds double, ptr %26, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %42 = load double, ptr %41, align 8
  %43 = fcmp ogt double %40, %42
  %44 = select i1 %43, double %42, double %40
  br label %45

45:                                               ; preds = %28, %31
  %46 = phi double [ %44, %31 ], [ %30, %28 ]
  %47 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 18
  %48 = load double, ptr %47, align 8
  %49 = fsub double %46, %48
  %50 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %51 = load i64, ptr %50, align 8
  %52 = getelementptr inbounds double, ptr %22, i64 %51
  %53 = load double, ptr %52, align 8
  br label %54

54:                                               ; preds = %54, %45
  %55 = phi i64 [ 0, %45 ], [ %72, %54 ]
  %56 = phi double [ 0.000000e+00, %45 ], [ %71, %54 ]
  %57 = getelementptr inbounds double, ptr %18, i64 %55
  %58 = load double, ptr %57, align 8
  %59 = getelementptr inbounds double, ptr %20, i64 %55
  %60 = load double, ptr %59, align 8
  %61 = fsub double %58, %60
  %62 = add nuw nsw i64 %55, 3
  %63 = getelementptr inbounds double, ptr %18, i64 %62
  %64 = load double, ptr %63, align 8
  %65 = fsub double %60, %64
  %66 = fcmp ogt double %61, %65
  %67 = select i1 %66, double %61, double %65
  %68 = fcmp ogt double %67, 0.000000e+00
  %69 = select i1 %68, double %67, double 0.000000e+00
  %70 = fmul double %69, %69
  %71 = fadd double %56, %70
  %72 = add nuw nsw i64 %55, 1
  %73 = icmp eq i64 %72, 3
  br i1 %73, label %74, label %54

74:                                               ; preds = %54
  %75 = fneg double %24
  %76 = fsub double %75, %53
  %77 = tail call double @llvm.sqrt.f64(double %71)
  %78 = getelementptr inbounds %struct.World, ptr %14, i64 0, i32 18
  %79 = load ptr, ptr %78, align 8
  %80 = shl nsw i64 %51, 2
  %81 = or i64 %80, 3
  %82 = getelementptr inbounds double, ptr %79, i64 %81
  %83 = load double, ptr %82, align 8
  br i1 %27, label %95, label %84

84:                                               ; preds = %74
  %85 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %86 = load ptr, ptr %85, align 8
  %87 = icmp eq ptr %86, null
  %88 = getelementptr inbounds i64, ptr %86, i64 %1
  %89 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %90 = select i1 %87, ptr %89, ptr %88
  %91 = load i64, ptr %90, align 8
  %92 = getelementptr inbounds double, ptr %26, i64 %91
  %93 = load double, ptr %92, align 8
  %94 = fcmp uno double %93, 0.000000e+00
  br i1 %94, label %401, label %99

95:                                               ; preds = %74
  %96 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %97 = load i32, ptr %96, align 8
  %98 = icmp eq i32 %97, 1
  br i1 %98, label %401, label %99

99:                                               ; preds = %84, %95
  %100 = fsub double %77, %83
  %101 = fsub double %100, %24
  %102 = fcmp ogt double %101, %49
  br i1 %102, label %401, label %103

103:                                              ; preds = %99, %103
  %104 = phi i64 [ %116, %103 ], [ 0, %99 ]
  %105 = phi double [ %115, %103 ], [ 0.000000e+00, %99 ]
  %106 = getelementptr inbounds [3 x double], ptr %5, i64 0, i64 %104
  %107 = load double, ptr %106, align 8
  %108 = fcmp ogt double %107, 0.000000e+00
  %109 = add nuw nsw i64 %104, 3
  %110 = select i1 %108, i64 %109, i64 %104
  %111 = and i64 %110, 4294967295
  %112 = getelementptr inbounds double, ptr %18, i64 %111
  %113 = load double, ptr %112, align 8
  %114 = fmul double %107, %113
  %115 = fadd double %105, %114
  %116 = add nuw nsw i64 %104, 1
  %117 = icmp eq i64 %116, 3
  br i1 %117, label %118, label %103

118:                                              ; preds = %103
  %119 = getelementptr inbounds %struct.Plane, ptr %5, i64 0, i32 1
  %120 = load double, ptr %119, align 8
  %121 = fsub double %120, %115
  %122 = fadd double %76, %121
  %123 = fcmp ogt double %122, %49
  br i1 %123, label %401, label %124

124:                                              ; preds = %118
  %125 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10
  br label %126

126:                                              ; preds = %126, %124
  %127 = phi i64 [ 0, %124 ], [ %139, %126 ]
  %128 = phi double [ 0.000000e+00, %124 ], [ %138, %126 ]
  %129 = getelementptr inbounds [3 x double], ptr %125, i64 0, i64 %127
  %130 = load double, ptr %129, align 8
  %131 = fcmp ogt double %130, 0.000000e+00
  %132 = add nuw nsw i64 %127, 3
  %133 = select i1 %131, i64 %132, i64 %127
  %134 = and i64 %133, 4294967295
  %135 = getelementptr inbounds double, ptr %18, i64 %134
  %136 = load double, ptr %135, align 8
  %137 = fmul double %130, %136
  %138 = fadd double %128, %137
  %139 = add nuw nsw i64 %127, 1
  %140 = icmp eq i64 %139, 3
  br i1 %140, label %141, label %126

141:                                              ; preds = %126
  %142 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10, i32 1
  %143 = load double, ptr %142, align 8
  %144 = fsub double %143, %138
  %145 = fadd double %76, %144
  %146 = fcmp ogt double %145, %49
  br i1 %146, label %401, label %147

147:                                              ; preds = %141
  %148 = getelementptr inbounds %struct.World, ptr %14, i64 0, i32 34
  %149 = load ptr, ptr %148, align 8
  %150 = shl nsw i64 %2, 1
  %151 = getelementptr inbounds i64, ptr %149, i64 %150
  %152 = load i64, ptr %151, align 8
  %153 = icmp slt i64 %152, 0
  br i1 %153, label %154, label %174

154:                                              ; preds = %147
  %155 = getelementptr inbounds %struct.World, ptr %14, i64 0, i32 36
  %156 = load ptr, ptr %155, align 8
  %157 = getelementptr inbounds i64, ptr %151, i64 1
  %158 = load i64, ptr %157, align 8
  %159 = mul nsw i64 %158, 9
  %160 = getelementptr inbounds double, ptr %156, i64 %159
  %161 = tail call fastcc double @in_front(ptr noundef nonnull %125, ptr noundef %160)
  %162 = fadd double %76, %161
  %163 = fcmp ogt double %162, %49
  br i1 %163, label %401, label %164

164:                                              ; preds = %154
  %165 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %166 = load i32, ptr %165, align 8
  %167 = icmp eq i32 %166, 0
  br i1 %167, label %168, label %169

168:                                              ; preds = %164
  tail call fastcc void @one_leaf(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %158, double noundef %49, ptr noundef nonnull %125)
  br label %401

169:                                              ; preds = %164
  %170 = tail call fastcc double @in_front(ptr noundef %5, ptr noundef %160)
  %171 = fadd double %76, %170
  %172 = fcmp ugt double %171, %49
  br i1 %172, label %401, label %173

173:                                              ; preds = %169
  tail call fastcc void @one_leaf(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %158, double noundef %49, ptr noundef %5)
  br label %401

174:                                              ; preds = %147
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %8) #19
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %8, ptr noundef nonnull align 8 dereferenceable(32) %5, i64 32, i1 false)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %10) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %11) #19
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %12) #19
  %175 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 7
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %175, ptr noundef nonnull align 16 dereferenceable(72) @box_core.straight, i64 72, i1 false)
  br label %176

176:                                              ; preds = %176, %174
  %177 = phi i64 [ 0, %174 ], [ %192, %176 ]
  %178 = getelementptr inbounds double, ptr %18, i64 %177
  %179 = load double, ptr %178, align 8
  %180 = add nuw nsw i64 %177, 3
  %181 = getelementptr inbounds double, ptr %18, i64 %180
  %182 = load double, ptr %181, align 8
  %183 = fadd double %179, %182
  %184 = fmul double %183, 5.000000e-01
  %185 = add nuw nsw i64 %177, 9
  %186 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 7, i64 %185
  store double %184, ptr %186, align 8
  %187 = load double, ptr %181, align 8
  %188 = load double, ptr %178, align 8
  %189 = fsub double %187, %188
  %190 = fmul double %189, 5.000000e-01
  %191 = getelementptr inbounds double, ptr %9, i64 %177
  store double %190, ptr %191, align 8
  %192 = add nuw nsw i64 %177, 1
  %193 = icmp eq i64 %192, 3
  br i1 %193, label %194, label %176

194:                                              ; preds = %176
  store i64 1, ptr %12, align 8
  %195 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 5
  store ptr %175, ptr %195, align 8
  %196 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 6
  store ptr %9, ptr %196, align 8
  %197 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 7, i64 9
  %198 = load double, ptr %9, align 16
  %199 = fmul double %198, %198
  %200 = getelementptr inbounds double, ptr %9, i64 1
  %201 = load double, ptr %200, align 8
  %202 = fmul double %201, %201
  %203 = fadd double %199, %202
  %204 = getelementptr inbounds double, ptr %9, i64 2
  %205 = load double, ptr %204, align 16
  %206 = fmul double %205, %205
  %207 = fadd double %203, %206
  %208 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %209 = load ptr, ptr %208, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  %210 = load double, ptr %197, align 8
  %211 = getelementptr inbounds double, ptr %209, i64 9
  %212 = load double, ptr %211, align 8
  %213 = fsub double %210, %212
  %214 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 7, i64 10
  %215 = load double, ptr %214, align 8
  %216 = getelementptr inbounds double, ptr %209, i64 10
  %217 = load double, ptr %216, align 8
  %218 = fsub double %215, %217
  %219 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 7, i64 11
  %220 = load double, ptr %219, align 8
  %221 = getelementptr inbounds double, ptr %209, i64 11
  %222 = load double, ptr %221, align 8
  %223 = fsub double %220, %222
  br label %224

224:                                              ; preds = %224, %194
  %225 = phi i64 [ 0, %194 ], [ %240, %224 ]
  %226 = getelementptr inbounds double, ptr %209, i64 %225
  %227 = load double, ptr %226, align 8
  %228 = fmul double %213, %227
  %229 = add nuw nsw i64 %225, 3
  %230 = getelementptr inbounds double, ptr %209, i64 %229
  %231 = load double, ptr %230, align 8
  %232 = fmul double %218, %231
  %233 = fadd double %228, %232
  %234 = add nuw nsw i64 %225, 6
  %235 = getelementptr inbounds double, ptr %209, i64 %234
  %236 = load double, ptr %235, align 8
  %237 = fmul double %223, %236
  %238 = fadd double %233, %237
  %239 = getelementptr inbounds double, ptr %7, i64 %225
  store double %238, ptr %239, align 8
  %240 = add nuw nsw i64 %225, 1
  %241 = icmp eq i64 %240, 3
  br i1 %241, label %242, label %224

242:                                              ; preds = %224
  %243 = call double @llvm.sqrt.f64(double %207)
  %244 = getelementptr inbounds %struct.World, ptr %14, i64 0, i32 19
  %245 = load ptr, ptr %244, align 8
  %246 = mul nsw i64 %51, 6
  %247 = getelementptr inbounds double, ptr %245, i64 %246
  br label %248

248:                                              ; preds = %248, %242
  %249 = phi i64 [ 0, %242 ], [ %266, %248 ]
  %250 = phi double [ 0.000000e+00, %242 ], [ %265, %248 ]
  %251 = getelementptr inbounds double, ptr %247, i64 %249
  %252 = load double, ptr %251, align 8
  %253 = getelementptr inbounds double, ptr %7, i64 %249
  %254 = load double, ptr %253, align 8
  %255 = fsub double %252, %254
  %256 = add nuw nsw i64 %249, 3
  %257 = getelementptr inbounds double, ptr %247, i64 %256
  %258 = load double, ptr %257, align 8
  %259 = fsub double %254, %258
  %260 = fcmp ogt double %255, %259
  %261 = select i1 %260, double %255, double %259
  %262 = fcmp ogt double %261, 0.000000e+00
  %263 = select i1 %262, double %261, double 0.000000e+00
  %264 = fmul double %263, %263
  %265 = fadd double %250, %264
  %266 = add nuw nsw i64 %249, 1
  %267 = icmp eq i64 %266, 3
  br i1 %267, label %268, label %248

268:                                              ; preds = %248
  %269 = fadd double %24, %49
  %270 = fadd double %269, %243
  %271 = fmul double %270, %270
  %272 = fcmp ule double %265, %271
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  br i1 %272, label %273, label %400

273:                                              ; preds = %268
  %274 = fadd double %198, %201
  %275 = fadd double %274, %205
  %276 = load double, ptr %82, align 8
  %277 = fmul double %276, 2.000000e+00
  %278 = fcmp olt double %275, %277
  %279 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %280 = load i32, ptr %279, align 8
  %281 = icmp ne i32 %280, 0
  %282 = icmp slt i64 %4, 33
  %283 = and i1 %282, %281
  br i1 %283, label %284, label %305

284:                                              ; preds = %273
  %285 = icmp sgt i64 %4, 16
  %286 = add i64 %4, -3
  %287 = icmp ult i64 %286, 2
  %288 = or i1 %285, %287
  %289 = and i1 %288, %278
  store i64 0, ptr %12, align 8
  %290 = mul nsw i64 %4, 3
  %291 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 1
  store i64 %290, ptr %291, align 8
  store ptr @hull_core.still, ptr %195, align 8
  %292 = getelementptr inbounds %struct.World, ptr %14, i64 0, i32 37
  %293 = load ptr, ptr %292, align 8
  %294 = mul nsw i64 %3, 3
  %295 = getelementptr inbounds double, ptr %293, i64 %294
  %296 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 2
  store ptr %295, ptr %296, align 8
  %297 = getelementptr inbounds %struct.World, ptr %14, i64 0, i32 38
  %298 = load ptr, ptr %297, align 8
  %299 = getelementptr inbounds double, ptr %298, i64 %294
  %300 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 3
  store ptr %299, ptr %300, align 8
  %301 = getelementptr inbounds %struct.World, ptr %14, i64 0, i32 39
  %302 = load ptr, ptr %301, align 8
  %303 = getelementptr inbounds double, ptr %302, i64 %294
  %304 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 4
  store ptr %303, ptr %304, align 8
  br i1 %289, label %306, label %338

305:                                              ; preds = %273
  br i1 %278, label %306, label %338

306:                                              ; preds = %284, %305
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %13) #19
  %307 = icmp eq i32 %280, 0
  br label %314

308:                                              ; preds = %326
  %309 = fsub double %49, %76
  %310 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %311 = load ptr, ptr %310, align 8
  %312 = call fastcc i32 @bounds_from(ptr noundef %311, ptr noundef nonnull %12, ptr noundef nonnull %13, double noundef %309, double noundef %309, double noundef 0x3DA5FD7FE1796495, ptr noundef nonnull %10, ptr noundef nonnull %11, ptr noundef nonnull %8, ptr noundef null, i32 noundef 0)
  %313 = icmp eq i32 %312, 0
  br i1 %313, label %335, label %331

314:                                              ; preds = %306, %326
  %315 = phi i64 [ 0, %306 ], [ %329, %326 ]
  br i1 %307, label %319, label %316

316:                                              ; preds = %314
  %317 = getelementptr inbounds [3 x double], ptr %5, i64 0, i64 %315
  %318 = load double, ptr %317, align 8
  br label %326

319:                                              ; preds = %314
  %320 = getelementptr inbounds double, ptr %20, i64 %315
  %321 = load double, ptr %320, align 8
  %322 = add nuw nsw i64 %315, 9
  %323 = getelementptr inbounds %struct.Core, ptr %12, i64 0, i32 7, i64 %322
  %324 = load double, ptr %323, align 8
  %325 = fsub double %321, %324
  br label %326

326:                                              ; preds = %319, %316
  %327 = phi double [ %318, %316 ], [ %325, %319 ]
  %328 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %315
  store double %327, ptr %328, align 8
  %329 = add nuw nsw i64 %315, 1
  %330 = icmp eq i64 %329, 3
  br i1 %330, label %308, label %314

331:                                              ; preds = %308
  %332 = load double, ptr %10, align 8
  %333 = fadd double %76, %332
  %334 = fcmp ogt double %333, %49
  br i1 %334, label %337, label %335

335:                                              ; preds = %331, %308
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %13) #19
  %336 = load ptr, ptr %15, align 8
  br label %338

337:                                              ; preds = %331
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %13) #19
  br label %400

338:                                              ; preds = %284, %335, %305
  %339 = phi ptr [ %336, %335 ], [ %16, %305 ], [ %16, %284 ]
  %340 = load i64, ptr %151, align 8
  %341 = mul nsw i64 %340, 6
  %342 = getelementptr inbounds double, ptr %339, i64 %341
  br label %343

343:                                              ; preds = %343, %338
  %344 = phi i64 [ 0, %338 ], [ %356, %343 ]
  %345 = phi double [ 0.000000e+00, %338 ], [ %355, %343 ]
  %346 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %344
  %347 = load double, ptr %346, align 8
  %348 = fcmp ogt double %347, 0.000000e+00
  %349 = add nuw nsw i64 %344, 3
  %350 = select i1 %348, i64 %349, i64 %344
  %351 = and i64 %350, 4294967295
  %352 = getelementptr inbounds double, ptr %342, i64 %351
  %353 = load double, ptr %352, align 8
  %354 = fmul double %347, %353
  %355 = fadd double %345, %354
  %356 = add nuw nsw i64 %344, 1
  %357 = icmp eq i64 %356, 3
  br i1 %357, label %358, label %343

358:                                              ; preds = %343
  %359 = getelementptr inbounds %struct.Plane, ptr %8, i64 0, i32 1
  %360 = load double, ptr %359, align 8
  %361 = getelementptr inbounds i64, ptr %151, i64 1
  %362 = load i64, ptr %361, align 8
  %363 = mul nsw i64 %362, 6
  %364 = getelementptr inbounds double, ptr %339, i64 %363
  br label %365

365:                                              ; preds = %365, %358
  %366 = phi i64 [ 0, %358 ], [ %378, %365 ]
  %367 = phi double [ 0.000000e+00, %358 ], [ %377, %365 ]
  %368 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %366
  %369 = load double, ptr %368, align 8
  %370 = fcmp ogt double %369, 0.000000e+00
  %371 = add nuw nsw i64 %366, 3
  %372 = select i1 %370, i64 %371, i64 %366
  %373 = and i64 %372, 4294967295
  %374 = getelementptr inbounds double, ptr %364, i64 %373
  %375 = load double, ptr %374, align 8
  %376 = fmul double %369, %375
  %377 = fadd double %367, %376
  %378 = add nuw nsw i64 %366, 1
  %379 = icmp eq i64 %378, 3
  br i1 %379, label %380, label %365

380:                                              ; preds = %365
  %381 = fsub double %360, %355
  %382 = fsub double %360, %377
  %383 = fcmp olt double %382, %381
  %384 = sdiv i64 %4, 2
  %385 = sdiv i64 %4, -2
  %386 = add i64 %385, %4
  %387 = zext i1 %383 to i64
  %388 = getelementptr inbounds i64, ptr %151, i64 %387
  %389 = load i64, ptr %388, align 8
  %390 = select i1 %383, i64 %384, i64 0
  %391 = add nsw i64 %390, %3
  %392 = select i1 %383, i64 %386, i64 %384
  call fastcc void @surface(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %389, i64 noundef %391, i64 noundef %392, ptr noundef nonnull %8)
  %393 = xor i1 %383, true
  %394 = zext i1 %393 to i64
  %395 = getelementptr inbounds i64, ptr %151, i64 %394
  %396 = load i64, ptr %395, align 8
  %397 = select i1 %383, i64 0, i64 %384
  %398 = add nsw i64 %397, %3
  %399 = select i1 %383, i64 %384, i64 %386
  call fastcc void @surface(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %396, i64 noundef %398, i64 noundef %399, ptr noundef nonnull %8)
  br label %400

400:                                              ; preds = %380, %337, %268
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %12) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %11) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %10) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #19
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %8) #19
  br label %401

401:                                              ; preds = %84, %400, %168, %173, %169, %154, %118, %141, %95, %99
  ret void
}

define internal fastcc void @two_leaves(ptr noundef %0, i64 noundef %1, i64 noundef %2) unnamed_addr #6 {
  %4 = alloca %struct.Core, align 8
  %5 = alloca %struct.Core, align 8
  %6 = alloca [9 x double], align 16
  %7 = alloca [9 x double], align 16
  %8 = alloca [3 x double], align 16
  %9 = alloca double, align 8
  %10 = alloca double, align 8
  %11 = alloca %struct.Simplex, align 8
  %12 = load ptr, ptr %0, align 8
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %4) #19
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %5) #19
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %6) #19
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %7) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %9) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %10) #19
  %13 = getelementptr inbounds %struct.Two, ptr %0, i64 0, i32 1
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 6
  %16 = load ptr, ptr %15, align 8
  %17 = icmp eq ptr %16, null
  br i1 %17, label %18, label %21

18:                                               ; preds = %3
  %19 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 5
  %20 = load double, ptr %19, align 8
  br label %35

21:                                               ; preds = %3
  %22 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 3
  %23 = load ptr, ptr %22, align 8
  %24 = icmp eq ptr %23, null
  %25 = getelementptr inbounds i64, ptr %23, i64 %14
  %26 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 4
  %27 = select i1 %24, ptr %26, ptr %25
  %28 = load i64, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %16, i64 %28
  %30 = load double, ptr %29, align 8
  %31 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 5
  %32 = load double, ptr %31, align 8
  %33 = fcmp ogt double %30, %32
  %34 = select i1 %33, double %32, double %30
  br label %35

35:                                               ; preds = %18, %21
  %36 = phi double [ %20, %18 ], [ 0xFFF0000000000000, %21 ]
  %37 = phi double [ %20, %18 ], [ %34, %21 ]
  %38 = load ptr, ptr %12, align 8
  %39 = getelementptr inbounds %struct.World, ptr %38, i64 0, i32 36
  %40 = load ptr, ptr %39, align 8
  %41 = mul nsw i64 %1, 9
  %42 = getelementptr inbounds double, ptr %40, i64 %41
  br label %43

43:                                               ; preds = %73, %35
  %44 = phi i64 [ 0, %35 ], [ %77, %73 ]
  %45 = phi i32 [ 1, %35 ], [ %76, %73 ]
  %46 = mul nuw nsw i64 %44, 3
  br label %56

47:                                               ; preds = %56
  %48 = add nuw nsw i64 %44, 3
  %49 = getelementptr inbounds double, ptr %42, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = getelementptr inbounds double, ptr %42, i64 %44
  %52 = load double, ptr %51, align 8
  %53 = fsub double %50, %52
  %54 = tail call double @llvm.fabs.f64(double %53)
  %55 = fcmp olt double %54, 3.000000e-07
  br i1 %55, label %66, label %73

56:                                               ; preds = %56, %43
  %57 = phi i64 [ 0, %43 ], [ %64, %56 ]
  %58 = mul nuw nsw i64 %57, 3
  %59 = add nuw nsw i64 %58, %44
  %60 = getelementptr inbounds double, ptr %42, i64 %59
  %61 = load double, ptr %60, align 8
  %62 = add nuw nsw i64 %57, %46
  %63 = getelementptr inbounds double, ptr %6, i64 %62
  store double %61, ptr %63, align 8
  %64 = add nuw nsw i64 %57, 1
  %65 = icmp eq i64 %64, 3
  br i1 %65, label %47, label %56

66:                                               ; preds = %47
  %67 = add nuw nsw i64 %44, 6
  %68 = getelementptr inbounds double, ptr %42, i64 %67
  %69 = load double, ptr %68, align 8
  %70 = fsub double %69, %52
  %71 = tail call double @llvm.fabs.f64(double %70)
  %72 = fcmp olt double %71, 3.000000e-07
  br label %73

73:                                               ; preds = %66, %47
  %74 = phi i1 [ false, %47 ], [ %72, %66 ]
  %75 = zext i1 %74 to i32
  %76 = and i32 %45, %75
  %77 = add nuw nsw i64 %44, 1
  %78 = icmp eq i64 %77, 3
  br i1 %78, label %79, label %43

79:                                               ; preds = %73
  store i64 0, ptr %4, align 8
  %80 = icmp eq i32 %76, 0
  %81 = select i1 %80, i64 3, i64 1
  %82 = getelementptr inbounds %struct.Core, ptr %4, i64 0, i32 1
  store i64 %81, ptr %82, align 8
  %83 = getelementptr inbounds %struct.Core, ptr %4, i64 0, i32 5
  %84 = getelementptr inbounds %struct.Core, ptr %4, i64 0, i32 2
  store ptr %6, ptr %84, align 8
  %85 = getelementptr inbounds double, ptr %6, i64 3
  %86 = getelementptr inbounds %struct.Core, ptr %4, i64 0, i32 3
  store ptr %85, ptr %86, align 8
  %87 = getelementptr inbounds double, ptr %6, i64 6
  %88 = getelementptr inbounds %struct.Core, ptr %4, i64 0, i32 4
  store ptr %87, ptr %88, align 8
  %89 = mul nsw i64 %2, 9
  %90 = getelementptr inbounds double, ptr %40, i64 %89
  br label %91

91:                                               ; preds = %121, %79
  %92 = phi i64 [ 0, %79 ], [ %125, %121 ]
  %93 = phi i32 [ 1, %79 ], [ %124, %121 ]
  %94 = mul nuw nsw i64 %92, 3
  br label %104

95:                                               ; preds = %104
  %96 = add nuw nsw i64 %92, 3
  %97 = getelementptr inbounds double, ptr %90, i64 %96
  %98 = load double, ptr %97, align 8
  %99 = getelementptr inbounds double, ptr %90, i64 %92
  %100 = load double, ptr %99, align 8
  %101 = fsub double %98, %100
  %102 = call double @llvm.fabs.f64(double %101)
  %103 = fcmp olt double %102, 3.000000e-07
  br i1 %103, label %114, label %121

104:                                              ; preds = %104, %91
  %105 = phi i64 [ 0, %91 ], [ %112, %104 ]
  %106 = mul nuw nsw i64 %105, 3
  %107 = add nuw nsw i64 %106, %92
  %108 = getelementptr inbounds double, ptr %90, i64 %107
  %109 = load double, ptr %108, align 8
  %110 = add nuw nsw i64 %105, %94
  %111 = getelementptr inbounds double, ptr %7, i64 %110
  store double %109, ptr %111, align 8
  %112 = add nuw nsw i64 %105, 1
  %113 = icmp eq i64 %112, 3
  br i1 %113, label %95, label %104

114:                                              ; preds = %95
  %115 = add nuw nsw i64 %92, 6
  %116 = getelementptr inbounds double, ptr %90, i64 %115
  %117 = load double, ptr %116, align 8
  %118 = fsub double %117, %100
  %119 = call double @llvm.fabs.f64(double %118)
  %120 = fcmp olt double %119, 3.000000e-07
  br label %121

121:                                              ; preds = %114, %95
  %122 = phi i1 [ false, %95 ], [ %120, %114 ]
  %123 = zext i1 %122 to i32
  %124 = and i32 %93, %123
  %125 = add nuw nsw i64 %92, 1
  %126 = icmp eq i64 %125, 3
  br i1 %126, label %127, label %91

127:                                              ; preds = %121
  store i64 0, ptr %5, align 8
  %128 = icmp eq i32 %124, 0
  %129 = select i1 %128, i64 3, i64 1
  %130 = getelementptr inbounds %struct.Core, ptr %5, i64 0, i32 1
  store i64 %129, ptr %130, align 8
  %131 = getelementptr inbounds %struct.Core, ptr %5, i64 0, i32 5
  store ptr @place.still, ptr %131, align 8
  %132 = getelementptr inbounds %struct.Core, ptr %5, i64 0, i32 2
  store ptr %7, ptr %132, align 8
  %133 = getelementptr inbounds double, ptr %7, i64 3
  %134 = getelementptr inbounds %struct.Core, ptr %5, i64 0, i32 3
  store ptr %133, ptr %134, align 8
  %135 = getelementptr inbounds double, ptr %7, i64 6
  %136 = getelementptr inbounds %struct.Core, ptr %5, i64 0, i32 4
  store ptr %135, ptr %136, align 8
  %137 = getelementptr inbounds %struct.Two, ptr %0, i64 0, i32 2
  store ptr %137, ptr %83, align 8
  %138 = getelementptr inbounds %struct.Two, ptr %0, i64 0, i32 5
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %8, ptr noundef nonnull align 8 dereferenceable(24) %138, i64 24, i1 false)
  call void @llvm.lifetime.start.p0(i64 224, ptr nonnull %11) #19
  %139 = fadd double %37, -1.000000e-10
  %140 = select i1 %17, double %37, double %139
  %141 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 1
  %142 = load i64, ptr %141, align 8
  %143 = getelementptr inbounds %struct.World, ptr %38, i64 0, i32 15
  %144 = load ptr, ptr %143, align 8
  %145 = getelementptr inbounds double, ptr %144, i64 %142
  %146 = load double, ptr %145, align 8
  %147 = getelementptr inbounds double, ptr %144, i64 %14
  %148 = load double, ptr %147, align 8
  %149 = fadd double %146, %148
  %150 = fadd double %140, %149
  %151 = fadd double %36, %149
  %152 = call fastcc i32 @bounds_from(ptr noundef nonnull %4, ptr noundef nonnull %5, ptr noundef nonnull %8, double noundef %150, double noundef %151, double noundef 0x3DA5FD7FE1796495, ptr noundef nonnull %9, ptr noundef nonnull %10, ptr noundef null, ptr noundef nonnull %11, i32 noundef 0)
  %153 = load double, ptr %9, align 8
  %154 = fsub double %153, %149
  %155 = load double, ptr %10, align 8
  %156 = fsub double %155, %149
  %157 = icmp ne i32 %152, 0
  %158 = fcmp ogt double %154, %140
  %159 = select i1 %157, i1 %158, i1 false
  br i1 %159, label %217, label %160

160:                                              ; preds = %127
  br i1 %157, label %165, label %161

161:                                              ; preds = %160
  %162 = load i64, ptr %13, align 8
  %163 = call fastcc i32 @tell_depth(ptr noundef nonnull %12, i64 noundef %162, ptr noundef nonnull %4, ptr noundef nonnull %5, ptr noundef nonnull %11)
  %164 = icmp eq i32 %163, 0
  br i1 %164, label %217, label %214

165:                                              ; preds = %160
  %166 = load ptr, ptr %15, align 8
  %167 = icmp eq ptr %166, null
  br i1 %167, label %201, label %168

168:                                              ; preds = %165
  %169 = load i64, ptr %13, align 8
  %170 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 3
  %171 = load ptr, ptr %170, align 8
  %172 = icmp eq ptr %171, null
  %173 = getelementptr inbounds i64, ptr %171, i64 %169
  %174 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 4
  %175 = select i1 %172, ptr %174, ptr %173
  %176 = load i64, ptr %175, align 8
  %177 = getelementptr inbounds double, ptr %166, i64 %176
  %178 = fsub double %156, %154
  %179 = fcmp ole double %178, 1.000000e-08
  %180 = select i1 %179, double %156, double %154
  %181 = load double, ptr %177, align 8
  %182 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 5
  %183 = load double, ptr %182, align 8
  %184 = call double @llvm.minnum.f64(double %181, double %183)
  %185 = fcmp ult double %180, %184
  br i1 %185, label %186, label %217

186:                                              ; preds = %168
  %187 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 7
  %188 = load ptr, ptr %187, align 8
  %189 = icmp ne ptr %188, null
  %190 = fcmp oeq double %181, 0x7FF0000000000000
  %191 = select i1 %189, i1 %190, i1 false
  br i1 %191, label %192, label %199

192:                                              ; preds = %186
  %193 = load ptr, ptr %12, align 8
  %194 = getelementptr inbounds %struct.World, ptr %193, i64 0, i32 45
  %195 = load ptr, ptr %194, align 8
  %196 = load i64, ptr %188, align 8
  %197 = add nsw i64 %196, 1
  store i64 %197, ptr %188, align 8
  %198 = getelementptr inbounds i64, ptr %195, i64 %196
  store i64 %176, ptr %198, align 8
  br label %199

199:                                              ; preds = %192, %186
  %200 = select i1 %179, double %156, double 0x7FF8000000000000
  store double %200, ptr %177, align 8
  br label %214

201:                                              ; preds = %165
  %202 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 5
  %203 = load double, ptr %202, align 8
  %204 = fcmp ult double %203, %156
  br i1 %204, label %207, label %205

205:                                              ; preds = %201
  %206 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 8
  store i32 1, ptr %206, align 8
  br label %214

207:                                              ; preds = %201
  %208 = fcmp ult double %203, %154
  br i1 %208, label %214, label %209

209:                                              ; preds = %207
  %210 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 8
  %211 = load i32, ptr %210, align 8
  %212 = icmp eq i32 %211, 0
  br i1 %212, label %213, label %214

213:                                              ; preds = %209
  store i32 2, ptr %210, align 8
  br label %214

214:                                              ; preds = %207, %209, %213, %205, %199, %161
  %215 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 12
  store i64 %1, ptr %215, align 8
  %216 = getelementptr inbounds %struct.Search, ptr %12, i64 0, i32 9
  store i64 %2, ptr %216, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %138, ptr noundef nonnull align 16 dereferenceable(24) %8, i64 24, i1 false)
  br label %217

217:                                              ; preds = %168, %161, %127, %214
  call void @llvm.lifetime.end.p0(i64 224, ptr nonnull %11) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %10) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %7) #19
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %6) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %5) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %4) #19
  ret void
}

define internal fastcc void @two_nodes(ptr noundef %0, ptr nocapture noundef readonly byval(%struct.Part) align 8 %1, ptr nocapture noundef readonly byval(%struct.Part) align 8 %2, double noundef %3) unnamed_addr #0 {
  %5 = alloca [3 x double], align 16
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  %8 = alloca [3 x double], align 16
  %9 = alloca [3 x double], align 16
  %10 = alloca %struct.Core, align 8
  %11 = alloca %struct.Core, align 8
  %12 = alloca [3 x double], align 16
  %13 = alloca double, align 8
  %14 = alloca double, align 8
  %15 = alloca [2 x %struct.Part], align 16
  %16 = alloca [2 x double], align 16
  %17 = alloca %struct.Part, align 8
  %18 = alloca %struct.Part, align 8
  %19 = load ptr, ptr %0, align 8
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 6
  %22 = load ptr, ptr %21, align 8
  %23 = icmp eq ptr %22, null
  br i1 %23, label %40, label %24

24:                                               ; preds = %4
  %25 = getelementptr inbounds %struct.Two, ptr %0, i64 0, i32 1
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 3
  %28 = load ptr, ptr %27, align 8
  %29 = icmp eq ptr %28, null
  %30 = getelementptr inbounds i64, ptr %28, i64 %26
  %31 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 4
  %32 = select i1 %29, ptr %31, ptr %30
  %33 = load i64, ptr %32, align 8
  %34 = getelementptr inbounds double, ptr %22, i64 %33
  %35 = load double, ptr %34, align 8
  %36 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 5
  %37 = load double, ptr %36, align 8
  %38 = fcmp ogt double %35, %37
  %39 = select i1 %38, double %37, double %35
  br label %46

40:                                               ; preds = %4
  %41 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 5
  %42 = load double, ptr %41, align 8
  %43 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 8
  %44 = load i32, ptr %43, align 8
  %45 = icmp eq i32 %44, 1
  br i1 %45, label %424, label %46

46:                                               ; preds = %24, %40
  %47 = phi double [ %42, %40 ], [ %39, %24 ]
  %48 = fadd double %47, -1.000000e-10
  %49 = select i1 %23, double %47, double %48
  %50 = fcmp ult double %49, %3
  br i1 %50, label %424, label %51

51:                                               ; preds = %46
  %52 = getelementptr inbounds %struct.World, ptr %20, i64 0, i32 34
  %53 = load ptr, ptr %52, align 8
  %54 = load i64, ptr %1, align 8
  %55 = shl nsw i64 %54, 1
  %56 = getelementptr inbounds i64, ptr %53, i64 %55
  %57 = load i64, ptr %2, align 8
  %58 = shl nsw i64 %57, 1
  %59 = getelementptr inbounds i64, ptr %53, i64 %58
  %60 = load i64, ptr %56, align 8
  %61 = icmp slt i64 %60, 0
  br i1 %61, label %62, label %70

62:                                               ; preds = %51
  %63 = load i64, ptr %59, align 8
  %64 = icmp slt i64 %63, 0
  br i1 %64, label %65, label %70

65:                                               ; preds = %62
  %66 = getelementptr inbounds i64, ptr %56, i64 1
  %67 = load i64, ptr %66, align 8
  %68 = getelementptr inbounds i64, ptr %59, i64 1
  %69 = load i64, ptr %68, align 8
  tail call fastcc void @two_leaves(ptr noundef nonnull %0, i64 noundef %67, i64 noundef %69)
  br label %424

70:                                               ; preds = %62, %51
  %71 = getelementptr inbounds %struct.World, ptr %20, i64 0, i32 33
  %72 = load ptr, ptr %71, align 8
  %73 = mul nsw i64 %57, 6
  %74 = getelementptr inbounds double, ptr %72, i64 %73
  %75 = getelementptr inbounds double, ptr %74, i64 3
  %76 = load double, ptr %75, align 8
  %77 = load double, ptr %74, align 8
  %78 = fsub double %76, %77
  %79 = getelementptr inbounds double, ptr %74, i64 4
  %80 = load double, ptr %79, align 8
  %81 = fadd double %78, %80
  %82 = getelementptr inbounds double, ptr %74, i64 1
  %83 = load double, ptr %82, align 8
  %84 = fsub double %81, %83
  %85 = getelementptr inbounds double, ptr %74, i64 5
  %86 = load double, ptr %85, align 8
  %87 = fadd double %84, %86
  %88 = getelementptr inbounds double, ptr %74, i64 2
  %89 = load double, ptr %88, align 8
  %90 = fsub double %87, %89
  %91 = fmul double %90, -1.000000e-01
  %92 = fcmp olt double %91, %3
  %93 = getelementptr inbounds %struct.Part, ptr %1, i64 0, i32 2
  %94 = load i64, ptr %93, align 8
  %95 = icmp slt i64 %94, 33
  %96 = select i1 %92, i1 %95, i1 false
  %97 = getelementptr inbounds %struct.Part, ptr %2, i64 0, i32 2
  %98 = load i64, ptr %97, align 8
  %99 = icmp slt i64 %98, 33
  %100 = select i1 %96, i1 %99, i1 false
  %101 = mul nsw i64 %98, %94
  %102 = icmp sgt i64 %101, 63
  %103 = select i1 %100, i1 %102, i1 false
  br i1 %103, label %104, label %147

104:                                              ; preds = %70
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %10) #19
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %11) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %12) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %13) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %14) #19
  %105 = getelementptr inbounds %struct.Two, ptr %0, i64 0, i32 4
  %106 = load double, ptr %105, align 8
  %107 = fadd double %49, %106
  %108 = getelementptr inbounds %struct.Part, ptr %1, i64 0, i32 1
  %109 = load i64, ptr %108, align 8
  store i64 0, ptr %10, align 8
  %110 = mul nsw i64 %94, 3
  %111 = getelementptr inbounds %struct.Core, ptr %10, i64 0, i32 1
  store i64 %110, ptr %111, align 8
  %112 = getelementptr inbounds %struct.Core, ptr %10, i64 0, i32 5
  %113 = getelementptr inbounds %struct.World, ptr %20, i64 0, i32 37
  %114 = load ptr, ptr %113, align 8
  %115 = mul nsw i64 %109, 3
  %116 = getelementptr inbounds double, ptr %114, i64 %115
  %117 = getelementptr inbounds %struct.Core, ptr %10, i64 0, i32 2
  store ptr %116, ptr %117, align 8
  %118 = getelementptr inbounds %struct.World, ptr %20, i64 0, i32 38
  %119 = load ptr, ptr %118, align 8
  %120 = getelementptr inbounds double, ptr %119, i64 %115
  %121 = getelementptr inbounds %struct.Core, ptr %10, i64 0, i32 3
  store ptr %120, ptr %121, align 8
  %122 = getelementptr inbounds %struct.World, ptr %20, i64 0, i32 39
  %123 = load ptr, ptr %122, align 8
  %124 = getelementptr inbounds double, ptr %123, i64 %115
  %125 = getelementptr inbounds %struct.Core, ptr %10, i64 0, i32 4
  store ptr %124, ptr %125, align 8
  %126 = getelementptr inbounds %struct.Part, ptr %2, i64 0, i32 1
  %127 = load i64, ptr %126, align 8
  store i64 0, ptr %11, align 8
  %128 = mul nsw i64 %98, 3
  %129 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 1
  store i64 %128, ptr %129, align 8
  %130 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 5
  store ptr @hull_core.still, ptr %130, align 8
  %131 = mul nsw i64 %127, 3
  %132 = getelementptr inbounds double, ptr %114, i64 %131
  %133 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 2
  store ptr %132, ptr %133, align 8
  %134 = getelementptr inbounds double, ptr %119, i64 %131
  %135 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 3
  store ptr %134, ptr %135, align 8
  %136 = getelementptr inbounds double, ptr %123, i64 %131
  %137 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 4
  store ptr %136, ptr %137, align 8
  %138 = getelementptr inbounds %struct.Two, ptr %0, i64 0, i32 2
  store ptr %138, ptr %112, align 8
  %139 = getelementptr inbounds %struct.Two, ptr %0, i64 0, i32 5
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %12, ptr noundef nonnull align 8 dereferenceable(24) %139, i64 24, i1 false)
  %140 = call fastcc i32 @bounds_from(ptr noundef nonnull %10, ptr noundef nonnull %11, ptr noundef nonnull %12, double noundef %107, double noundef %107, double noundef 0x3DA5FD7FE1796495, ptr noundef nonnull %13, ptr noundef nonnull %14, ptr noundef null, ptr noundef null, i32 noundef 0)
  %141 = icmp ne i32 %140, 0
  %142 = load double, ptr %13, align 8
  %143 = fcmp ogt double %142, %107
  %144 = select i1 %141, i1 %143, i1 false
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %14) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %13) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %12) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %11) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %10) #19
  br i1 %144, label %424, label %145

145:                                              ; preds = %104
  %146 = load i64, ptr %56, align 8
  br label %147

147:                                              ; preds = %145, %70
  %148 = phi i64 [ %146, %145 ], [ %60, %70 ]
  %149 = icmp sgt i64 %148, -1
  br i1 %149, label %151, label %150

150:                                              ; preds = %147
  call void @llvm.lifetime.start.p0(i64 48, ptr nonnull %15) #19
  br label %193

151:                                              ; preds = %147
  %152 = load i64, ptr %59, align 8
  %153 = icmp slt i64 %152, 0
  br i1 %153, label %154, label %155

154:                                              ; preds = %151
  call void @llvm.lifetime.start.p0(i64 48, ptr nonnull %15) #19
  br label %194

155:                                              ; preds = %151
  %156 = load ptr, ptr %71, align 8
  %157 = mul nsw i64 %54, 6
  %158 = getelementptr inbounds double, ptr %156, i64 %157
  %159 = getelementptr inbounds double, ptr %158, i64 3
  %160 = load double, ptr %159, align 8
  %161 = load double, ptr %158, align 8
  %162 = fsub double %160, %161
  %163 = getelementptr inbounds double, ptr %158, i64 4
  %164 = load double, ptr %163, align 8
  %165 = fadd double %162, %164
  %166 = getelementptr inbounds double, ptr %158, i64 1
  %167 = load double, ptr %166, align 8
  %168 = fsub double %165, %167
  %169 = getelementptr inbounds double, ptr %158, i64 5
  %170 = load double, ptr %169, align 8
  %171 = fadd double %168, %170
  %172 = getelementptr inbounds double, ptr %158, i64 2
  %173 = load double, ptr %172, align 8
  %174 = fsub double %171, %173
  %175 = getelementptr inbounds double, ptr %156, i64 %73
  %176 = getelementptr inbounds double, ptr %175, i64 3
  %177 = load double, ptr %176, align 8
  %178 = load double, ptr %175, align 8
  %179 = fsub double %177, %178
  %180 = getelementptr inbounds double, ptr %175, i64 4
  %181 = load double, ptr %180, align 8
  %182 = fadd double %179, %181
  %183 = getelementptr inbounds double, ptr %175, i64 1
  %184 = load double, ptr %183, align 8
  %185 = fsub double %182, %184
  %186 = getelementptr inbounds double, ptr %175, i64 5
  %187 = load double, ptr %186, align 8
  %188 = fadd double %185, %187
  %189 = getelementptr inbounds double, ptr %175, i64 2
  %190 = load double, ptr %189, align 8
  %191 = fsub double %188, %190
  %192 = fcmp ult double %174, %191
  call void @llvm.lifetime.start.p0(i64 48, ptr nonnull %15) #19
  br i1 %192, label %193, label %194

193:                                              ; preds = %150, %155
  br label %194

194:                                              ; preds = %155, %154, %193
  %195 = phi i64 [ %55, %155 ], [ %55, %154 ], [ %58, %193 ]
  %196 = phi i1 [ true, %155 ], [ true, %154 ], [ false, %193 ]
  %197 = phi ptr [ %1, %155 ], [ %1, %154 ], [ %2, %193 ]
  %198 = getelementptr inbounds i8, ptr %197, i64 8
  %199 = load i64, ptr %198, align 8
  %200 = getelementptr inbounds i8, ptr %197, i64 16
  %201 = load i64, ptr %200, align 8
  %202 = sdiv i64 %201, 2
  %203 = load ptr, ptr %52, align 8
  %204 = getelementptr inbounds i64, ptr %203, i64 %195
  %205 = load i64, ptr %204, align 8
  store i64 %205, ptr %15, align 16
  %206 = getelementptr inbounds %struct.Part, ptr %15, i64 0, i32 1
  store i64 %199, ptr %206, align 8
  %207 = getelementptr inbounds %struct.Part, ptr %15, i64 0, i32 2
  store i64 %202, ptr %207, align 16
  %208 = getelementptr inbounds %struct.Part, ptr %15, i64 1
  %209 = getelementptr inbounds i8, ptr %1, i64 8
  %210 = load i64, ptr %209, align 8
  %211 = getelementptr inbounds i8, ptr %2, i64 8
  %212 = load i64, ptr %211, align 8
  %213 = select i1 %196, i64 %210, i64 %212
  %214 = select i1 %196, i64 %54, i64 %57
  %215 = select i1 %196, i64 %94, i64 %98
  %216 = sdiv i64 %215, 2
  %217 = shl nsw i64 %214, 1
  %218 = or i64 %217, 1
  %219 = getelementptr inbounds i64, ptr %203, i64 %218
  %220 = load i64, ptr %219, align 8
  store i64 %220, ptr %208, align 8
  %221 = getelementptr inbounds %struct.Part, ptr %15, i64 1, i32 1
  %222 = add nsw i64 %216, %213
  store i64 %222, ptr %221, align 16
  %223 = getelementptr inbounds %struct.Part, ptr %15, i64 1, i32 2
  %224 = sub nsw i64 %215, %216
  store i64 %224, ptr %223, align 8
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %16) #19
  %225 = load ptr, ptr %71, align 8
  %226 = getelementptr inbounds %struct.Two, ptr %0, i64 0, i32 2
  %227 = getelementptr inbounds double, ptr %5, i64 1
  %228 = getelementptr inbounds double, ptr %5, i64 2
  %229 = getelementptr inbounds double, ptr %8, i64 1
  %230 = getelementptr inbounds double, ptr %8, i64 2
  %231 = getelementptr inbounds %struct.Two, ptr %0, i64 0, i32 3
  %232 = getelementptr inbounds double, ptr %6, i64 1
  %233 = getelementptr inbounds double, ptr %6, i64 2
  %234 = getelementptr inbounds %struct.Two, ptr %0, i64 0, i32 4
  %235 = load double, ptr %234, align 8
  br label %242

236:                                              ; preds = %404
  %237 = getelementptr inbounds [2 x double], ptr %16, i64 0, i64 1
  %238 = load double, ptr %237, align 8
  %239 = load double, ptr %16, align 16
  %240 = fcmp olt double %238, %239
  %241 = zext i1 %240 to i32
  br label %409

242:                                              ; preds = %194, %404
  %243 = phi i1 [ true, %194 ], [ false, %404 ]
  %244 = phi i64 [ 0, %194 ], [ 1, %404 ]
  %245 = getelementptr inbounds [2 x %struct.Part], ptr %15, i64 0, i64 %244
  %246 = select i1 %196, ptr %245, ptr %1
  %247 = load i64, ptr %246, align 8
  %248 = mul nsw i64 %247, 6
  %249 = getelementptr inbounds double, ptr %225, i64 %248
  %250 = select i1 %196, ptr %2, ptr %245
  %251 = load i64, ptr %250, align 8
  %252 = mul nsw i64 %251, 6
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %5) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #19
  br label %282

253:                                              ; preds = %282
  %254 = load double, ptr %5, align 16
  %255 = load double, ptr %227, align 8
  %256 = load double, ptr %228, align 16
  br label %257

257:                                              ; preds = %257, %253
  %258 = phi i64 [ 0, %253 ], [ %278, %257 ]
  %259 = mul nuw nsw i64 %258, 3
  %260 = getelementptr inbounds double, ptr %226, i64 %259
  %261 = load double, ptr %260, align 8
  %262 = fmul double %254, %261
  %263 = add nuw nsw i64 %259, 1
  %264 = getelementptr inbounds double, ptr %226, i64 %263
  %265 = load double, ptr %264, align 8
  %266 = fmul double %255, %265
  %267 = fadd double %262, %266
  %268 = add nuw nsw i64 %259, 2
  %269 = getelementptr inbounds double, ptr %226, i64 %268
  %270 = load double, ptr %269, align 8
  %271 = fmul double %256, %270
  %272 = fadd double %267, %271
  %273 = add nuw nsw i64 %258, 9
  %274 = getelementptr inbounds double, ptr %226, i64 %273
  %275 = load double, ptr %274, align 8
  %276 = fadd double %275, %272
  %277 = getelementptr inbounds double, ptr %8, i64 %258
  store double %276, ptr %277, align 8
  %278 = add nuw nsw i64 %258, 1
  %279 = icmp eq i64 %278, 3
  br i1 %279, label %280, label %257

280:                                              ; preds = %257
  %281 = getelementptr inbounds double, ptr %225, i64 %252
  br label %323

282:                                              ; preds = %282, %242
  %283 = phi i64 [ 0, %242 ], [ %295, %282 ]
  %284 = getelementptr inbounds double, ptr %249, i64 %283
  %285 = load double, ptr %284, align 8
  %286 = add nuw nsw i64 %283, 3
  %287 = getelementptr inbounds double, ptr %249, i64 %286
  %288 = load double, ptr %287, align 8
  %289 = fadd double %285, %288
  %290 = fmul double %289, 5.000000e-01
  %291 = getelementptr inbounds [3 x double], ptr %5, i64 0, i64 %283
  store double %290, ptr %291, align 8
  %292 = fsub double %288, %285
  %293 = fmul double %292, 5.000000e-01
  %294 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %283
  store double %293, ptr %294, align 8
  %295 = add nuw nsw i64 %283, 1
  %296 = icmp eq i64 %295, 3
  br i1 %296, label %253, label %282

297:                                              ; preds = %323
  %298 = load double, ptr %8, align 16
  %299 = load double, ptr %229, align 8
  %300 = load double, ptr %230, align 16
  br label %301

301:                                              ; preds = %301, %297
  %302 = phi i64 [ 0, %297 ], [ %317, %301 ]
  %303 = getelementptr inbounds double, ptr %226, i64 %302
  %304 = load double, ptr %303, align 8
  %305 = fmul double %298, %304
  %306 = add nuw nsw i64 %302, 3
  %307 = getelementptr inbounds double, ptr %226, i64 %306
  %308 = load double, ptr %307, align 8
  %309 = fmul double %299, %308
  %310 = fadd double %305, %309
  %311 = add nuw nsw i64 %302, 6
  %312 = getelementptr inbounds double, ptr %226, i64 %311
  %313 = load double, ptr %312, align 8
  %314 = fmul double %300, %313
  %315 = fadd double %310, %314
  %316 = getelementptr inbounds double, ptr %9, i64 %302
  store double %315, ptr %316, align 8
  %317 = add nuw nsw i64 %302, 1
  %318 = icmp eq i64 %317, 3
  br i1 %318, label %319, label %301

319:                                              ; preds = %301
  %320 = load double, ptr %6, align 16
  %321 = load double, ptr %232, align 8
  %322 = load double, ptr %233, align 16
  br label %342

323:                                              ; preds = %280, %323
  %324 = phi i64 [ %338, %323 ], [ 0, %280 ]
  %325 = getelementptr inbounds double, ptr %281, i64 %324
  %326 = load double, ptr %325, align 8
  %327 = add nuw nsw i64 %324, 3
  %328 = getelementptr inbounds double, ptr %281, i64 %327
  %329 = load double, ptr %328, align 8
  %330 = fadd double %326, %329
  %331 = fmul double %330, 5.000000e-01
  %332 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %324
  %333 = load double, ptr %332, align 8
  %334 = fsub double %333, %331
  store double %334, ptr %332, align 8
  %335 = fsub double %329, %326
  %336 = fmul double %335, 5.000000e-01
  %337 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %324
  store double %336, ptr %337, align 8
  %338 = add nuw nsw i64 %324, 1
  %339 = icmp eq i64 %338, 3
  br i1 %339, label %297, label %323

340:                                              ; preds = %366
  %341 = fcmp ogt double %376, 0.000000e+00
  br i1 %341, label %400, label %404

342:                                              ; preds = %366, %319
  %343 = phi i64 [ 0, %319 ], [ %385, %366 ]
  %344 = phi double [ 0.000000e+00, %319 ], [ %382, %366 ]
  %345 = phi double [ 0.000000e+00, %319 ], [ %384, %366 ]
  %346 = phi double [ 0xFFF0000000000000, %319 ], [ %376, %366 ]
  %347 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %343
  %348 = load double, ptr %347, align 8
  %349 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %343
  %350 = load double, ptr %349, align 8
  %351 = mul nuw nsw i64 %343, 3
  %352 = getelementptr inbounds double, ptr %231, i64 %351
  %353 = load double, ptr %352, align 8
  %354 = getelementptr inbounds double, ptr %352, i64 1
  %355 = load double, ptr %354, align 8
  %356 = fmul double %321, %355
  %357 = getelementptr inbounds double, ptr %352, i64 2
  %358 = load double, ptr %357, align 8
  %359 = fmul double %322, %358
  %360 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %343
  %361 = load double, ptr %360, align 8
  %362 = tail call double @llvm.fabs.f64(double %361)
  %363 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %343
  %364 = load double, ptr %363, align 8
  %365 = fsub double %362, %364
  br label %387

366:                                              ; preds = %387
  %367 = fmul double %320, %353
  %368 = fadd double %367, %356
  %369 = fadd double %368, %359
  %370 = tail call double @llvm.fabs.f64(double %348)
  %371 = fsub double %370, %350
  %372 = fsub double %371, %369
  %373 = fcmp ogt double %372, %346
  %374 = select i1 %373, double %372, double %346
  %375 = fcmp ogt double %397, %374
  %376 = select i1 %375, double %397, double %374
  %377 = fcmp ogt double %372, 0.000000e+00
  %378 = select i1 %377, double %372, double 0.000000e+00
  %379 = fcmp ogt double %397, 0.000000e+00
  %380 = select i1 %379, double %397, double 0.000000e+00
  %381 = fmul double %378, %378
  %382 = fadd double %344, %381
  %383 = fmul double %380, %380
  %384 = fadd double %345, %383
  %385 = add nuw nsw i64 %343, 1
  %386 = icmp eq i64 %385, 3
  br i1 %386, label %340, label %342

387:                                              ; preds = %387, %342
  %388 = phi i64 [ 0, %342 ], [ %398, %387 ]
  %389 = phi double [ %365, %342 ], [ %397, %387 ]
  %390 = mul nuw nsw i64 %388, 3
  %391 = add nuw nsw i64 %390, %343
  %392 = getelementptr inbounds %struct.Two, ptr %0, i64 0, i32 3, i64 %391
  %393 = load double, ptr %392, align 8
  %394 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %388
  %395 = load double, ptr %394, align 8
  %396 = fmul double %393, %395
  %397 = fsub double %389, %396
  %398 = add nuw nsw i64 %388, 1
  %399 = icmp eq i64 %398, 3
  br i1 %399, label %366, label %387

400:                                              ; preds = %340
  %401 = fcmp ogt double %384, %382
  %402 = select i1 %401, double %384, double %382
  %403 = tail call double @llvm.sqrt.f64(double %402)
  br label %404

404:                                              ; preds = %340, %400
  %405 = phi double [ %403, %400 ], [ %376, %340 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5) #19
  %406 = fsub double %405, %235
  %407 = getelementptr inbounds [2 x double], ptr %16, i64 0, i64 %244
  store double %406, ptr %407, align 8
  br i1 %243, label %242, label %236

408:                                              ; preds = %419
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %16) #19
  call void @llvm.lifetime.end.p0(i64 48, ptr nonnull %15) #19
  br label %424

409:                                              ; preds = %236, %419
  %410 = phi i1 [ true, %236 ], [ false, %419 ]
  %411 = phi i32 [ 0, %236 ], [ 1, %419 ]
  %412 = xor i32 %411, %241
  br i1 %196, label %413, label %416

413:                                              ; preds = %409
  %414 = zext i32 %412 to i64
  %415 = getelementptr inbounds [2 x %struct.Part], ptr %15, i64 0, i64 %414
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %17, ptr noundef nonnull align 8 dereferenceable(24) %415, i64 24, i1 false)
  br label %419

416:                                              ; preds = %409
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %17, ptr noundef nonnull align 8 dereferenceable(24) %1, i64 24, i1 false)
  %417 = zext i32 %412 to i64
  %418 = getelementptr inbounds [2 x %struct.Part], ptr %15, i64 0, i64 %417
  br label %419

419:                                              ; preds = %416, %413
  %420 = phi ptr [ %418, %416 ], [ %2, %413 ]
  %421 = phi i64 [ %417, %416 ], [ %414, %413 ]
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %18, ptr noundef nonnull align 8 dereferenceable(24) %420, i64 24, i1 false)
  %422 = getelementptr inbounds [2 x double], ptr %16, i64 0, i64 %421
  %423 = load double, ptr %422, align 8
  tail call fastcc void @two_nodes(ptr noundef nonnull %0, ptr noundef nonnull byval(%struct.Part) align 8 %17, ptr noundef nonnull byval(%struct.Part) align 8 %18, double noundef %423)
  br i1 %410, label %409, label %408

424:                                              ; preds = %104, %65, %408, %40, %46
  ret void
}

define internal fastcc i32 @tell_depth(ptr nocapture noundef %0, i64 noundef %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4) unnamed_addr #6 {
  %6 = alloca [2 x [3 x [3 x double]]], align 16
  %7 = alloca [2 x [3 x [3 x double]]], align 16
  %8 = alloca [3 x double], align 16
  %9 = alloca double, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %9) #19
  %10 = load ptr, ptr %0, align 8
  %11 = getelementptr inbounds %struct.World, ptr %10, i64 0, i32 15
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %14 = load i64, ptr %13, align 8
  %15 = getelementptr inbounds double, ptr %12, i64 %14
  %16 = load double, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %12, i64 %1
  %18 = load double, ptr %17, align 8
  %19 = fadd double %16, %18
  %20 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %21 = load ptr, ptr %20, align 8
  %22 = icmp eq ptr %21, null
  br i1 %22, label %23, label %25

23:                                               ; preds = %5
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  store i32 1, ptr %24, align 8
  br label %276

25:                                               ; preds = %5
  %26 = getelementptr inbounds %struct.World, ptr %10, i64 0, i32 12
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds i64, ptr %27, i64 %14
  %29 = load i64, ptr %28, align 8
  %30 = icmp eq i64 %29, 4
  br i1 %30, label %31, label %234

31:                                               ; preds = %25
  call void @llvm.lifetime.start.p0(i64 144, ptr nonnull %6) #19
  call void @llvm.lifetime.start.p0(i64 144, ptr nonnull %7) #19
  br label %36

32:                                               ; preds = %92
  %33 = getelementptr inbounds double, ptr %8, i64 1
  %34 = getelementptr inbounds double, ptr %8, i64 2
  %35 = getelementptr inbounds [2 x [3 x [3 x double]]], ptr %6, i64 0, i64 1
  br label %104

36:                                               ; preds = %92, %31
  %37 = phi i1 [ true, %31 ], [ false, %92 ]
  %38 = phi i64 [ 0, %31 ], [ 1, %92 ]
  %39 = select i1 %37, ptr %2, ptr %3
  %40 = getelementptr inbounds %struct.Core, ptr %39, i64 0, i32 1
  %41 = load i64, ptr %40, align 8
  %42 = getelementptr inbounds %struct.Core, ptr %39, i64 0, i32 2
  %43 = load ptr, ptr %42, align 8
  %44 = getelementptr inbounds %struct.Core, ptr %39, i64 0, i32 3
  %45 = load ptr, ptr %44, align 8
  %46 = getelementptr inbounds %struct.Core, ptr %39, i64 0, i32 4
  %47 = load ptr, ptr %46, align 8
  %48 = getelementptr inbounds %struct.Core, ptr %39, i64 0, i32 5
  %49 = load ptr, ptr %48, align 8
  br label %50

50:                                               ; preds = %84, %36
  %51 = phi i64 [ 0, %36 ], [ %85, %84 ]
  %52 = icmp sgt i64 %41, %51
  %53 = select i1 %52, i64 %51, i64 0
  %54 = getelementptr inbounds double, ptr %43, i64 %53
  %55 = load double, ptr %54, align 8
  %56 = getelementptr inbounds double, ptr %45, i64 %53
  %57 = load double, ptr %56, align 8
  %58 = getelementptr inbounds double, ptr %47, i64 %53
  %59 = load double, ptr %58, align 8
  %60 = getelementptr inbounds [2 x [3 x [3 x double]]], ptr %6, i64 0, i64 %38, i64 %51
  br label %61

61:                                               ; preds = %61, %50
  %62 = phi i64 [ 0, %50 ], [ %82, %61 ]
  %63 = mul nuw nsw i64 %62, 3
  %64 = getelementptr inbounds double, ptr %49, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = fmul double %55, %65
  %67 = add nuw nsw i64 %63, 1
  %68 = getelementptr inbounds double, ptr %49, i64 %67
  %69 = load double, ptr %68, align 8
  %70 = fmul double %57, %69
  %71 = fadd double %66, %70
  %72 = add nuw nsw i64 %63, 2
  %73 = getelementptr inbounds double, ptr %49, i64 %72
  %74 = load double, ptr %73, align 8
  %75 = fmul double %59, %74
  %76 = fadd double %71, %75
  %77 = add nuw nsw i64 %62, 9
  %78 = getelementptr inbounds double, ptr %49, i64 %77
  %79 = load double, ptr %78, align 8
  %80 = fadd double %79, %76
  %81 = getelementptr inbounds double, ptr %60, i64 %62
  store double %80, ptr %81, align 8
  %82 = add nuw nsw i64 %62, 1
  %83 = icmp eq i64 %82, 3
  br i1 %83, label %84, label %61

84:                                               ; preds = %61
  %85 = add nuw nsw i64 %51, 1
  %86 = icmp eq i64 %85, 3
  br i1 %86, label %87, label %50

87:                                               ; preds = %84, %93
  %88 = phi i64 [ %89, %93 ], [ 0, %84 ]
  %89 = add nuw nsw i64 %88, 1
  %90 = icmp eq i64 %89, 3
  %91 = select i1 %90, i64 0, i64 %89
  br label %94

92:                                               ; preds = %93
  br i1 %37, label %36, label %32

93:                                               ; preds = %94
  br i1 %90, label %92, label %87

94:                                               ; preds = %94, %87
  %95 = phi i64 [ 0, %87 ], [ %102, %94 ]
  %96 = getelementptr inbounds [2 x [3 x [3 x double]]], ptr %6, i64 0, i64 %38, i64 %91, i64 %95
  %97 = load double, ptr %96, align 8
  %98 = getelementptr inbounds [2 x [3 x [3 x double]]], ptr %6, i64 0, i64 %38, i64 %88, i64 %95
  %99 = load double, ptr %98, align 8
  %100 = fsub double %97, %99
  %101 = getelementptr inbounds [2 x [3 x [3 x double]]], ptr %7, i64 0, i64 %38, i64 %88, i64 %95
  store double %100, ptr %101, align 8
  %102 = add nuw nsw i64 %95, 1
  %103 = icmp eq i64 %102, 3
  br i1 %103, label %93, label %94

104:                                              ; preds = %227, %32
  %105 = phi i64 [ 0, %32 ], [ %229, %227 ]
  %106 = phi double [ 0x7FF0000000000000, %32 ], [ %228, %227 ]
  %107 = icmp ult i64 %105, 9
  br i1 %107, label %108, label %116

108:                                              ; preds = %104
  %109 = trunc i64 %105 to i8
  %110 = udiv i8 %109, 3
  %111 = zext i8 %110 to i64
  %112 = getelementptr inbounds [3 x [3 x double]], ptr %7, i64 0, i64 %111
  %113 = urem i8 %109, 3
  %114 = zext i8 %113 to i64
  %115 = getelementptr inbounds [2 x [3 x [3 x double]]], ptr %7, i64 0, i64 1, i64 %114
  br label %121

116:                                              ; preds = %104
  %117 = add nuw nsw i64 %105, 4294967287
  %118 = and i64 %117, 4294967295
  %119 = getelementptr inbounds [2 x [3 x [3 x double]]], ptr %7, i64 0, i64 %118
  %120 = getelementptr inbounds [2 x [3 x [3 x double]]], ptr %7, i64 0, i64 %118, i64 1
  br label %121

121:                                              ; preds = %116, %108
  %122 = phi ptr [ %112, %108 ], [ %119, %116 ]
  %123 = phi ptr [ %115, %108 ], [ %120, %116 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  br label %124

124:                                              ; preds = %124, %121
  %125 = phi i64 [ 0, %121 ], [ %126, %124 ]
  %126 = add nuw nsw i64 %125, 1
  %127 = icmp ult i64 %125, 2
  %128 = add nuw nsw i64 %125, 4294967294
  %129 = select i1 %127, i64 %126, i64 %128
  %130 = and i64 %129, 4294967295
  %131 = getelementptr inbounds double, ptr %122, i64 %130
  %132 = load double, ptr %131, align 8
  %133 = icmp eq i64 %125, 0
  %134 = add nuw nsw i64 %125, 4294967295
  %135 = and i64 %134, 4294967295
  %136 = select i1 %133, i64 2, i64 %135
  %137 = getelementptr inbounds double, ptr %123, i64 %136
  %138 = load double, ptr %137, align 8
  %139 = fmul double %132, %138
  %140 = getelementptr inbounds double, ptr %122, i64 %136
  %141 = load double, ptr %140, align 8
  %142 = getelementptr inbounds double, ptr %123, i64 %130
  %143 = load double, ptr %142, align 8
  %144 = fmul double %141, %143
  %145 = fsub double %139, %144
  %146 = getelementptr inbounds double, ptr %8, i64 %125
  store double %145, ptr %146, align 8
  %147 = icmp eq i64 %126, 3
  br i1 %147, label %148, label %124

148:                                              ; preds = %124
  %149 = load double, ptr %8, align 16
  %150 = fmul double %149, %149
  %151 = load double, ptr %33, align 8
  %152 = fmul double %151, %151
  %153 = fadd double %150, %152
  %154 = load double, ptr %34, align 16
  %155 = fmul double %154, %154
  %156 = fadd double %153, %155
  %157 = load double, ptr %122, align 8
  %158 = fmul double %157, %157
  %159 = getelementptr inbounds double, ptr %122, i64 1
  %160 = load double, ptr %159, align 8
  %161 = fmul double %160, %160
  %162 = fadd double %158, %161
  %163 = getelementptr inbounds double, ptr %122, i64 2
  %164 = load double, ptr %163, align 8
  %165 = fmul double %164, %164
  %166 = fadd double %162, %165
  %167 = fmul double %166, 0x3BC79CA10C924223
  %168 = load double, ptr %123, align 8
  %169 = fmul double %168, %168
  %170 = getelementptr inbounds double, ptr %123, i64 1
  %171 = load double, ptr %170, align 8
  %172 = fmul double %171, %171
  %173 = fadd double %169, %172
  %174 = getelementptr inbounds double, ptr %123, i64 2
  %175 = load double, ptr %174, align 8
  %176 = fmul double %175, %175
  %177 = fadd double %173, %176
  %178 = fmul double %167, %177
  %179 = fcmp ogt double %156, %178
  br i1 %179, label %185, label %227

180:                                              ; preds = %185
  %181 = fsub double %216, %218
  %182 = fsub double %220, %214
  %183 = tail call double @llvm.minnum.f64(double %181, double %182)
  %184 = fcmp ogt double %183, 0.000000e+00
  br i1 %184, label %223, label %227

185:                                              ; preds = %148, %185
  %186 = phi i64 [ %221, %185 ], [ 0, %148 ]
  %187 = phi double [ %218, %185 ], [ 0x7FF0000000000000, %148 ]
  %188 = phi double [ %214, %185 ], [ 0x7FF0000000000000, %148 ]
  %189 = phi double [ %220, %185 ], [ 0xFFF0000000000000, %148 ]
  %190 = phi double [ %216, %185 ], [ 0xFFF0000000000000, %148 ]
  %191 = getelementptr inbounds [3 x double], ptr %6, i64 %186
  %192 = load double, ptr %191, align 8
  %193 = fmul double %149, %192
  %194 = getelementptr inbounds double, ptr %191, i64 1
  %195 = load double, ptr %194, align 8
  %196 = fmul double %151, %195
  %197 = fadd double %193, %196
  %198 = getelementptr inbounds double, ptr %191, i64 2
  %199 = load double, ptr %198, align 8
  %200 = fmul double %154, %199
  %201 = fadd double %197, %200
  %202 = getelementptr inbounds [3 x double], ptr %35, i64 %186
  %203 = load double, ptr %202, align 8
  %204 = fmul double %149, %203
  %205 = getelementptr inbounds double, ptr %202, i64 1
  %206 = load double, ptr %205, align 8
  %207 = fmul double %151, %206
  %208 = fadd double %204, %207
  %209 = getelementptr inbounds double, ptr %202, i64 2
  %210 = load double, ptr %209, align 8
  %211 = fmul double %154, %210
  %212 = fadd double %208, %211
  %213 = fcmp olt double %201, %188
  %214 = select i1 %213, double %201, double %188
  %215 = fcmp ogt double %201, %190
  %216 = select i1 %215, double %201, double %190
  %217 = fcmp olt double %212, %187
  %218 = select i1 %217, double %212, double %187
  %219 = fcmp ogt double %212, %189
  %220 = select i1 %219, double %212, double %189
  %221 = add nuw nsw i64 %186, 1
  %222 = icmp eq i64 %221, 3
  br i1 %222, label %180, label %185

223:                                              ; preds = %180
  %224 = tail call double @llvm.sqrt.f64(double %156)
  %225 = fdiv double %183, %224
  %226 = tail call double @llvm.minnum.f64(double %225, double %106)
  br label %227

227:                                              ; preds = %223, %180, %148
  %228 = phi double [ %106, %148 ], [ %226, %223 ], [ 0.000000e+00, %180 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  %229 = add nuw nsw i64 %105, 1
  %230 = icmp eq i64 %229, 11
  br i1 %230, label %231, label %104

231:                                              ; preds = %227
  %232 = fcmp olt double %228, 0x7FF0000000000000
  %233 = select i1 %232, double %228, double 0.000000e+00
  call void @llvm.lifetime.end.p0(i64 144, ptr nonnull %7) #19
  call void @llvm.lifetime.end.p0(i64 144, ptr nonnull %6) #19
  br label %241

234:                                              ; preds = %25
  %235 = call fastcc i32 @depth_of(ptr noundef %2, ptr noundef %3, ptr noundef %4, ptr noundef nonnull %9, ptr noundef null, ptr noundef null, ptr noundef null)
  %236 = icmp eq i32 %235, 0
  br i1 %236, label %239, label %237

237:                                              ; preds = %234
  %238 = load double, ptr %9, align 8
  br label %241

239:                                              ; preds = %234
  %240 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  store i32 1, ptr %240, align 4
  br label %276

241:                                              ; preds = %237, %231
  %242 = phi double [ %238, %237 ], [ %233, %231 ]
  %243 = fneg double %242
  %244 = fsub double %243, %19
  %245 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %246 = load ptr, ptr %245, align 8
  %247 = icmp eq ptr %246, null
  %248 = getelementptr inbounds i64, ptr %246, i64 %1
  %249 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %250 = select i1 %247, ptr %249, ptr %248
  %251 = load i64, ptr %250, align 8
  %252 = getelementptr inbounds double, ptr %21, i64 %251
  %253 = load double, ptr %252, align 8
  %254 = fcmp ult double %244, %253
  br i1 %254, label %255, label %276

255:                                              ; preds = %241
  %256 = fsub double %244, %244
  %257 = fcmp ole double %256, 1.000000e-08
  %258 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %259 = load double, ptr %258, align 8
  %260 = tail call double @llvm.minnum.f64(double %253, double %259)
  %261 = fcmp ult double %244, %260
  br i1 %261, label %262, label %276

262:                                              ; preds = %255
  %263 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %264 = load ptr, ptr %263, align 8
  %265 = icmp ne ptr %264, null
  %266 = fcmp oeq double %253, 0x7FF0000000000000
  %267 = select i1 %265, i1 %266, i1 false
  br i1 %267, label %268, label %274

268:                                              ; preds = %262
  %269 = getelementptr inbounds %struct.World, ptr %10, i64 0, i32 45
  %270 = load ptr, ptr %269, align 8
  %271 = load i64, ptr %264, align 8
  %272 = add nsw i64 %271, 1
  store i64 %272, ptr %264, align 8
  %273 = getelementptr inbounds i64, ptr %270, i64 %271
  store i64 %251, ptr %273, align 8
  br label %274

274:                                              ; preds = %268, %262
  %275 = select i1 %257, double %244, double 0x7FF8000000000000
  store double %275, ptr %252, align 8
  br label %276

276:                                              ; preds = %274, %255, %241, %239, %23
  %277 = phi i32 [ 0, %239 ], [ 1, %23 ], [ 0, %241 ], [ 1, %255 ], [ 1, %274 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #19
  ret i32 %277
}

declare double @llvm.sqrt.f64(double) #4

define internal fastcc i32 @bounds_from(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef %2, double noundef %3, double noundef %4, double noundef %5, ptr nocapture noundef %6, ptr nocapture noundef %7, ptr noundef %8, ptr noundef %9, i32 noundef %10) unnamed_addr #13 {
  %12 = alloca %struct.Simplex, align 8
  %13 = alloca %struct.Simplex, align 8
  %14 = alloca [3 x double], align 16
  %15 = alloca [3 x double], align 16
  %16 = alloca [3 x double], align 16
  %17 = alloca [3 x double], align 16
  %18 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 224, ptr nonnull %12) #19
  call void @llvm.lifetime.start.p0(i64 224, ptr nonnull %13)
  %19 = icmp ne ptr %9, null
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %14) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %15) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %16) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %17) #19
  %20 = load double, ptr %2, align 8
  %21 = fmul double %20, %20
  %22 = getelementptr inbounds double, ptr %2, i64 1
  %23 = load double, ptr %22, align 8
  %24 = fmul double %23, %23
  %25 = fadd double %21, %24
  %26 = getelementptr inbounds double, ptr %2, i64 2
  %27 = load double, ptr %26, align 8
  %28 = fmul double %27, %27
  %29 = fadd double %25, %28
  %30 = tail call double @llvm.sqrt.f64(double %29)
  %31 = fcmp ogt double %30, 0.000000e+00
  br label %35

32:                                               ; preds = %44
  %33 = select i1 %19, ptr %9, ptr %12
  store double 0xFFF0000000000000, ptr %6, align 8
  store double 0x7FF0000000000000, ptr %7, align 8
  %34 = icmp ne i32 %10, 0
  br i1 %34, label %49, label %71

35:                                               ; preds = %11, %44
  %36 = phi i64 [ 0, %11 ], [ %47, %44 ]
  br i1 %31, label %37, label %41

37:                                               ; preds = %35
  %38 = getelementptr inbounds double, ptr %2, i64 %36
  %39 = load double, ptr %38, align 8
  %40 = fdiv double %39, %30
  br label %44

41:                                               ; preds = %35
  %42 = icmp eq i64 %36, 0
  %43 = uitofp i1 %42 to double
  br label %44

44:                                               ; preds = %41, %37
  %45 = phi double [ %40, %37 ], [ %43, %41 ]
  %46 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %36
  store double %45, ptr %46, align 8
  %47 = add nuw nsw i64 %36, 1
  %48 = icmp eq i64 %47, 3
  br i1 %48, label %32, label %35

49:                                               ; preds = %32
  %50 = call fastcc i32 @reduce(ptr noundef %33)
  %51 = getelementptr inbounds %struct.Simplex, ptr %12, i64 0, i32 3
  %52 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 3
  %53 = select i1 %19, ptr %52, ptr %51
  %54 = load double, ptr %53, align 8
  %55 = fmul double %54, %54
  %56 = getelementptr inbounds %struct.Simplex, ptr %12, i64 0, i32 3, i64 1
  %57 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 3, i64 1
  %58 = select i1 %19, ptr %57, ptr %56
  %59 = load double, ptr %58, align 8
  %60 = fmul double %59, %59
  %61 = fadd double %55, %60
  %62 = getelementptr inbounds %struct.Simplex, ptr %12, i64 0, i32 3, i64 2
  %63 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 3, i64 2
  %64 = select i1 %19, ptr %63, ptr %62
  %65 = load double, ptr %64, align 8
  %66 = fmul double %65, %65
  %67 = fadd double %61, %66
  %68 = call double @llvm.sqrt.f64(double %67)
  store double %68, ptr %7, align 8
  %69 = fcmp ogt double %68, 0x3EB0C6F7A0B5ED8D
  br i1 %69, label %70, label %233

70:                                               ; preds = %49
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %14, ptr noundef nonnull align 8 dereferenceable(24) %53, i64 24, i1 false)
  br label %75

71:                                               ; preds = %32
  %72 = getelementptr inbounds %struct.Simplex, ptr %12, i64 0, i32 2
  %73 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 2
  %74 = select i1 %19, ptr %73, ptr %72
  store i32 0, ptr %74, align 8
  br label %75

75:                                               ; preds = %71, %70
  %76 = getelementptr inbounds double, ptr %18, i64 1
  %77 = getelementptr inbounds [3 x double], ptr %15, i64 0, i64 1
  %78 = getelementptr inbounds [3 x double], ptr %16, i64 0, i64 1
  %79 = getelementptr inbounds double, ptr %18, i64 2
  %80 = getelementptr inbounds [3 x double], ptr %15, i64 0, i64 2
  %81 = getelementptr inbounds [3 x double], ptr %16, i64 0, i64 2
  %82 = getelementptr inbounds double, ptr %14, i64 1
  %83 = getelementptr inbounds double, ptr %14, i64 2
  %84 = icmp eq ptr %8, null
  %85 = getelementptr inbounds double, ptr %8, i64 1
  %86 = getelementptr inbounds double, ptr %8, i64 2
  %87 = getelementptr inbounds %struct.Plane, ptr %8, i64 0, i32 1
  %88 = getelementptr inbounds %struct.Simplex, ptr %12, i64 0, i32 2
  %89 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 2
  %90 = select i1 %19, ptr %89, ptr %88
  %91 = getelementptr inbounds %struct.Simplex, ptr %12, i64 0, i32 3
  %92 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 3
  %93 = select i1 %19, ptr %92, ptr %91
  %94 = getelementptr inbounds %struct.Simplex, ptr %12, i64 0, i32 3, i64 1
  %95 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 3, i64 1
  %96 = select i1 %19, ptr %95, ptr %94
  %97 = getelementptr inbounds %struct.Simplex, ptr %12, i64 0, i32 3, i64 2
  %98 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 3, i64 2
  %99 = select i1 %19, ptr %98, ptr %97
  br label %100

100:                                              ; preds = %75, %230
  %101 = phi i32 [ 0, %75 ], [ %231, %230 ]
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %2, ptr noundef nonnull align 16 dereferenceable(24) %14, i64 24, i1 false)
  br label %129

102:                                              ; preds = %129
  call fastcc void @support(ptr noundef %0, ptr noundef nonnull %17, ptr noundef nonnull %15)
  call fastcc void @support(ptr noundef %1, ptr noundef nonnull %14, ptr noundef nonnull %16)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %18) #19
  %103 = load double, ptr %15, align 16
  %104 = load double, ptr %16, align 16
  %105 = fsub double %103, %104
  store double %105, ptr %18, align 16
  %106 = load double, ptr %77, align 8
  %107 = load double, ptr %78, align 8
  %108 = fsub double %106, %107
  store double %108, ptr %76, align 8
  %109 = load double, ptr %80, align 16
  %110 = load double, ptr %81, align 16
  %111 = fsub double %109, %110
  store double %111, ptr %79, align 16
  %112 = load double, ptr %14, align 16
  %113 = fmul double %112, %112
  %114 = load double, ptr %82, align 8
  %115 = fmul double %114, %114
  %116 = fadd double %113, %115
  %117 = load double, ptr %83, align 16
  %118 = fmul double %117, %117
  %119 = fadd double %116, %118
  %120 = call double @llvm.sqrt.f64(double %119)
  %121 = fmul double %105, %112
  %122 = fmul double %108, %114
  %123 = fadd double %121, %122
  %124 = fmul double %111, %117
  %125 = fadd double %123, %124
  %126 = fdiv double %125, %120
  %127 = load double, ptr %6, align 8
  %128 = fcmp ogt double %126, %127
  br i1 %128, label %137, label %156

129:                                              ; preds = %100, %129
  %130 = phi i64 [ 0, %100 ], [ %135, %129 ]
  %131 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %130
  %132 = load double, ptr %131, align 8
  %133 = fneg double %132
  %134 = getelementptr inbounds [3 x double], ptr %17, i64 0, i64 %130
  store double %133, ptr %134, align 8
  %135 = add nuw nsw i64 %130, 1
  %136 = icmp eq i64 %135, 3
  br i1 %136, label %102, label %129

137:                                              ; preds = %102
  store double %126, ptr %6, align 8
  br i1 %84, label %156, label %148

138:                                              ; preds = %148
  %139 = load double, ptr %8, align 8
  %140 = fmul double %103, %139
  %141 = load double, ptr %85, align 8
  %142 = fmul double %141, %106
  %143 = fadd double %140, %142
  %144 = load double, ptr %86, align 8
  %145 = fmul double %144, %109
  %146 = fadd double %143, %145
  store double %146, ptr %87, align 8
  %147 = load double, ptr %6, align 8
  br label %156

148:                                              ; preds = %137, %148
  %149 = phi i64 [ %154, %148 ], [ 0, %137 ]
  %150 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %149
  %151 = load double, ptr %150, align 8
  %152 = fdiv double %151, %120
  %153 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %149
  store double %152, ptr %153, align 8
  %154 = add nuw nsw i64 %149, 1
  %155 = icmp eq i64 %154, 3
  br i1 %155, label %138, label %148

156:                                              ; preds = %137, %138, %102
  %157 = phi double [ %126, %137 ], [ %147, %138 ], [ %127, %102 ]
  %158 = fcmp ogt double %157, %3
  br i1 %158, label %228, label %159

159:                                              ; preds = %156
  %160 = load double, ptr %7, align 8
  %161 = fsub double %160, %157
  %162 = fcmp ugt double %161, %5
  br i1 %162, label %163, label %228

163:                                              ; preds = %159
  %164 = load i32, ptr %90, align 8
  %165 = icmp sgt i32 %164, 0
  br i1 %165, label %166, label %176

166:                                              ; preds = %163
  %167 = zext i32 %164 to i64
  br label %171

168:                                              ; preds = %171
  %169 = add nuw nsw i64 %172, 1
  %170 = icmp eq i64 %169, %167
  br i1 %170, label %176, label %171

171:                                              ; preds = %166, %168
  %172 = phi i64 [ 0, %166 ], [ %169, %168 ]
  %173 = getelementptr inbounds [4 x [3 x double]], ptr %33, i64 0, i64 %172
  %174 = call i32 @bcmp(ptr noundef nonnull dereferenceable(24) %173, ptr noundef nonnull dereferenceable(24) %18, i64 24)
  %175 = icmp eq i32 %174, 0
  br i1 %175, label %228, label %168

176:                                              ; preds = %168, %163
  br i1 %19, label %177, label %178

177:                                              ; preds = %176
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(224) %13, ptr noundef nonnull align 8 dereferenceable(224) %33, i64 224, i1 false)
  br label %178

178:                                              ; preds = %177, %176
  %179 = sext i32 %164 to i64
  %180 = getelementptr inbounds [4 x [3 x double]], ptr %33, i64 0, i64 %179
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %180, ptr noundef nonnull align 16 dereferenceable(24) %18, i64 24, i1 false)
  %181 = load i32, ptr %90, align 8
  %182 = add nsw i32 %181, 1
  store i32 %182, ptr %90, align 8
  %183 = sext i32 %181 to i64
  %184 = getelementptr inbounds %struct.Simplex, ptr %33, i64 0, i32 1, i64 %183
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %184, ptr noundef nonnull align 16 dereferenceable(24) %15, i64 24, i1 false)
  %185 = call fastcc i32 @reduce(ptr noundef %33)
  %186 = load double, ptr %93, align 8
  %187 = fmul double %186, %186
  %188 = load double, ptr %96, align 8
  %189 = fmul double %188, %188
  %190 = fadd double %187, %189
  %191 = load double, ptr %99, align 8
  %192 = fmul double %191, %191
  %193 = fadd double %190, %192
  %194 = call double @llvm.sqrt.f64(double %193)
  %195 = icmp eq i32 %185, 0
  br i1 %195, label %199, label %196

196:                                              ; preds = %178
  %197 = load double, ptr %6, align 8
  %198 = fcmp ugt double %197, 1.000000e-10
  br i1 %198, label %203, label %228

199:                                              ; preds = %178
  %200 = icmp ne i32 %101, 0
  %201 = select i1 %34, i1 true, i1 %200
  %202 = select i1 %19, i1 %201, i1 false
  br i1 %202, label %207, label %212

203:                                              ; preds = %196
  %204 = icmp ne i32 %101, 0
  %205 = select i1 %34, i1 true, i1 %204
  %206 = select i1 %19, i1 %205, i1 false
  br i1 %206, label %211, label %228

207:                                              ; preds = %199
  %208 = load double, ptr %7, align 8
  %209 = fcmp ult double %194, %208
  br i1 %209, label %212, label %210

210:                                              ; preds = %207
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(224) %33, ptr noundef nonnull align 8 dereferenceable(224) %13, i64 224, i1 false)
  br label %212

211:                                              ; preds = %203
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(224) %33, ptr noundef nonnull align 8 dereferenceable(224) %13, i64 224, i1 false)
  br label %228

212:                                              ; preds = %199, %207, %210
  %213 = phi i1 [ true, %210 ], [ %201, %199 ], [ true, %207 ]
  %214 = load double, ptr %7, align 8
  %215 = fcmp oge double %194, %214
  %216 = select i1 %215, i1 %213, i1 false
  br i1 %216, label %228, label %217

217:                                              ; preds = %212
  store double %194, ptr %7, align 8
  %218 = fcmp ugt double %194, 1.000000e-10
  br i1 %218, label %219, label %228

219:                                              ; preds = %217
  %220 = fcmp ugt double %194, %4
  br i1 %220, label %221, label %228

221:                                              ; preds = %219
  %222 = load double, ptr %6, align 8
  %223 = fsub double %194, %222
  %224 = fcmp ugt double %223, %5
  br i1 %224, label %225, label %228

225:                                              ; preds = %221
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %14, ptr noundef nonnull align 8 dereferenceable(24) %93, i64 24, i1 false)
  %226 = load i32, ptr %90, align 8
  %227 = icmp eq i32 %226, 4
  br i1 %227, label %228, label %230

228:                                              ; preds = %159, %156, %212, %217, %221, %219, %225, %171, %196, %203, %211
  %229 = phi i32 [ 1, %211 ], [ 0, %196 ], [ 1, %203 ], [ 1, %171 ], [ 1, %225 ], [ 1, %159 ], [ 1, %156 ], [ 1, %212 ], [ 0, %217 ], [ 1, %221 ], [ 1, %219 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %18) #19
  br label %233

230:                                              ; preds = %225
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %18) #19
  %231 = add nuw nsw i32 %101, 1
  %232 = icmp eq i32 %231, 300
  br i1 %232, label %233, label %100

233:                                              ; preds = %230, %228, %49
  %234 = phi i32 [ 0, %49 ], [ %229, %228 ], [ 1, %230 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %17) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %16) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %15) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %14) #19
  call void @llvm.lifetime.end.p0(i64 224, ptr nonnull %13)
  call void @llvm.lifetime.end.p0(i64 224, ptr nonnull %12) #19
  ret i32 %234
}

define internal fastcc i32 @reduce(ptr noundef %0) unnamed_addr #3 {
  %2 = alloca [3 x double], align 16
  %3 = alloca [3 x double], align 16
  %4 = alloca [3 x double], align 16
  %5 = alloca [3 x double], align 16
  %6 = alloca [3 x i32], align 4
  %7 = alloca [3 x double], align 16
  %8 = alloca [3 x double], align 16
  %9 = alloca [3 x double], align 16
  %10 = alloca [3 x double], align 16
  %11 = alloca [3 x i32], align 4
  %12 = getelementptr inbounds %struct.Simplex, ptr %0, i64 0, i32 2
  %13 = load i32, ptr %12, align 8
  switch i32 %13, label %78 [
    i32 1, label %14
    i32 2, label %16
  ]

14:                                               ; preds = %1
  %15 = getelementptr inbounds %struct.Simplex, ptr %0, i64 0, i32 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %15, ptr noundef nonnull align 8 dereferenceable(24) %0, i64 24, i1 false)
  br label %423

16:                                               ; preds = %1
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %4) #19
  br label %29

17:                                               ; preds = %29
  %18 = load double, ptr %4, align 16
  %19 = fmul double %18, %18
  %20 = getelementptr inbounds double, ptr %4, i64 1
  %21 = load double, ptr %20, align 8
  %22 = fmul double %21, %21
  %23 = fadd double %19, %22
  %24 = getelementptr inbounds double, ptr %4, i64 2
  %25 = load double, ptr %24, align 16
  %26 = fmul double %25, %25
  %27 = fadd double %23, %26
  %28 = fcmp ogt double %27, 0.000000e+00
  br i1 %28, label %39, label %53

29:                                               ; preds = %16, %29
  %30 = phi i64 [ 0, %16 ], [ %37, %29 ]
  %31 = getelementptr inbounds [4 x [3 x double]], ptr %0, i64 0, i64 1, i64 %30
  %32 = load double, ptr %31, align 8
  %33 = getelementptr inbounds [3 x double], ptr %0, i64 0, i64 %30
  %34 = load double, ptr %33, align 8
  %35 = fsub double %32, %34
  %36 = getelementptr inbounds [3 x double], ptr %4, i64 0, i64 %30
  store double %35, ptr %36, align 8
  %37 = add nuw nsw i64 %30, 1
  %38 = icmp eq i64 %37, 3
  br i1 %38, label %17, label %29

39:                                               ; preds = %17
  %40 = load double, ptr %0, align 8
  %41 = fmul double %18, %40
  %42 = getelementptr inbounds double, ptr %0, i64 1
  %43 = load double, ptr %42, align 8
  %44 = fmul double %21, %43
  %45 = fadd double %41, %44
  %46 = getelementptr inbounds double, ptr %0, i64 2
  %47 = load double, ptr %46, align 8
  %48 = fmul double %25, %47
  %49 = fadd double %45, %48
  %50 = fneg double %49
  %51 = fdiv double %50, %27
  %52 = fcmp ugt double %51, 0.000000e+00
  br i1 %52, label %55, label %53

53:                                               ; preds = %39, %17
  store i32 1, ptr %12, align 8
  %54 = getelementptr inbounds %struct.Simplex, ptr %0, i64 0, i32 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %54, ptr noundef nonnull align 8 dereferenceable(24) %0, i64 24, i1 false)
  br label %77

55:                                               ; preds = %39
  %56 = fcmp ult double %51, 1.000000e+00
  br i1 %56, label %62, label %57

57:                                               ; preds = %55
  %58 = getelementptr inbounds %struct.Simplex, ptr %0, i64 0, i32 1, i64 1
  %59 = getelementptr inbounds [4 x [3 x double]], ptr %0, i64 0, i64 1
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %0, ptr noundef nonnull align 8 dereferenceable(24) %59, i64 24, i1 false)
  %60 = getelementptr inbounds %struct.Simplex, ptr %0, i64 0, i32 1, i64 0
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %60, ptr noundef nonnull align 8 dereferenceable(24) %58, i64 24, i1 false)
  store i32 1, ptr %12, align 8
  %61 = getelementptr inbounds %struct.Simplex, ptr %0, i64 0, i32 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %61, ptr noundef nonnull align 8 dereferenceable(24) %59, i64 24, i1 false)
  br label %77

62:                                               ; preds = %55
  %63 = getelementptr inbounds [4 x [3 x double]], ptr %0, i64 0, i64 1
  %64 = getelementptr inbounds %struct.Simplex, ptr %0, i64 0, i32 3
  br label %65

65:                                               ; preds = %65, %62
  %66 = phi i64 [ 0, %62 ], [ %75, %65 ]
  %67 = getelementptr inbounds double, ptr %0, i64 %66
  %68 = load double, ptr %67, align 8
  %69 = getelementptr inbounds double, ptr %63, i64 %66
  %70 = load double, ptr %69, align 8
  %71 = fsub double %70, %68
  %72 = fmul double %51, %71
  %73 = fadd double %68, %72
  %74 = getelementptr inbounds double, ptr %64, i64 %66
  store double %73, ptr %74, align 8
  %75 = add nuw nsw i64 %66, 1
  %76 = icmp eq i64 %75, 3
  br i1 %76, label %77, label %65

77:                                               ; preds = %65, %57, %53
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %4) #19
  br label %423

78:                                               ; preds = %1
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %5)
  call void @llvm.lifetime.start.p0(i64 12, ptr nonnull %6) #19
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 4 dereferenceable(12) %6, ptr noundef nonnull align 4 dereferenceable(12) @__const.reduce.chosen, i64 12, i1 false)
  %79 = icmp eq i32 %13, 4
  %80 = zext i1 %79 to i32
  %81 = icmp ne i32 %13, 3
  %82 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 1
  %83 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 2
  %84 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 2
  %85 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 1
  %86 = getelementptr inbounds double, ptr %9, i64 1
  %87 = getelementptr inbounds double, ptr %9, i64 2
  %88 = getelementptr inbounds double, ptr %2, i64 1
  %89 = getelementptr inbounds double, ptr %2, i64 2
  %90 = getelementptr inbounds double, ptr %3, i64 1
  %91 = getelementptr inbounds double, ptr %3, i64 2
  %92 = getelementptr inbounds double, ptr %10, i64 1
  %93 = getelementptr inbounds double, ptr %10, i64 2
  br label %97

94:                                               ; preds = %373
  %95 = icmp ne i32 %374, 0
  %96 = select i1 %79, i1 %95, i1 false
  br i1 %96, label %421, label %380

97:                                               ; preds = %78, %373
  %98 = phi i64 [ 0, %78 ], [ %377, %373 ]
  %99 = phi double [ 0x7FF0000000000000, %78 ], [ %376, %373 ]
  %100 = phi i32 [ 7, %78 ], [ %375, %373 ]
  %101 = phi i32 [ %80, %78 ], [ %374, %373 ]
  %102 = getelementptr inbounds [4 x [3 x i32]], ptr @reduce.face, i64 0, i64 %98
  %103 = load i32, ptr %102, align 4
  %104 = sext i32 %103 to i64
  %105 = getelementptr inbounds [4 x [3 x double]], ptr %0, i64 0, i64 %104
  %106 = getelementptr inbounds [4 x [3 x i32]], ptr @reduce.face, i64 0, i64 %98, i64 1
  %107 = load i32, ptr %106, align 4
  %108 = sext i32 %107 to i64
  %109 = getelementptr inbounds [4 x [3 x double]], ptr %0, i64 0, i64 %108
  %110 = getelementptr inbounds [4 x [3 x i32]], ptr @reduce.face, i64 0, i64 %98, i64 2
  %111 = load i32, ptr %110, align 4
  %112 = sext i32 %111 to i64
  %113 = getelementptr inbounds [4 x [3 x double]], ptr %0, i64 0, i64 %112
  br i1 %79, label %114, label %179

114:                                              ; preds = %97
  %115 = add i32 %103, %107
  %116 = add i32 %115, %111
  %117 = sub i32 6, %116
  %118 = sext i32 %117 to i64
  %119 = getelementptr inbounds [4 x [3 x double]], ptr %0, i64 0, i64 %118
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #19
  br label %145

120:                                              ; preds = %145
  %121 = load double, ptr %82, align 8
  %122 = load double, ptr %83, align 16
  %123 = fmul double %121, %122
  %124 = load double, ptr %84, align 16
  %125 = load double, ptr %85, align 8
  %126 = fmul double %124, %125
  %127 = fsub double %123, %126
  %128 = load double, ptr %8, align 16
  %129 = fmul double %124, %128
  %130 = load double, ptr %7, align 16
  %131 = fmul double %122, %130
  %132 = fsub double %129, %131
  %133 = fmul double %125, %130
  %134 = fmul double %121, %128
  %135 = fsub double %133, %134
  %136 = load double, ptr %9, align 16
  %137 = fmul double %127, %136
  %138 = load double, ptr %86, align 8
  %139 = fmul double %132, %138
  %140 = fadd double %137, %139
  %141 = load double, ptr %87, align 16
  %142 = fmul double %135, %141
  %143 = fadd double %140, %142
  %144 = fcmp oeq double %143, 0.000000e+00
  br i1 %144, label %177, label %163

145:                                              ; preds = %114, %145
  %146 = phi i64 [ 0, %114 ], [ %161, %145 ]
  %147 = getelementptr inbounds double, ptr %109, i64 %146
  %148 = load double, ptr %147, align 8
  %149 = getelementptr inbounds double, ptr %105, i64 %146
  %150 = load double, ptr %149, align 8
  %151 = fsub double %148, %150
  %152 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %146
  store double %151, ptr %152, align 8
  %153 = getelementptr inbounds double, ptr %113, i64 %146
  %154 = load double, ptr %153, align 8
  %155 = fsub double %154, %150
  %156 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %146
  store double %155, ptr %156, align 8
  %157 = getelementptr inbounds double, ptr %119, i64 %146
  %158 = load double, ptr %157, align 8
  %159 = fsub double %158, %150
  %160 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %146
  store double %159, ptr %160, align 8
  %161 = add nuw nsw i64 %146, 1
  %162 = icmp eq i64 %161, 3
  br i1 %162, label %120, label %145

163:                                              ; preds = %120
  %164 = load double, ptr %105, align 8
  %165 = fmul double %127, %164
  %166 = getelementptr inbounds double, ptr %105, i64 1
  %167 = load double, ptr %166, align 8
  %168 = fmul double %132, %167
  %169 = fadd double %165, %168
  %170 = getelementptr inbounds double, ptr %105, i64 2
  %171 = load double, ptr %170, align 8
  %172 = fmul double %135, %171
  %173 = fadd double %169, %172
  %174 = fneg double %173
  %175 = fmul double %143, %174
  %176 = fcmp ult double %175, 0.000000e+00
  br i1 %176, label %177, label %178

177:                                              ; preds = %163, %120
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  br label %179

178:                                              ; preds = %163
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  br label %373

179:                                              ; preds = %177, %97
  %180 = phi i32 [ %101, %97 ], [ 0, %177 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %10) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %2) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %3) #19
  br label %238

181:                                              ; preds = %238
  %182 = load double, ptr %2, align 16
  %183 = load double, ptr %105, align 8
  %184 = fmul double %182, %183
  %185 = load double, ptr %88, align 8
  %186 = getelementptr inbounds double, ptr %105, i64 1
  %187 = load double, ptr %186, align 8
  %188 = fmul double %185, %187
  %189 = fadd double %184, %188
  %190 = load double, ptr %89, align 16
  %191 = getelementptr inbounds double, ptr %105, i64 2
  %192 = load double, ptr %191, align 8
  %193 = fmul double %190, %192
  %194 = fadd double %189, %193
  %195 = fneg double %194
  %196 = load double, ptr %3, align 16
  %197 = fmul double %183, %196
  %198 = load double, ptr %90, align 8
  %199 = fmul double %187, %198
  %200 = fadd double %197, %199
  %201 = load double, ptr %91, align 16
  %202 = fmul double %192, %201
  %203 = fadd double %200, %202
  %204 = fneg double %203
  %205 = load double, ptr %109, align 8
  %206 = fmul double %182, %205
  %207 = getelementptr inbounds double, ptr %109, i64 1
  %208 = load double, ptr %207, align 8
  %209 = fmul double %185, %208
  %210 = fadd double %206, %209
  %211 = getelementptr inbounds double, ptr %109, i64 2
  %212 = load double, ptr %211, align 8
  %213 = fmul double %190, %212
  %214 = fadd double %210, %213
  %215 = fmul double %196, %205
  %216 = fmul double %198, %208
  %217 = fadd double %215, %216
  %218 = fmul double %201, %212
  %219 = fadd double %217, %218
  %220 = load double, ptr %113, align 8
  %221 = fmul double %182, %220
  %222 = getelementptr inbounds double, ptr %113, i64 1
  %223 = load double, ptr %222, align 8
  %224 = fmul double %185, %223
  %225 = fadd double %221, %224
  %226 = getelementptr inbounds double, ptr %113, i64 2
  %227 = load double, ptr %226, align 8
  %228 = fmul double %190, %227
  %229 = fadd double %225, %228
  %230 = fmul double %196, %220
  %231 = fmul double %198, %223
  %232 = fadd double %230, %231
  %233 = fmul double %201, %227
  %234 = fadd double %232, %233
  %235 = fcmp oge double %194, 0.000000e+00
  %236 = fcmp oge double %203, 0.000000e+00
  %237 = select i1 %235, i1 %236, i1 false
  br i1 %237, label %355, label %252

238:                                              ; preds = %238, %179
  %239 = phi i64 [ 0, %179 ], [ %250, %238 ]
  %240 = getelementptr inbounds double, ptr %109, i64 %239
  %241 = load double, ptr %240, align 8
  %242 = getelementptr inbounds double, ptr %105, i64 %239
  %243 = load double, ptr %242, align 8
  %244 = fsub double %241, %243
  %245 = getelementptr inbounds [3 x double], ptr %2, i64 0, i64 %239
  store double %244, ptr %245, align 8
  %246 = getelementptr inbounds double, ptr %113, i64 %239
  %247 = load double, ptr %246, align 8
  %248 = fsub double %247, %243
  %249 = getelementptr inbounds [3 x double], ptr %3, i64 0, i64 %239
  store double %248, ptr %249, align 8
  %250 = add nuw nsw i64 %239, 1
  %251 = icmp eq i64 %250, 3
  br i1 %251, label %181, label %238

252:                                              ; preds = %181
  %253 = fcmp ugt double %214, 0.000000e+00
  %254 = fcmp ult double %219, %214
  %255 = select i1 %253, i1 true, i1 %254
  br i1 %255, label %256, label %355

256:                                              ; preds = %252
  %257 = fcmp ugt double %234, 0.000000e+00
  %258 = fcmp ult double %229, %234
  %259 = select i1 %257, i1 true, i1 %258
  br i1 %259, label %260, label %355

260:                                              ; preds = %256
  %261 = fmul double %194, %219
  %262 = fmul double %203, %214
  %263 = fsub double %261, %262
  %264 = fcmp ole double %263, 0.000000e+00
  %265 = fcmp ole double %194, 0.000000e+00
  %266 = select i1 %264, i1 %265, i1 false
  %267 = fcmp oge double %214, 0.000000e+00
  %268 = select i1 %266, i1 %267, i1 false
  br i1 %268, label %269, label %284

269:                                              ; preds = %260
  %270 = fsub double %214, %194
  %271 = fdiv double %195, %270
  br label %272

272:                                              ; preds = %272, %269
  %273 = phi i64 [ 0, %269 ], [ %282, %272 ]
  %274 = getelementptr inbounds double, ptr %105, i64 %273
  %275 = load double, ptr %274, align 8
  %276 = getelementptr inbounds double, ptr %109, i64 %273
  %277 = load double, ptr %276, align 8
  %278 = fsub double %277, %275
  %279 = fmul double %271, %278
  %280 = fadd double %275, %279
  %281 = getelementptr inbounds double, ptr %10, i64 %273
  store double %280, ptr %281, align 8
  %282 = add nuw nsw i64 %273, 1
  %283 = icmp eq i64 %282, 3
  br i1 %283, label %358, label %272

284:                                              ; preds = %260
  %285 = fmul double %203, %229
  %286 = fmul double %194, %234
  %287 = fsub double %285, %286
  %288 = fcmp ole double %287, 0.000000e+00
  %289 = fcmp ole double %203, 0.000000e+00
  %290 = select i1 %288, i1 %289, i1 false
  %291 = fcmp oge double %234, 0.000000e+00
  %292 = select i1 %290, i1 %291, i1 false
  br i1 %292, label %293, label %308

293:                                              ; preds = %284
  %294 = fsub double %234, %203
  %295 = fdiv double %204, %294
  br label %296

296:                                              ; preds = %296, %293
  %297 = phi i64 [ 0, %293 ], [ %306, %296 ]
  %298 = getelementptr inbounds double, ptr %105, i64 %297
  %299 = load double, ptr %298, align 8
  %300 = getelementptr inbounds double, ptr %113, i64 %297
  %301 = load double, ptr %300, align 8
  %302 = fsub double %301, %299
  %303 = fmul double %295, %302
  %304 = fadd double %299, %303
  %305 = getelementptr inbounds double, ptr %10, i64 %297
  store double %304, ptr %305, align 8
  %306 = add nuw nsw i64 %297, 1
  %307 = icmp eq i64 %306, 3
  br i1 %307, label %358, label %296

308:                                              ; preds = %284
  %309 = fmul double %214, %234
  %310 = fmul double %219, %229
  %311 = fsub double %309, %310
  %312 = fcmp ugt double %311, 0.000000e+00
  br i1 %312, label %335, label %313

313:                                              ; preds = %308
  %314 = fsub double %214, %219
  %315 = fcmp ult double %314, 0.000000e+00
  %316 = fsub double %234, %229
  %317 = fcmp ult double %316, 0.000000e+00
  %318 = select i1 %315, i1 true, i1 %317
  br i1 %318, label %335, label %319

319:                                              ; preds = %313
  %320 = fsub double %314, %229
  %321 = fadd double %234, %320
  %322 = fdiv double %314, %321
  br label %323

323:                                              ; preds = %323, %319
  %324 = phi i64 [ 0, %319 ], [ %333, %323 ]
  %325 = getelementptr inbounds double, ptr %109, i64 %324
  %326 = load double, ptr %325, align 8
  %327 = getelementptr inbounds double, ptr %113, i64 %324
  %328 = load double, ptr %327, align 8
  %329 = fsub double %328, %326
  %330 = fmul double %322, %329
  %331 = fadd double %326, %330
  %332 = getelementptr inbounds double, ptr %10, i64 %324
  store double %331, ptr %332, align 8
  %333 = add nuw nsw i64 %324, 1
  %334 = icmp eq i64 %333, 3
  br i1 %334, label %358, label %323

335:                                              ; preds = %313, %308
  %336 = fadd double %311, %287
  %337 = fadd double %263, %336
  %338 = fdiv double %287, %337
  %339 = fdiv double %263, %337
  br label %340

340:                                              ; preds = %340, %335
  %341 = phi i64 [ 0, %335 ], [ %353, %340 ]
  %342 = getelementptr inbounds double, ptr %105, i64 %341
  %343 = load double, ptr %342, align 8
  %344 = getelementptr inbounds [3 x double], ptr %2, i64 0, i64 %341
  %345 = load double, ptr %344, align 8
  %346 = fmul double %338, %345
  %347 = fadd double %343, %346
  %348 = getelementptr inbounds [3 x double], ptr %3, i64 0, i64 %341
  %349 = load double, ptr %348, align 8
  %350 = fmul double %339, %349
  %351 = fadd double %347, %350
  %352 = getelementptr inbounds double, ptr %10, i64 %341
  store double %351, ptr %352, align 8
  %353 = add nuw nsw i64 %341, 1
  %354 = icmp eq i64 %353, 3
  br i1 %354, label %358, label %340

355:                                              ; preds = %256, %252, %181
  %356 = phi ptr [ %105, %181 ], [ %109, %252 ], [ %113, %256 ]
  %357 = phi i32 [ 1, %181 ], [ 2, %252 ], [ 4, %256 ]
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %10, ptr noundef nonnull align 8 dereferenceable(24) %356, i64 24, i1 false)
  br label %358

358:                                              ; preds = %323, %340, %296, %272, %355
  %359 = phi i32 [ %357, %355 ], [ 3, %272 ], [ 5, %296 ], [ 7, %340 ], [ 6, %323 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %3) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %2) #19
  %360 = load double, ptr %10, align 16
  %361 = fmul double %360, %360
  %362 = load double, ptr %92, align 8
  %363 = fmul double %362, %362
  %364 = fadd double %361, %363
  %365 = load double, ptr %93, align 16
  %366 = fmul double %365, %365
  %367 = fadd double %364, %366
  %368 = fcmp olt double %367, %99
  br i1 %368, label %369, label %370

369:                                              ; preds = %358
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %5, ptr noundef nonnull align 16 dereferenceable(24) %10, i64 24, i1 false)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 4 dereferenceable(12) %6, ptr noundef nonnull align 4 dereferenceable(12) %102, i64 12, i1 false)
  br label %370

370:                                              ; preds = %369, %358
  %371 = phi i32 [ %359, %369 ], [ %100, %358 ]
  %372 = phi double [ %367, %369 ], [ %99, %358 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %10) #19
  br label %373

373:                                              ; preds = %178, %370
  %374 = phi i32 [ %180, %370 ], [ %101, %178 ]
  %375 = phi i32 [ %371, %370 ], [ %100, %178 ]
  %376 = phi double [ %372, %370 ], [ %99, %178 ]
  %377 = add nuw nsw i64 %98, 1
  %378 = icmp ult i64 %98, 3
  %379 = select i1 %81, i1 %378, i1 false
  br i1 %379, label %97, label %94

380:                                              ; preds = %94
  %381 = fcmp oeq double %376, 0x7FF0000000000000
  br i1 %381, label %421, label %382

382:                                              ; preds = %380
  call void @llvm.lifetime.start.p0(i64 12, ptr nonnull %11) #19
  br label %404

383:                                              ; preds = %417
  %384 = icmp sgt i32 %418, 0
  br i1 %384, label %385, label %402

385:                                              ; preds = %383
  %386 = zext i32 %418 to i64
  br label %387

387:                                              ; preds = %399, %385
  %388 = phi i64 [ 0, %385 ], [ %400, %399 ]
  %389 = getelementptr inbounds i32, ptr %11, i64 %388
  %390 = load i32, ptr %389, align 4
  %391 = zext i32 %390 to i64
  %392 = icmp eq i64 %388, %391
  br i1 %392, label %399, label %393

393:                                              ; preds = %387
  %394 = getelementptr inbounds [4 x [3 x double]], ptr %0, i64 0, i64 %388
  %395 = sext i32 %390 to i64
  %396 = getelementptr inbounds [4 x [3 x double]], ptr %0, i64 0, i64 %395
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %394, ptr noundef nonnull align 8 dereferenceable(24) %396, i64 24, i1 false)
  %397 = getelementptr inbounds %struct.Simplex, ptr %0, i64 0, i32 1, i64 %388
  %398 = getelementptr inbounds %struct.Simplex, ptr %0, i64 0, i32 1, i64 %395
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %397, ptr noundef nonnull align 8 dereferenceable(24) %398, i64 24, i1 false)
  br label %399

399:                                              ; preds = %393, %387
  %400 = add nuw nsw i64 %388, 1
  %401 = icmp eq i64 %400, %386
  br i1 %401, label %402, label %387

402:                                              ; preds = %399, %383
  store i32 %418, ptr %12, align 8
  %403 = getelementptr inbounds %struct.Simplex, ptr %0, i64 0, i32 3
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %403, ptr noundef nonnull align 16 dereferenceable(24) %5, i64 24, i1 false)
  call void @llvm.lifetime.end.p0(i64 12, ptr nonnull %11) #19
  br label %421

404:                                              ; preds = %382, %417
  %405 = phi i64 [ 0, %382 ], [ %419, %417 ]
  %406 = phi i32 [ 0, %382 ], [ %418, %417 ]
  %407 = trunc i64 %405 to i32
  %408 = shl nuw nsw i32 1, %407
  %409 = and i32 %408, %375
  %410 = icmp eq i32 %409, 0
  br i1 %410, label %417, label %411

411:                                              ; preds = %404
  %412 = getelementptr inbounds [3 x i32], ptr %6, i64 0, i64 %405
  %413 = load i32, ptr %412, align 4
  %414 = add nsw i32 %406, 1
  %415 = sext i32 %406 to i64
  %416 = getelementptr inbounds [3 x i32], ptr %11, i64 0, i64 %415
  store i32 %413, ptr %416, align 4
  br label %417

417:                                              ; preds = %404, %411
  %418 = phi i32 [ %414, %411 ], [ %406, %404 ]
  %419 = add nuw nsw i64 %405, 1
  %420 = icmp eq i64 %419, 3
  br i1 %420, label %383, label %404

421:                                              ; preds = %380, %94, %402
  %422 = phi i32 [ 0, %402 ], [ 1, %94 ], [ 0, %380 ]
  call void @llvm.lifetime.end.p0(i64 12, ptr nonnull %6) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5)
  br label %423

423:                                              ; preds = %421, %77, %14
  %424 = phi i32 [ 0, %14 ], [ 0, %77 ], [ %422, %421 ]
  ret i32 %424
}

define internal fastcc void @one_leaf(ptr nocapture noundef %0, i64 noundef %1, i64 noundef %2, double noundef %3, ptr nocapture noundef readonly %4) unnamed_addr #6 {
  %6 = alloca [9 x double], align 16
  %7 = alloca [3 x double], align 16
  %8 = alloca double, align 8
  %9 = alloca double, align 8
  %10 = alloca %struct.Core, align 8
  %11 = alloca %struct.Plane, align 8
  %12 = alloca %struct.Simplex, align 8
  %13 = load ptr, ptr %0, align 8
  %14 = getelementptr inbounds %struct.World, ptr %13, i64 0, i32 36
  %15 = load ptr, ptr %14, align 8
  %16 = mul nsw i64 %2, 9
  %17 = getelementptr inbounds double, ptr %15, i64 %16
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %6) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %8) #19
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %9) #19
  %18 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %19 = load ptr, ptr %18, align 8
  %20 = icmp eq ptr %19, null
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %10) #19
  br label %21

21:                                               ; preds = %51, %5
  %22 = phi i64 [ 0, %5 ], [ %55, %51 ]
  %23 = phi i32 [ 1, %5 ], [ %54, %51 ]
  %24 = mul nuw nsw i64 %22, 3
  br label %34

25:                                               ; preds = %34
  %26 = add nuw nsw i64 %22, 3
  %27 = getelementptr inbounds double, ptr %17, i64 %26
  %28 = load double, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %17, i64 %22
  %30 = load double, ptr %29, align 8
  %31 = fsub double %28, %30
  %32 = tail call double @llvm.fabs.f64(double %31)
  %33 = fcmp olt double %32, 3.000000e-07
  br i1 %33, label %44, label %51

34:                                               ; preds = %34, %21
  %35 = phi i64 [ 0, %21 ], [ %42, %34 ]
  %36 = mul nuw nsw i64 %35, 3
  %37 = add nuw nsw i64 %36, %22
  %38 = getelementptr inbounds double, ptr %17, i64 %37
  %39 = load double, ptr %38, align 8
  %40 = add nuw nsw i64 %35, %24
  %41 = getelementptr inbounds double, ptr %6, i64 %40
  store double %39, ptr %41, align 8
  %42 = add nuw nsw i64 %35, 1
  %43 = icmp eq i64 %42, 3
  br i1 %43, label %25, label %34

44:                                               ; preds = %25
  %45 = add nuw nsw i64 %22, 6
  %46 = getelementptr inbounds double, ptr %17, i64 %45
  %47 = load double, ptr %46, align 8
  %48 = fsub double %47, %30
  %49 = tail call double @llvm.fabs.f64(double %48)
  %50 = fcmp olt double %49, 3.000000e-07
  br label %51

51:                                               ; preds = %44, %25
  %52 = phi i1 [ false, %25 ], [ %50, %44 ]
  %53 = zext i1 %52 to i32
  %54 = and i32 %23, %53
  %55 = add nuw nsw i64 %22, 1
  %56 = icmp eq i64 %55, 3
  br i1 %56, label %57, label %21

57:                                               ; preds = %51
  %58 = select i1 %20, double %3, double 0xFFF0000000000000
  store i64 0, ptr %10, align 8
  %59 = icmp eq i32 %54, 0
  %60 = select i1 %59, i64 3, i64 1
  %61 = getelementptr inbounds %struct.Core, ptr %10, i64 0, i32 1
  store i64 %60, ptr %61, align 8
  %62 = getelementptr inbounds %struct.Core, ptr %10, i64 0, i32 5
  store ptr @place.still, ptr %62, align 8
  %63 = getelementptr inbounds %struct.Core, ptr %10, i64 0, i32 2
  store ptr %6, ptr %63, align 8
  %64 = getelementptr inbounds double, ptr %6, i64 3
  %65 = getelementptr inbounds %struct.Core, ptr %10, i64 0, i32 3
  store ptr %64, ptr %65, align 8
  %66 = getelementptr inbounds double, ptr %6, i64 6
  %67 = getelementptr inbounds %struct.Core, ptr %10, i64 0, i32 4
  store ptr %66, ptr %67, align 8
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %11) #19
  %68 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %11, ptr noundef nonnull align 8 dereferenceable(32) %68, i64 32, i1 false)
  call void @llvm.lifetime.start.p0(i64 224, ptr nonnull %12) #19
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %7, ptr noundef nonnull align 8 dereferenceable(24) %4, i64 24, i1 false)
  %69 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %70 = load i64, ptr %69, align 8
  %71 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %72 = load ptr, ptr %71, align 8
  %73 = getelementptr inbounds %struct.World, ptr %13, i64 0, i32 15
  %74 = load ptr, ptr %73, align 8
  %75 = getelementptr inbounds double, ptr %74, i64 %70
  %76 = load double, ptr %75, align 8
  %77 = getelementptr inbounds double, ptr %74, i64 %1
  %78 = load double, ptr %77, align 8
  %79 = fadd double %76, %78
  %80 = fadd double %79, %3
  %81 = fadd double %58, %79
  %82 = call fastcc i32 @bounds_from(ptr noundef %72, ptr noundef nonnull %10, ptr noundef nonnull %7, double noundef %80, double noundef %81, double noundef 0x3DA5FD7FE1796495, ptr noundef nonnull %8, ptr noundef nonnull %9, ptr noundef nonnull %11, ptr noundef nonnull %12, i32 noundef 0)
  %83 = load double, ptr %8, align 8
  %84 = fsub double %83, %79
  %85 = load double, ptr %9, align 8
  %86 = fsub double %85, %79
  %87 = icmp eq i32 %82, 0
  br i1 %87, label %88, label %94

88:                                               ; preds = %57
  %89 = load ptr, ptr %71, align 8
  %90 = call fastcc i32 @tell_depth(ptr noundef nonnull %0, i64 noundef %1, ptr noundef %89, ptr noundef nonnull %10, ptr noundef nonnull %12)
  %91 = icmp eq i32 %90, 0
  br i1 %91, label %147, label %92

92:                                               ; preds = %88
  %93 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  store i64 %2, ptr %93, align 8
  br label %147

94:                                               ; preds = %57
  %95 = fcmp ugt double %84, %3
  br i1 %95, label %147, label %96

96:                                               ; preds = %94
  %97 = load ptr, ptr %18, align 8
  %98 = icmp eq ptr %97, null
  br i1 %98, label %131, label %99

99:                                               ; preds = %96
  %100 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %101 = load ptr, ptr %100, align 8
  %102 = icmp eq ptr %101, null
  %103 = getelementptr inbounds i64, ptr %101, i64 %1
  %104 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %105 = select i1 %102, ptr %104, ptr %103
  %106 = load i64, ptr %105, align 8
  %107 = getelementptr inbounds double, ptr %97, i64 %106
  %108 = fsub double %86, %84
  %109 = fcmp ole double %108, 1.000000e-08
  %110 = select i1 %109, double %86, double %84
  %111 = load double, ptr %107, align 8
  %112 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %113 = load double, ptr %112, align 8
  %114 = call double @llvm.minnum.f64(double %111, double %113)
  %115 = fcmp ult double %110, %114
  br i1 %115, label %116, label %146

116:                                              ; preds = %99
  %117 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %118 = load ptr, ptr %117, align 8
  %119 = icmp ne ptr %118, null
  %120 = fcmp oeq double %111, 0x7FF0000000000000
  %121 = select i1 %119, i1 %120, i1 false
  br i1 %121, label %122, label %129

122:                                              ; preds = %116
  %123 = load ptr, ptr %0, align 8
  %124 = getelementptr inbounds %struct.World, ptr %123, i64 0, i32 45
  %125 = load ptr, ptr %124, align 8
  %126 = load i64, ptr %118, align 8
  %127 = add nsw i64 %126, 1
  store i64 %127, ptr %118, align 8
  %128 = getelementptr inbounds i64, ptr %125, i64 %126
  store i64 %106, ptr %128, align 8
  br label %129

129:                                              ; preds = %122, %116
  %130 = select i1 %109, double %86, double 0x7FF8000000000000
  store double %130, ptr %107, align 8
  br label %144

131:                                              ; preds = %96
  %132 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %133 = load double, ptr %132, align 8
  %134 = fcmp ult double %133, %86
  br i1 %134, label %137, label %135

135:                                              ; preds = %131
  %136 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  store i32 1, ptr %136, align 8
  br label %144

137:                                              ; preds = %131
  %138 = fcmp ult double %133, %84
  br i1 %138, label %144, label %139

139:                                              ; preds = %137
  %140 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %141 = load i32, ptr %140, align 8
  %142 = icmp eq i32 %141, 0
  br i1 %142, label %143, label %144

143:                                              ; preds = %139
  store i32 2, ptr %140, align 8
  br label %144

144:                                              ; preds = %129, %135, %143, %139, %137
  %145 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  store i64 %2, ptr %145, align 8
  br label %146

146:                                              ; preds = %99, %144
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %68, ptr noundef nonnull align 8 dereferenceable(32) %11, i64 32, i1 false)
  br label %147

147:                                              ; preds = %94, %146, %88, %92
  call void @llvm.lifetime.end.p0(i64 224, ptr nonnull %12) #19
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %11) #19
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %10) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #19
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %6) #19
  ret void
}

define internal fastcc i32 @leaves(ptr noundef %0, i64 noundef %1, ptr noundef %2, ptr noundef %3) unnamed_addr #10 {
  %5 = alloca [3 x double], align 16
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  %8 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 33
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 34
  br label %11

11:                                               ; preds = %50, %4
  %12 = phi i32 [ 0, %4 ], [ %54, %50 ]
  %13 = phi i64 [ %1, %4 ], [ %53, %50 ]
  %14 = mul nsw i64 %13, 6
  %15 = getelementptr inbounds double, ptr %9, i64 %14
  br label %18

16:                                               ; preds = %18
  %17 = fcmp ogt double %39, %41
  br i1 %17, label %161, label %44

18:                                               ; preds = %11, %18
  %19 = phi i64 [ 0, %11 ], [ %42, %18 ]
  %20 = phi double [ 0.000000e+00, %11 ], [ %39, %18 ]
  %21 = phi double [ 0x7FF0000000000000, %11 ], [ %41, %18 ]
  %22 = getelementptr inbounds double, ptr %15, i64 %19
  %23 = load double, ptr %22, align 8
  %24 = getelementptr inbounds double, ptr %2, i64 %19
  %25 = load double, ptr %24, align 8
  %26 = fsub double %23, %25
  %27 = getelementptr inbounds double, ptr %3, i64 %19
  %28 = load double, ptr %27, align 8
  %29 = fdiv double %26, %28
  %30 = add nuw nsw i64 %19, 3
  %31 = getelementptr inbounds double, ptr %15, i64 %30
  %32 = load double, ptr %31, align 8
  %33 = fsub double %32, %25
  %34 = fdiv double %33, %28
  %35 = fcmp ogt double %29, %34
  %36 = select i1 %35, double %29, double %34
  %37 = select i1 %35, double %34, double %29
  %38 = fcmp ogt double %37, %20
  %39 = select i1 %38, double %37, double %20
  %40 = fcmp olt double %36, %21
  %41 = select i1 %40, double %36, double %21
  %42 = add nuw nsw i64 %19, 1
  %43 = icmp eq i64 %42, 3
  br i1 %43, label %16, label %18

44:                                               ; preds = %16
  %45 = load ptr, ptr %10, align 8
  %46 = shl nsw i64 %13, 1
  %47 = getelementptr inbounds i64, ptr %45, i64 %46
  %48 = load i64, ptr %47, align 8
  %49 = icmp sgt i64 %48, -1
  br i1 %49, label %50, label %55

50:                                               ; preds = %44
  %51 = tail call fastcc i32 @leaves(ptr noundef nonnull %0, i64 noundef %48, ptr noundef nonnull %2, ptr noundef nonnull %3)
  %52 = getelementptr inbounds i64, ptr %47, i64 1
  %53 = load i64, ptr %52, align 8
  %54 = add nsw i32 %51, %12
  br label %11

55:                                               ; preds = %44
  %56 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 36
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds i64, ptr %47, i64 1
  %59 = load i64, ptr %58, align 8
  %60 = mul nsw i64 %59, 9
  %61 = getelementptr inbounds double, ptr %57, i64 %60
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %5) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  br label %93

62:                                               ; preds = %93
  %63 = getelementptr inbounds double, ptr %3, i64 1
  %64 = load double, ptr %63, align 8
  %65 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 2
  %66 = load double, ptr %65, align 16
  %67 = fmul double %64, %66
  %68 = getelementptr inbounds double, ptr %3, i64 2
  %69 = load double, ptr %68, align 8
  %70 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 1
  %71 = load double, ptr %70, align 8
  %72 = fmul double %69, %71
  %73 = fsub double %67, %72
  %74 = load double, ptr %6, align 16
  %75 = fmul double %69, %74
  %76 = load double, ptr %3, align 8
  %77 = fmul double %66, %76
  %78 = fsub double %75, %77
  %79 = fmul double %71, %76
  %80 = fmul double %64, %74
  %81 = fsub double %79, %80
  %82 = load double, ptr %5, align 16
  %83 = fmul double %73, %82
  %84 = getelementptr inbounds double, ptr %5, i64 1
  %85 = load double, ptr %84, align 8
  %86 = fmul double %85, %78
  %87 = fadd double %83, %86
  %88 = getelementptr inbounds double, ptr %5, i64 2
  %89 = load double, ptr %88, align 16
  %90 = fmul double %81, %89
  %91 = fadd double %87, %90
  %92 = fcmp oeq double %91, 0.000000e+00
  br i1 %92, label %159, label %113

93:                                               ; preds = %55, %93
  %94 = phi i64 [ 0, %55 ], [ %111, %93 ]
  %95 = add nuw nsw i64 %94, 3
  %96 = getelementptr inbounds double, ptr %61, i64 %95
  %97 = load double, ptr %96, align 8
  %98 = getelementptr inbounds double, ptr %61, i64 %94
  %99 = load double, ptr %98, align 8
  %100 = fsub double %97, %99
  %101 = getelementptr inbounds [3 x double], ptr %5, i64 0, i64 %94
  store double %100, ptr %101, align 8
  %102 = add nuw nsw i64 %94, 6
  %103 = getelementptr inbounds double, ptr %61, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = fsub double %104, %99
  %106 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %94
  store double %105, ptr %106, align 8
  %107 = getelementptr inbounds double, ptr %2, i64 %94
  %108 = load double, ptr %107, align 8
  %109 = fsub double %108, %99
  %110 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %94
  store double %109, ptr %110, align 8
  %111 = add nuw nsw i64 %94, 1
  %112 = icmp eq i64 %111, 3
  br i1 %112, label %62, label %93

113:                                              ; preds = %62
  %114 = load double, ptr %7, align 16
  %115 = fmul double %73, %114
  %116 = getelementptr inbounds double, ptr %7, i64 1
  %117 = load double, ptr %116, align 8
  %118 = fmul double %78, %117
  %119 = fadd double %115, %118
  %120 = getelementptr inbounds double, ptr %7, i64 2
  %121 = load double, ptr %120, align 16
  %122 = fmul double %81, %121
  %123 = fadd double %119, %122
  %124 = fdiv double %123, %91
  %125 = fcmp olt double %124, 0.000000e+00
  %126 = fcmp ogt double %124, 1.000000e+00
  %127 = or i1 %125, %126
  br i1 %127, label %159, label %128

128:                                              ; preds = %113
  %129 = fmul double %117, %89
  %130 = fmul double %121, %85
  %131 = fsub double %129, %130
  %132 = fmul double %82, %121
  %133 = fmul double %114, %89
  %134 = fsub double %132, %133
  %135 = fmul double %114, %85
  %136 = fmul double %82, %117
  %137 = fsub double %135, %136
  %138 = fmul double %76, %131
  %139 = fmul double %64, %134
  %140 = fadd double %139, %138
  %141 = fmul double %69, %137
  %142 = fadd double %141, %140
  %143 = fdiv double %142, %91
  %144 = fcmp olt double %143, 0.000000e+00
  %145 = fadd double %124, %143
  %146 = fcmp ogt double %145, 1.000000e+00
  %147 = select i1 %144, i1 true, i1 %146
  br i1 %147, label %159, label %148

148:                                              ; preds = %128
  %149 = fmul double %74, %131
  %150 = fmul double %134, %71
  %151 = fadd double %149, %150
  %152 = fmul double %137, %66
  %153 = fadd double %151, %152
  %154 = fdiv double %153, %91
  %155 = fcmp ugt double %154, 0.000000e+00
  br i1 %155, label %156, label %159

156:                                              ; preds = %148
  %157 = fcmp olt double %91, 0.000000e+00
  %158 = select i1 %157, i32 1, i32 -1
  br label %159

159:                                              ; preds = %156, %148, %128, %113, %62
  %160 = phi i32 [ 0, %62 ], [ 0, %113 ], [ %158, %156 ], [ 0, %148 ], [ 0, %128 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5) #19
  br label %161

161:                                              ; preds = %16, %159
  %162 = phi i32 [ %160, %159 ], [ 0, %16 ]
  %163 = add nsw i32 %162, %12
  ret i32 %163
}

define internal fastcc double @in_front(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1) unnamed_addr #14 {
  %3 = load double, ptr %0, align 8
  %4 = load double, ptr %1, align 8
  %5 = fmul double %3, %4
  %6 = getelementptr inbounds double, ptr %0, i64 1
  %7 = load double, ptr %6, align 8
  %8 = getelementptr inbounds double, ptr %1, i64 1
  %9 = load double, ptr %8, align 8
  %10 = fmul double %7, %9
  %11 = fadd double %5, %10
  %12 = getelementptr inbounds double, ptr %0, i64 2
  %13 = load double, ptr %12, align 8
  %14 = getelementptr inbounds double, ptr %1, i64 2
  %15 = load double, ptr %14, align 8
  %16 = fmul double %13, %15
  %17 = fadd double %11, %16
  %18 = getelementptr inbounds double, ptr %1, i64 3
  %19 = load double, ptr %18, align 8
  %20 = fmul double %3, %19
  %21 = getelementptr inbounds double, ptr %1, i64 4
  %22 = load double, ptr %21, align 8
  %23 = fmul double %7, %22
  %24 = fadd double %20, %23
  %25 = getelementptr inbounds double, ptr %1, i64 5
  %26 = load double, ptr %25, align 8
  %27 = fmul double %13, %26
  %28 = fadd double %24, %27
  %29 = getelementptr inbounds double, ptr %1, i64 6
  %30 = load double, ptr %29, align 8
  %31 = fmul double %3, %30
  %32 = getelementptr inbounds double, ptr %1, i64 7
  %33 = load double, ptr %32, align 8
  %34 = fmul double %7, %33
  %35 = fadd double %31, %34
  %36 = getelementptr inbounds double, ptr %1, i64 8
  %37 = load double, ptr %36, align 8
  %38 = fmul double %13, %37
  %39 = fadd double %35, %38
  %40 = fcmp ogt double %17, %28
  %41 = select i1 %40, double %17, double %28
  %42 = getelementptr inbounds %struct.Plane, ptr %0, i64 0, i32 1
  %43 = load double, ptr %42, align 8
  %44 = fcmp ogt double %39, %41
  %45 = select i1 %44, double %39, double %41
  %46 = fsub double %43, %45
  ret double %46
}

define internal fastcc i32 @make_face(ptr nocapture noundef readonly %0, i32 noundef %1, i32 noundef %2, i32 noundef %3, ptr nocapture noundef %4) unnamed_addr #8 {
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  %8 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  %9 = sext i32 %2 to i64
  %10 = sext i32 %1 to i64
  %11 = sext i32 %3 to i64
  br label %49

12:                                               ; preds = %49, %12
  %13 = phi i64 [ %14, %12 ], [ 0, %49 ]
  %14 = add nuw nsw i64 %13, 1
  %15 = icmp ult i64 %13, 2
  %16 = add nuw nsw i64 %13, 4294967294
  %17 = select i1 %15, i64 %14, i64 %16
  %18 = and i64 %17, 4294967295
  %19 = getelementptr inbounds double, ptr %6, i64 %18
  %20 = load double, ptr %19, align 8
  %21 = icmp eq i64 %13, 0
  %22 = add nuw nsw i64 %13, 4294967295
  %23 = and i64 %22, 4294967295
  %24 = select i1 %21, i64 2, i64 %23
  %25 = getelementptr inbounds double, ptr %7, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = fmul double %20, %26
  %28 = getelementptr inbounds double, ptr %6, i64 %24
  %29 = load double, ptr %28, align 8
  %30 = getelementptr inbounds double, ptr %7, i64 %18
  %31 = load double, ptr %30, align 8
  %32 = fmul double %29, %31
  %33 = fsub double %27, %32
  %34 = getelementptr inbounds double, ptr %8, i64 %13
  store double %33, ptr %34, align 8
  %35 = icmp eq i64 %14, 3
  br i1 %35, label %36, label %12

36:                                               ; preds = %12
  %37 = load double, ptr %8, align 16
  %38 = fmul double %37, %37
  %39 = getelementptr inbounds double, ptr %8, i64 1
  %40 = load double, ptr %39, align 8
  %41 = fmul double %40, %40
  %42 = fadd double %38, %41
  %43 = getelementptr inbounds double, ptr %8, i64 2
  %44 = load double, ptr %43, align 16
  %45 = fmul double %44, %44
  %46 = fadd double %42, %45
  %47 = tail call double @llvm.sqrt.f64(double %46)
  %48 = fcmp ogt double %47, 1.000000e-18
  br i1 %48, label %86, label %94

49:                                               ; preds = %5, %49
  %50 = phi i64 [ 0, %5 ], [ %61, %49 ]
  %51 = getelementptr inbounds [3 x double], ptr %0, i64 %9, i64 %50
  %52 = load double, ptr %51, align 8
  %53 = getelementptr inbounds [3 x double], ptr %0, i64 %10, i64 %50
  %54 = load double, ptr %53, align 8
  %55 = fsub double %52, %54
  %56 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %50
  store double %55, ptr %56, align 8
  %57 = getelementptr inbounds [3 x double], ptr %0, i64 %11, i64 %50
  %58 = load double, ptr %57, align 8
  %59 = fsub double %58, %54
  %60 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %50
  store double %59, ptr %60, align 8
  %61 = add nuw nsw i64 %50, 1
  %62 = icmp eq i64 %61, 3
  br i1 %62, label %12, label %49

63:                                               ; preds = %86
  store i32 %1, ptr %4, align 8
  %64 = getelementptr inbounds [3 x i32], ptr %4, i64 0, i64 1
  store i32 %2, ptr %64, align 4
  %65 = getelementptr inbounds [3 x i32], ptr %4, i64 0, i64 2
  store i32 %3, ptr %65, align 8
  %66 = getelementptr inbounds %struct.Face, ptr %4, i64 0, i32 1
  %67 = getelementptr inbounds [3 x double], ptr %0, i64 %10
  %68 = load double, ptr %66, align 8
  %69 = load double, ptr %67, align 8
  %70 = fmul double %68, %69
  %71 = getelementptr inbounds %struct.Face, ptr %4, i64 0, i32 1, i64 1
  %72 = load double, ptr %71, align 8
  %73 = getelementptr inbounds double, ptr %67, i64 1
  %74 = load double, ptr %73, align 8
  %75 = fmul double %72, %74
  %76 = fadd double %70, %75
  %77 = getelementptr inbounds %struct.Face, ptr %4, i64 0, i32 1, i64 2
  %78 = load double, ptr %77, align 8
  %79 = getelementptr inbounds double, ptr %67, i64 2
  %80 = load double, ptr %79, align 8
  %81 = fmul double %78, %80
  %82 = fadd double %76, %81
  %83 = getelementptr inbounds %struct.Face, ptr %4, i64 0, i32 2
  store double %82, ptr %83, align 8
  %84 = fcmp ogt double %82, -1.000000e-13
  %85 = zext i1 %84 to i32
  br label %94

86:                                               ; preds = %36, %86
  %87 = phi i64 [ %92, %86 ], [ 0, %36 ]
  %88 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %87
  %89 = load double, ptr %88, align 8
  %90 = fdiv double %89, %47
  %91 = getelementptr inbounds %struct.Face, ptr %4, i64 0, i32 1, i64 %87
  store double %90, ptr %91, align 8
  %92 = add nuw nsw i64 %87, 1
  %93 = icmp eq i64 %92, 3
  br i1 %93, label %63, label %86

94:                                               ; preds = %36, %63
  %95 = phi i32 [ %85, %63 ], [ 0, %36 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #19
  ret i32 %95
}

declare double @llvm.sin.f64(double) #4

declare double @llvm.cos.f64(double) #4

define internal fastcc double @lowest(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, ptr nocapture noundef %4) unnamed_addr #3 {
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  %8 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #19
  br label %15

9:                                                ; preds = %15
  %10 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 12
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i64, ptr %11, i64 %1
  %13 = load i64, ptr %12, align 8
  %14 = icmp eq i64 %13, 4
  br i1 %14, label %25, label %94

15:                                               ; preds = %5, %15
  %16 = phi i64 [ 0, %5 ], [ %23, %15 ]
  %17 = mul nuw nsw i64 %16, 3
  %18 = add nuw nsw i64 %17, 2
  %19 = getelementptr inbounds double, ptr %3, i64 %18
  %20 = load double, ptr %19, align 8
  %21 = fneg double %20
  %22 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %16
  store double %21, ptr %22, align 8
  %23 = add nuw nsw i64 %16, 1
  %24 = icmp eq i64 %23, 3
  br i1 %24, label %9, label %15

25:                                               ; preds = %9
  %26 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 42
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds i64, ptr %29, i64 %1
  %31 = load i64, ptr %30, align 8
  %32 = mul nsw i64 %31, 12
  %33 = getelementptr inbounds double, ptr %27, i64 %32
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #19
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %8, i8 0, i64 24, i1 false)
  %34 = load double, ptr %6, align 16
  %35 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 1
  %36 = load double, ptr %35, align 8
  %37 = fneg double %36
  %38 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 2
  %39 = load double, ptr %38, align 16
  br label %40

40:                                               ; preds = %40, %25
  %41 = phi i64 [ 0, %25 ], [ %56, %40 ]
  %42 = getelementptr inbounds double, ptr %33, i64 %41
  %43 = load double, ptr %42, align 8
  %44 = add nuw nsw i64 %41, 3
  %45 = getelementptr inbounds double, ptr %33, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = fmul double %46, %37
  %48 = fmul double %34, %43
  %49 = fsub double %47, %48
  %50 = add nuw nsw i64 %41, 6
  %51 = getelementptr inbounds double, ptr %33, i64 %50
  %52 = load double, ptr %51, align 8
  %53 = fmul double %39, %52
  %54 = fsub double %49, %53
  %55 = getelementptr inbounds double, ptr %7, i64 %41
  store double %54, ptr %55, align 8
  %56 = add nuw nsw i64 %41, 1
  %57 = icmp eq i64 %56, 3
  br i1 %57, label %58, label %40

58:                                               ; preds = %40
  %59 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 35
  %60 = load ptr, ptr %59, align 8
  %61 = getelementptr inbounds i64, ptr %60, i64 %1
  %62 = load i64, ptr %61, align 8
  %63 = call fastcc double @lowest_of(ptr noundef %0, i64 noundef %62, ptr noundef nonnull %7, double noundef 0x7FF0000000000000, ptr noundef nonnull %8)
  %64 = getelementptr inbounds double, ptr %8, i64 1
  %65 = getelementptr inbounds double, ptr %8, i64 2
  %66 = load double, ptr %8, align 16
  %67 = load double, ptr %64, align 8
  %68 = load double, ptr %65, align 16
  br label %69

69:                                               ; preds = %69, %58
  %70 = phi i64 [ 0, %58 ], [ %90, %69 ]
  %71 = mul nuw nsw i64 %70, 3
  %72 = getelementptr inbounds double, ptr %33, i64 %71
  %73 = load double, ptr %72, align 8
  %74 = fmul double %73, %66
  %75 = add nuw nsw i64 %71, 1
  %76 = getelementptr inbounds double, ptr %33, i64 %75
  %77 = load double, ptr %76, align 8
  %78 = fmul double %77, %67
  %79 = fadd double %74, %78
  %80 = add nuw nsw i64 %71, 2
  %81 = getelementptr inbounds double, ptr %33, i64 %80
  %82 = load double, ptr %81, align 8
  %83 = fmul double %82, %68
  %84 = fadd double %79, %83
  %85 = add nuw nsw i64 %70, 9
  %86 = getelementptr inbounds double, ptr %33, i64 %85
  %87 = load double, ptr %86, align 8
  %88 = fadd double %87, %84
  %89 = getelementptr inbounds double, ptr %4, i64 %70
  store double %88, ptr %89, align 8
  %90 = add nuw nsw i64 %70, 1
  %91 = icmp eq i64 %90, 3
  br i1 %91, label %92, label %69

92:                                               ; preds = %69
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #19
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #19
  br label %93

93:                                               ; preds = %94, %92
  br label %96

94:                                               ; preds = %9
  call fastcc void @support(ptr noundef %2, ptr noundef nonnull %6, ptr noundef %4)
  br label %93

95:                                               ; preds = %96
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #19
  ret double %108

96:                                               ; preds = %93, %96
  %97 = phi i64 [ %109, %96 ], [ 0, %93 ]
  %98 = phi double [ %108, %96 ], [ 0.000000e+00, %93 ]
  %99 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %97
  %100 = load double, ptr %99, align 8
  %101 = getelementptr inbounds double, ptr %4, i64 %97
  %102 = load double, ptr %101, align 8
  %103 = add nuw nsw i64 %97, 9
  %104 = getelementptr inbounds double, ptr %3, i64 %103
  %105 = load double, ptr %104, align 8
  %106 = fsub double %102, %105
  %107 = fmul double %100, %106
  %108 = fsub double %98, %107
  %109 = add nuw nsw i64 %97, 1
  %110 = icmp eq i64 %109, 3
  br i1 %110, label %95, label %96
}

define internal fastcc double @lowest_of(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef readonly %2, double noundef %3, ptr nocapture noundef writeonly %4) unnamed_addr #3 {
  %6 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 33
  %7 = load ptr, ptr %6, align 8
  %8 = mul nsw i64 %1, 6
  %9 = getelementptr inbounds double, ptr %7, i64 %8
  br label %12

10:                                               ; preds = %12
  %11 = fcmp olt double %24, %3
  br i1 %11, label %27, label %77

12:                                               ; preds = %5, %12
  %13 = phi i64 [ 0, %5 ], [ %25, %12 ]
  %14 = phi double [ 0.000000e+00, %5 ], [ %24, %12 ]
  %15 = getelementptr inbounds double, ptr %2, i64 %13
  %16 = load double, ptr %15, align 8
  %17 = fcmp ogt double %16, 0.000000e+00
  %18 = add nuw i64 %13, 3
  %19 = select i1 %17, i64 %13, i64 %18
  %20 = and i64 %19, 4294967295
  %21 = getelementptr inbounds double, ptr %9, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = fmul double %16, %22
  %24 = fadd double %14, %23
  %25 = add nuw nsw i64 %13, 1
  %26 = icmp eq i64 %25, 3
  br i1 %26, label %10, label %12

27:                                               ; preds = %10
  %28 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 34
  %29 = load ptr, ptr %28, align 8
  %30 = shl nsw i64 %1, 1
  %31 = getelementptr inbounds i64, ptr %29, i64 %30
  %32 = load i64, ptr %31, align 8
  %33 = icmp sgt i64 %32, -1
  br i1 %33, label %40, label %34

34:                                               ; preds = %27
  %35 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 36
  %36 = getelementptr inbounds i64, ptr %31, i64 1
  %37 = getelementptr inbounds double, ptr %2, i64 1
  %38 = getelementptr inbounds double, ptr %2, i64 2
  %39 = load double, ptr %2, align 8
  br label %47

40:                                               ; preds = %27, %40
  %41 = phi i1 [ false, %40 ], [ true, %27 ]
  %42 = phi i64 [ 1, %40 ], [ 0, %27 ]
  %43 = phi double [ %46, %40 ], [ %3, %27 ]
  %44 = getelementptr inbounds i64, ptr %31, i64 %42
  %45 = load i64, ptr %44, align 8
  %46 = tail call fastcc double @lowest_of(ptr noundef %0, i64 noundef %45, ptr noundef %2, double noundef %43, ptr noundef %4)
  br i1 %41, label %40, label %77

47:                                               ; preds = %34, %72
  %48 = phi double [ %39, %34 ], [ %73, %72 ]
  %49 = phi i64 [ 0, %34 ], [ %75, %72 ]
  %50 = phi double [ %3, %34 ], [ %74, %72 ]
  %51 = load ptr, ptr %35, align 8
  %52 = load i64, ptr %36, align 8
  %53 = mul nsw i64 %52, 9
  %54 = getelementptr inbounds double, ptr %51, i64 %53
  %55 = mul nuw nsw i64 %49, 3
  %56 = getelementptr inbounds double, ptr %54, i64 %55
  %57 = load double, ptr %56, align 8
  %58 = fmul double %48, %57
  %59 = load double, ptr %37, align 8
  %60 = getelementptr inbounds double, ptr %56, i64 1
  %61 = load double, ptr %60, align 8
  %62 = fmul double %59, %61
  %63 = fadd double %58, %62
  %64 = load double, ptr %38, align 8
  %65 = getelementptr inbounds double, ptr %56, i64 2
  %66 = load double, ptr %65, align 8
  %67 = fmul double %64, %66
  %68 = fadd double %63, %67
  %69 = fcmp olt double %68, %50
  br i1 %69, label %70, label %72

70:                                               ; preds = %47
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %4, ptr noundef nonnull align 8 dereferenceable(24) %56, i64 24, i1 false)
  %71 = load double, ptr %2, align 8
  br label %72

72:                                               ; preds = %70, %47
  %73 = phi double [ %71, %70 ], [ %48, %47 ]
  %74 = phi double [ %68, %70 ], [ %50, %47 ]
  %75 = add nuw nsw i64 %49, 1
  %76 = icmp eq i64 %75, 3
  br i1 %76, label %77, label %47

77:                                               ; preds = %72, %40, %10
  %78 = phi double [ %3, %10 ], [ %46, %40 ], [ %74, %72 ]
  ret double %78
}

declare i32 @bcmp(ptr nocapture, ptr nocapture, i64) local_unnamed_addr #15

declare i64 @llvm.smin.i64(i64, i64) #16

declare i64 @llvm.smax.i64(i64, i64) #16


attributes #0 = { nofree nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #3 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #5 = { nofree norecurse nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #6 = { nofree nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #7 = { nofree nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #8 = { nofree nosync nounwind memory(argmem: readwrite) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #9 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #10 = { nofree nosync nounwind memory(read, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #11 = { mustprogress nofree nosync nounwind willreturn memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #12 = { nofree nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #13 = { inlinehint nofree nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #14 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: read) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #15 = { nofree nounwind willreturn memory(argmem: read) }
attributes #16 = { nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #17 = { nocallback nofree nosync nounwind willreturn memory(inaccessiblemem: readwrite) }
attributes #18 = { memory(none) }
attributes #19 = { nounwind }


