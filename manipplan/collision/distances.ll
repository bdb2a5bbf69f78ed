; distances.c d080fb881902381446ad8511a3b2977fd79a3b91fb26420349acacc1b9a89262: written by make kernel

%struct.Core = type { i64, i64, ptr, ptr, ptr, ptr, ptr, [12 x double] }
%struct.Search = type { ptr, i64, ptr, ptr, i64, double, ptr, ptr, i32, i64, %struct.Plane, ptr }
%struct.Plane = type { [3 x double], double }
%struct.World = type { i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, i64, ptr, i64, ptr, ptr, i64, ptr, ptr, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr }
%struct.Simplex = type { [4 x [3 x double]], [4 x [3 x double]], i32, [3 x double] }
%struct.Face = type { [3 x i32], [3 x double], double }

@place.still = internal constant [12 x double] [double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00], align 16
@box_core.straight = internal unnamed_addr constant [9 x double] [double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00], align 16
@reduce.face = internal unnamed_addr constant [4 x [3 x i32]] [[3 x i32] [i32 0, i32 1, i32 2], [3 x i32] [i32 0, i32 1, i32 3], [3 x i32] [i32 0, i32 2, i32 3], [3 x i32] [i32 1, i32 2, i32 3]], align 16
@__const.reduce.chosen = private unnamed_addr constant [3 x i32] [i32 0, i32 1, i32 2], align 4
@within.ray = internal constant [3 x [3 x double]] [[3 x double] [double 6.123720e-01, double 3.535530e-01, double 7.071070e-01], [3 x double] [double -4.177900e-01, double 0x3FEA99C38B04AB60, double -3.670100e-01], [3 x double] [double 1.173100e-01, double -5.144900e-01, double -8.494300e-01]], align 16
@begin.solid = internal unnamed_addr constant [4 x [3 x i32]] [[3 x i32] [i32 0, i32 2, i32 1], [3 x i32] [i32 0, i32 1, i32 3], [3 x i32] [i32 0, i32 3, i32 2], [3 x i32] [i32 1, i32 2, i32 3]], align 16
@begin.beside = internal unnamed_addr constant [6 x [3 x i32]] [[3 x i32] [i32 0, i32 1, i32 3], [3 x i32] [i32 1, i32 2, i32 3], [3 x i32] [i32 2, i32 0, i32 3], [3 x i32] [i32 1, i32 0, i32 4], [3 x i32] [i32 2, i32 1, i32 4], [3 x i32] [i32 0, i32 2, i32 4]], align 16
@begin.around = internal unnamed_addr constant [6 x [3 x i32]] [[3 x i32] [i32 2, i32 3, i32 1], [3 x i32] [i32 3, i32 4, i32 1], [3 x i32] [i32 4, i32 2, i32 1], [3 x i32] [i32 3, i32 2, i32 0], [3 x i32] [i32 4, i32 3, i32 0], [3 x i32] [i32 2, i32 4, i32 0]], align 16
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
  br i1 %18, label %246, label %19

19:                                               ; preds = %16
  %20 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 39
  %21 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 40
  %22 = load i64, ptr %17, align 8
  %23 = icmp sgt i64 %22, 0
  br i1 %23, label %24, label %246

24:                                               ; preds = %19
  %25 = load ptr, ptr %20, align 8
  %26 = load ptr, ptr %21, align 8
  br label %38

27:                                               ; preds = %5, %27
  %28 = phi i32 [ %35, %27 ], [ 1, %5 ]
  %29 = phi i64 [ %36, %27 ], [ 0, %5 ]
  %30 = getelementptr inbounds double, ptr %1, i64 %29
  %31 = load double, ptr %30, align 8
  %32 = tail call double @llvm.fabs.f64(double %31) #14
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
  br i1 %46, label %38, label %246

47:                                               ; preds = %5, %14
  %48 = icmp eq ptr %3, null
  br i1 %48, label %52, label %49

49:                                               ; preds = %47
  %50 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 39
  %51 = load ptr, ptr %50, align 8
  br label %52

52:                                               ; preds = %47, %49
  %53 = phi ptr [ %51, %49 ], [ null, %47 ]
  tail call fastcc void @place(ptr noundef nonnull %0, ptr noundef %1)
  %54 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 28
  %55 = load i64, ptr %54, align 8
  %56 = icmp sgt i64 %55, 0
  br i1 %56, label %57, label %164

57:                                               ; preds = %52
  %58 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 32
  %59 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 29
  %60 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 30
  %61 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 37
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
  %76 = icmp ne ptr %53, null
  br label %77

77:                                               ; preds = %57, %159
  %78 = phi i64 [ %55, %57 ], [ %160, %159 ]
  %79 = phi i32 [ 0, %57 ], [ %161, %159 ]
  %80 = phi i64 [ 0, %57 ], [ %162, %159 ]
  %81 = load i64, ptr %58, align 8
  %82 = icmp sgt i64 %81, -1
  br i1 %82, label %83, label %164

83:                                               ; preds = %77
  %84 = load ptr, ptr %59, align 8
  %85 = mul nsw i64 %80, 3
  %86 = getelementptr inbounds i64, ptr %84, i64 %85
  %87 = load ptr, ptr %60, align 8
  %88 = shl nsw i64 %80, 2
  %89 = getelementptr inbounds double, ptr %87, i64 %88
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #15
  %90 = getelementptr inbounds double, ptr %89, i64 3
  %91 = load double, ptr %90, align 8
  %92 = load ptr, ptr %61, align 8
  %93 = load i64, ptr %86, align 8
  %94 = mul nsw i64 %93, 12
  %95 = getelementptr inbounds double, ptr %92, i64 %94
  %96 = getelementptr inbounds double, ptr %89, i64 1
  %97 = getelementptr inbounds double, ptr %89, i64 2
  br label %98

98:                                               ; preds = %98, %83
  %99 = phi i64 [ 0, %83 ], [ %122, %98 ]
  %100 = mul nuw nsw i64 %99, 3
  %101 = getelementptr inbounds double, ptr %95, i64 %100
  %102 = load double, ptr %101, align 8
  %103 = load double, ptr %89, align 8
  %104 = fmul double %102, %103
  %105 = add nuw nsw i64 %100, 1
  %106 = getelementptr inbounds double, ptr %95, i64 %105
  %107 = load double, ptr %106, align 8
  %108 = load double, ptr %96, align 8
  %109 = fmul double %107, %108
  %110 = fadd double %104, %109
  %111 = add nuw nsw i64 %100, 2
  %112 = getelementptr inbounds double, ptr %95, i64 %111
  %113 = load double, ptr %112, align 8
  %114 = load double, ptr %97, align 8
  %115 = fmul double %113, %114
  %116 = fadd double %110, %115
  %117 = add nuw nsw i64 %99, 9
  %118 = getelementptr inbounds double, ptr %95, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = fadd double %119, %116
  %121 = getelementptr inbounds double, ptr %6, i64 %99
  store double %120, ptr %121, align 8
  %122 = add nuw nsw i64 %99, 1
  %123 = icmp eq i64 %122, 3
  br i1 %123, label %124, label %98

124:                                              ; preds = %98
  %125 = fadd double %91, %2
  %126 = fmul double %125, %125
  %127 = call fastcc i32 @is_near(ptr noundef %0, ptr noundef nonnull %6, double noundef %126, i64 noundef %81)
  %128 = icmp eq i32 %127, 0
  br i1 %128, label %159, label %129

129:                                              ; preds = %124
  %130 = getelementptr inbounds i64, ptr %86, i64 1
  %131 = getelementptr inbounds i64, ptr %86, i64 2
  %132 = load i64, ptr %131, align 8
  %133 = icmp sgt i64 %132, 0
  br i1 %133, label %134, label %159

134:                                              ; preds = %129
  %135 = load i64, ptr %130, align 8
  br label %142

136:                                              ; preds = %142
  %137 = add nsw i64 %144, 1
  %138 = load i64, ptr %130, align 8
  %139 = load i64, ptr %131, align 8
  %140 = add nsw i64 %139, %138
  %141 = icmp slt i64 %137, %140
  br i1 %141, label %142, label %157

142:                                              ; preds = %134, %136
  %143 = phi i32 [ %153, %136 ], [ %79, %134 ]
  %144 = phi i64 [ %137, %136 ], [ %135, %134 ]
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %7) #15
  call void @llvm.lifetime.start.p0(i64 120, ptr nonnull %8) #15
  store ptr %0, ptr %8, align 8
  %145 = load ptr, ptr %63, align 8
  %146 = getelementptr inbounds i64, ptr %145, i64 %144
  %147 = load i64, ptr %146, align 8
  store i64 %147, ptr %62, align 8
  store ptr %7, ptr %64, align 8
  %148 = load ptr, ptr %66, align 8
  %149 = load i64, ptr %67, align 8
  %150 = mul nsw i64 %149, %144
  %151 = getelementptr inbounds i64, ptr %148, i64 %150
  store ptr %151, ptr %65, align 8
  store i64 -1, ptr %68, align 8
  store double %2, ptr %69, align 8
  store ptr %53, ptr %70, align 8
  store ptr %3, ptr %71, align 8
  store i32 %143, ptr %72, align 8
  store i64 -1, ptr %73, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %74, i8 0, i64 32, i1 false)
  store ptr %4, ptr %75, align 8
  call fastcc void @core_of(ptr noundef %0, i64 noundef %147, ptr noundef nonnull %7)
  %152 = load i64, ptr %58, align 8
  call fastcc void @descend(ptr noundef nonnull %8, i64 noundef %152)
  %153 = load i32, ptr %72, align 8
  %154 = icmp ne i32 %153, 1
  %155 = select i1 %76, i1 true, i1 %154
  call void @llvm.lifetime.end.p0(i64 120, ptr nonnull %8) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %7) #15
  br i1 %155, label %136, label %156

156:                                              ; preds = %142
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #15
  br label %246

157:                                              ; preds = %136
  %158 = load i64, ptr %54, align 8
  br label %159

159:                                              ; preds = %157, %129, %124
  %160 = phi i64 [ %78, %124 ], [ %78, %129 ], [ %158, %157 ]
  %161 = phi i32 [ %79, %124 ], [ %79, %129 ], [ %153, %157 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #15
  %162 = add nuw nsw i64 %80, 1
  %163 = icmp slt i64 %162, %160
  br i1 %163, label %77, label %164

164:                                              ; preds = %159, %77, %52
  %165 = phi i32 [ 0, %52 ], [ %79, %77 ], [ %161, %159 ]
  %166 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 23
  %167 = load i64, ptr %166, align 8
  %168 = icmp sgt i64 %167, 0
  br i1 %168, label %169, label %246

169:                                              ; preds = %164
  %170 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 24
  %171 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 38
  %172 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 18
  %173 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 1
  %174 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 2
  %175 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 3
  %176 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 4
  %177 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 5
  %178 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 6
  %179 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 7
  %180 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 8
  %181 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 9
  %182 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 10
  %183 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 11
  %184 = icmp eq ptr %53, null
  br label %185

185:                                              ; preds = %169, %241
  %186 = phi i64 [ %167, %169 ], [ %242, %241 ]
  %187 = phi i32 [ %165, %169 ], [ %243, %241 ]
  %188 = phi i64 [ 0, %169 ], [ %244, %241 ]
  %189 = load ptr, ptr %170, align 8
  %190 = mul nuw nsw i64 %188, 3
  %191 = getelementptr inbounds i64, ptr %189, i64 %190
  %192 = load i64, ptr %191, align 8
  %193 = add nuw nsw i64 %190, 1
  %194 = getelementptr inbounds i64, ptr %189, i64 %193
  %195 = load i64, ptr %194, align 8
  %196 = load ptr, ptr %171, align 8
  %197 = mul nsw i64 %192, 3
  %198 = getelementptr inbounds double, ptr %196, i64 %197
  %199 = mul nsw i64 %195, 3
  %200 = getelementptr inbounds double, ptr %196, i64 %199
  %201 = load double, ptr %198, align 8
  %202 = load double, ptr %200, align 8
  %203 = fsub double %201, %202
  %204 = getelementptr inbounds double, ptr %198, i64 1
  %205 = load double, ptr %204, align 8
  %206 = getelementptr inbounds double, ptr %200, i64 1
  %207 = load double, ptr %206, align 8
  %208 = fsub double %205, %207
  %209 = getelementptr inbounds double, ptr %198, i64 2
  %210 = load double, ptr %209, align 8
  %211 = getelementptr inbounds double, ptr %200, i64 2
  %212 = load double, ptr %211, align 8
  %213 = fsub double %210, %212
  %214 = load ptr, ptr %172, align 8
  %215 = shl nsw i64 %192, 2
  %216 = or i64 %215, 3
  %217 = getelementptr inbounds double, ptr %214, i64 %216
  %218 = load double, ptr %217, align 8
  %219 = fadd double %218, %2
  %220 = shl nsw i64 %195, 2
  %221 = or i64 %220, 3
  %222 = getelementptr inbounds double, ptr %214, i64 %221
  %223 = load double, ptr %222, align 8
  %224 = fadd double %219, %223
  %225 = fmul double %203, %203
  %226 = fmul double %208, %208
  %227 = fadd double %225, %226
  %228 = fmul double %213, %213
  %229 = fadd double %227, %228
  %230 = fmul double %224, %224
  %231 = fcmp ogt double %229, %230
  br i1 %231, label %241, label %232

232:                                              ; preds = %185
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %9) #15
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %192, ptr noundef nonnull %9)
  call void @llvm.lifetime.start.p0(i64 120, ptr nonnull %10) #15
  store ptr %0, ptr %10, align 8
  store i64 %192, ptr %173, align 8
  store ptr %9, ptr %174, align 8
  store ptr null, ptr %175, align 8
  %233 = add nuw nsw i64 %190, 2
  %234 = getelementptr inbounds i64, ptr %189, i64 %233
  %235 = load i64, ptr %234, align 8
  store i64 %235, ptr %176, align 8
  store double %2, ptr %177, align 8
  store ptr %53, ptr %178, align 8
  store ptr %3, ptr %179, align 8
  store i32 %187, ptr %180, align 8
  store i64 -1, ptr %181, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %182, i8 0, i64 32, i1 false)
  store ptr %4, ptr %183, align 8
  call fastcc void @look_at(ptr noundef nonnull %10, i64 noundef %195, ptr noundef null)
  %236 = load i32, ptr %180, align 8
  %237 = icmp eq i32 %236, 1
  %238 = select i1 %184, i1 %237, i1 false
  call void @llvm.lifetime.end.p0(i64 120, ptr nonnull %10) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %9) #15
  br i1 %238, label %246, label %239

239:                                              ; preds = %232
  %240 = load i64, ptr %166, align 8
  br label %241

241:                                              ; preds = %239, %185
  %242 = phi i64 [ %186, %185 ], [ %240, %239 ]
  %243 = phi i32 [ %187, %185 ], [ %236, %239 ]
  %244 = add nuw nsw i64 %188, 1
  %245 = icmp slt i64 %244, %242
  br i1 %245, label %185, label %246

246:                                              ; preds = %232, %241, %38, %19, %164, %16, %156
  %247 = phi i32 [ 1, %156 ], [ 2, %16 ], [ %165, %164 ], [ 2, %19 ], [ 2, %38 ], [ 1, %232 ], [ %243, %241 ]
  ret i32 %247
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
  br i1 %7, label %15, label %8

8:                                                ; preds = %5
  %9 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 41
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %12 = load i64, ptr %11, align 8
  %13 = mul i64 %12, 24
  tail call void @llvm.memset.p0.i64(ptr align 8 %10, i8 0, i64 %13, i1 false)
  %14 = load ptr, ptr %9, align 8
  br label %17

15:                                               ; preds = %5
  %16 = icmp eq i64 %2, 1
  br i1 %16, label %17, label %23

17:                                               ; preds = %8, %15
  %18 = phi ptr [ %14, %8 ], [ null, %15 ]
  %19 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %20 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %21 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 39
  %22 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 40
  br label %24

23:                                               ; preds = %47, %15
  ret void

24:                                               ; preds = %17, %47
  %25 = phi i64 [ 0, %17 ], [ %48, %47 ]
  %26 = phi ptr [ %4, %17 ], [ %49, %47 ]
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %6) #15
  store i64 0, ptr %6, align 8
  %27 = load i64, ptr %19, align 8
  %28 = mul nsw i64 %27, %25
  %29 = getelementptr inbounds double, ptr %1, i64 %28
  %30 = getelementptr inbounds double, ptr %3, i64 %25
  %31 = load double, ptr %30, align 8
  %32 = call fastcc i32 @examine(ptr noundef %0, ptr noundef %29, double noundef %31, ptr noundef nonnull %6, ptr noundef %18)
  %33 = load i64, ptr %20, align 8
  %34 = icmp sgt i64 %33, 0
  br i1 %34, label %41, label %35

35:                                               ; preds = %41, %24
  %36 = load i64, ptr %6, align 8
  %37 = icmp sgt i64 %36, 0
  br i1 %37, label %38, label %47

38:                                               ; preds = %35
  %39 = load ptr, ptr %21, align 8
  %40 = load ptr, ptr %22, align 8
  br label %51

41:                                               ; preds = %24, %41
  %42 = phi i64 [ %45, %41 ], [ 0, %24 ]
  %43 = load double, ptr %30, align 8
  %44 = getelementptr inbounds double, ptr %26, i64 %42
  store double %43, ptr %44, align 8
  %45 = add nuw nsw i64 %42, 1
  %46 = icmp eq i64 %45, %33
  br i1 %46, label %35, label %41

47:                                               ; preds = %51, %35
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %6) #15
  %48 = add nuw nsw i64 %25, 1
  %49 = getelementptr inbounds double, ptr %26, i64 %33
  %50 = icmp eq i64 %48, %2
  br i1 %50, label %23, label %24

51:                                               ; preds = %38, %51
  %52 = phi i64 [ 0, %38 ], [ %58, %51 ]
  %53 = getelementptr inbounds i64, ptr %40, i64 %52
  %54 = load i64, ptr %53, align 8
  %55 = getelementptr inbounds double, ptr %39, i64 %54
  %56 = load double, ptr %55, align 8
  %57 = getelementptr inbounds double, ptr %26, i64 %54
  store double %56, ptr %57, align 8
  store double 0x7FF0000000000000, ptr %55, align 8
  %58 = add nuw nsw i64 %52, 1
  %59 = icmp eq i64 %58, %36
  br i1 %59, label %47, label %51
}

define dso_local i64 @manipplan_near(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, ptr nocapture noundef readonly %3, i64 noundef %4, ptr nocapture noundef writeonly %5, ptr nocapture noundef writeonly %6) local_unnamed_addr #0 {
  %8 = alloca i64, align 8
  %9 = icmp slt i64 %2, 2
  br i1 %9, label %17, label %10

10:                                               ; preds = %7
  %11 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 41
  %12 = load ptr, ptr %11, align 8
  %13 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %14 = load i64, ptr %13, align 8
  %15 = mul i64 %14, 24
  tail call void @llvm.memset.p0.i64(ptr align 8 %12, i8 0, i64 %15, i1 false)
  %16 = load ptr, ptr %11, align 8
  br label %19

17:                                               ; preds = %7
  %18 = icmp eq i64 %2, 1
  br i1 %18, label %19, label %25

19:                                               ; preds = %10, %17
  %20 = phi ptr [ %16, %10 ], [ null, %17 ]
  %21 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %22 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 40
  %23 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %24 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 39
  br label %27

25:                                               ; preds = %41, %17
  %26 = phi i64 [ 0, %17 ], [ %42, %41 ]
  ret i64 %26

27:                                               ; preds = %19, %41
  %28 = phi i64 [ 0, %19 ], [ %42, %41 ]
  %29 = phi i64 [ 0, %19 ], [ %43, %41 ]
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %8) #15
  store i64 0, ptr %8, align 8
  %30 = load i64, ptr %21, align 8
  %31 = mul nsw i64 %30, %29
  %32 = getelementptr inbounds double, ptr %1, i64 %31
  %33 = getelementptr inbounds double, ptr %3, i64 %29
  %34 = load double, ptr %33, align 8
  %35 = call fastcc i32 @examine(ptr noundef %0, ptr noundef %32, double noundef %34, ptr noundef nonnull %8, ptr noundef %20)
  %36 = load i64, ptr %8, align 8
  %37 = icmp sgt i64 %36, 0
  br i1 %37, label %38, label %41

38:                                               ; preds = %27
  %39 = load ptr, ptr %22, align 8
  %40 = load ptr, ptr %24, align 8
  br label %45

41:                                               ; preds = %59, %27
  %42 = phi i64 [ %28, %27 ], [ %62, %59 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #15
  %43 = add nuw nsw i64 %29, 1
  %44 = icmp eq i64 %43, %2
  br i1 %44, label %25, label %27

45:                                               ; preds = %38, %59
  %46 = phi i64 [ %28, %38 ], [ %62, %59 ]
  %47 = phi i64 [ 0, %38 ], [ %61, %59 ]
  %48 = getelementptr inbounds i64, ptr %39, i64 %47
  %49 = load i64, ptr %48, align 8
  %50 = icmp slt i64 %46, %4
  br i1 %50, label %51, label %59

51:                                               ; preds = %45
  %52 = load i64, ptr %23, align 8
  %53 = mul nsw i64 %52, %29
  %54 = add nsw i64 %53, %49
  %55 = getelementptr inbounds i64, ptr %5, i64 %46
  store i64 %54, ptr %55, align 8
  %56 = getelementptr inbounds double, ptr %40, i64 %49
  %57 = load double, ptr %56, align 8
  %58 = getelementptr inbounds double, ptr %6, i64 %46
  store double %57, ptr %58, align 8
  br label %59

59:                                               ; preds = %51, %45
  %60 = getelementptr inbounds double, ptr %40, i64 %49
  store double 0x7FF0000000000000, ptr %60, align 8
  %61 = add nuw nsw i64 %47, 1
  %62 = add nsw i64 %46, 1
  %63 = icmp eq i64 %61, %36
  br i1 %63, label %41, label %45
}

define dso_local i32 @manipplan_least(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, double noundef %3, i64 noundef %4, ptr nocapture noundef %5, ptr nocapture noundef %6, ptr nocapture noundef %7) local_unnamed_addr #0 {
  %9 = alloca i64, align 8
  store double %3, ptr %5, align 8
  store i64 0, ptr %6, align 8
  store i64 -1, ptr %7, align 8
  %10 = icmp sgt i64 %2, 0
  %11 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %12 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 40
  %13 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 39
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
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %9) #15
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
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #15
  br label %70

34:                                               ; preds = %24
  %35 = load ptr, ptr %12, align 8
  %36 = load ptr, ptr %13, align 8
  %37 = load i64, ptr %7, align 8
  br label %40

38:                                               ; preds = %66
  %39 = icmp eq i32 %49, 0
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #15
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

define dso_local void @manipplan_pairs(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, ptr noundef %5, ptr nocapture noundef writeonly %6) local_unnamed_addr #0 {
  %8 = alloca [3 x double], align 16
  %9 = alloca %struct.Core, align 8
  %10 = alloca %struct.Search, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #15
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %8, i8 0, i64 24, i1 false)
  %11 = icmp sgt i64 %2, 0
  br i1 %11, label %12, label %24

12:                                               ; preds = %7
  %13 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %14 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 1
  %15 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 2
  %16 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 3
  %17 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 5
  %18 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 6
  %19 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 7
  %20 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 8
  %21 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 9
  %22 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 10
  %23 = getelementptr inbounds %struct.Search, ptr %10, i64 0, i32 11
  br label %25

24:                                               ; preds = %88, %7
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #15
  ret void

25:                                               ; preds = %12, %88
  %26 = phi i64 [ 0, %12 ], [ %89, %88 ]
  %27 = shl nuw nsw i64 %26, 1
  %28 = getelementptr inbounds i64, ptr %3, i64 %27
  %29 = load i64, ptr %28, align 8
  %30 = or i64 %27, 1
  %31 = getelementptr inbounds i64, ptr %3, i64 %30
  %32 = load i64, ptr %31, align 8
  %33 = icmp eq i64 %26, 0
  br i1 %33, label %45, label %34

34:                                               ; preds = %25
  %35 = add nsw i64 %27, -2
  %36 = getelementptr inbounds i64, ptr %3, i64 %35
  %37 = load i64, ptr %36, align 8
  %38 = icmp eq i64 %29, %37
  br i1 %38, label %39, label %44

39:                                               ; preds = %34
  %40 = add nsw i64 %27, -1
  %41 = getelementptr inbounds i64, ptr %3, i64 %40
  %42 = load i64, ptr %41, align 8
  %43 = icmp eq i64 %32, %42
  br i1 %43, label %45, label %44

44:                                               ; preds = %39, %34
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %8, i8 0, i64 24, i1 false)
  br label %45

45:                                               ; preds = %44, %39, %25
  %46 = load i64, ptr %13, align 8
  %47 = icmp sgt i64 %46, 0
  br i1 %47, label %48, label %67

48:                                               ; preds = %45
  %49 = mul nsw i64 %46, %26
  br label %55

50:                                               ; preds = %55
  %51 = icmp eq i32 %64, 0
  br i1 %51, label %52, label %67

52:                                               ; preds = %50
  %53 = getelementptr inbounds double, ptr %5, i64 %26
  store double 0x7FF8000000000000, ptr %53, align 8
  %54 = getelementptr inbounds i64, ptr %6, i64 %26
  store i64 -1, ptr %54, align 8
  br label %88

55:                                               ; preds = %48, %55
  %56 = phi i64 [ 0, %48 ], [ %65, %55 ]
  %57 = phi i32 [ 1, %48 ], [ %64, %55 ]
  %58 = add nsw i64 %49, %56
  %59 = getelementptr inbounds double, ptr %1, i64 %58
  %60 = load double, ptr %59, align 8
  %61 = call double @llvm.fabs.f64(double %60) #14
  %62 = fcmp one double %61, 0x7FF0000000000000
  %63 = zext i1 %62 to i32
  %64 = and i32 %57, %63
  %65 = add nuw nsw i64 %56, 1
  %66 = icmp eq i64 %65, %46
  br i1 %66, label %50, label %55

67:                                               ; preds = %45, %50
  %68 = getelementptr inbounds double, ptr %4, i64 %26
  %69 = load double, ptr %68, align 8
  %70 = getelementptr inbounds double, ptr %5, i64 %26
  store double %69, ptr %70, align 8
  %71 = getelementptr inbounds i64, ptr %6, i64 %26
  store i64 -1, ptr %71, align 8
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %9) #15
  br i1 %33, label %82, label %72

72:                                               ; preds = %67
  %73 = load i64, ptr %13, align 8
  %74 = mul nsw i64 %73, %26
  %75 = getelementptr inbounds double, ptr %1, i64 %74
  %76 = add nsw i64 %26, -1
  %77 = mul nsw i64 %73, %76
  %78 = getelementptr inbounds double, ptr %1, i64 %77
  %79 = shl i64 %73, 3
  %80 = call i32 @bcmp(ptr %75, ptr %78, i64 %79)
  %81 = icmp eq i32 %80, 0
  br i1 %81, label %85, label %82

82:                                               ; preds = %67, %72
  %83 = phi i64 [ %74, %72 ], [ 0, %67 ]
  %84 = getelementptr inbounds double, ptr %1, i64 %83
  call fastcc void @place(ptr noundef nonnull %0, ptr noundef %84)
  br label %85

85:                                               ; preds = %82, %72
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %29, ptr noundef nonnull %9)
  call void @llvm.lifetime.start.p0(i64 120, ptr nonnull %10) #15
  store ptr %0, ptr %10, align 8
  store i64 %29, ptr %14, align 8
  store ptr %9, ptr %15, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %16, i8 0, i64 16, i1 false)
  %86 = load double, ptr %68, align 8
  store double %86, ptr %17, align 8
  store ptr %70, ptr %18, align 8
  store ptr null, ptr %19, align 8
  store i32 0, ptr %20, align 8
  store i64 -1, ptr %21, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %22, i8 0, i64 32, i1 false)
  store ptr %8, ptr %23, align 8
  call fastcc void @look_at(ptr noundef nonnull %10, i64 noundef %32, ptr noundef null)
  %87 = load i64, ptr %21, align 8
  store i64 %87, ptr %71, align 8
  call void @llvm.lifetime.end.p0(i64 120, ptr nonnull %10) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %9) #15
  br label %88

88:                                               ; preds = %52, %85
  %89 = add nuw nsw i64 %26, 1
  %90 = icmp eq i64 %89, %2
  br i1 %90, label %24, label %25
}

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #2

declare double @llvm.fabs.f64(double) #3

define internal fastcc void @place(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1) unnamed_addr #4 {
  %3 = alloca [12 x double], align 16
  %4 = alloca [12 x double], align 16
  %5 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 37
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
  %43 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 38
  br label %213

44:                                               ; preds = %9, %210
  %45 = phi i64 [ 0, %9 ], [ %161, %210 ]
  %46 = mul nsw i64 %45, 3
  %47 = getelementptr inbounds double, ptr %11, i64 %46
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %3) #15
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
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %4) #15
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
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %4) #15
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %3) #15
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

define internal fastcc void @core_of(ptr nocapture noundef readonly %0, i64 noundef %1, ptr noundef %2) unnamed_addr #5 {
  %4 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 37
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

define internal fastcc void @look_at(ptr noundef %0, i64 noundef %1, ptr noundef readonly %2) unnamed_addr #0 {
  %4 = alloca double, align 8
  %5 = alloca double, align 8
  %6 = alloca %struct.Plane, align 8
  %7 = alloca %struct.Plane, align 8
  %8 = alloca [3 x double], align 16
  %9 = alloca [3 x double], align 16
  %10 = alloca %struct.Core, align 8
  %11 = alloca %struct.Simplex, align 8
  %12 = alloca double, align 8
  %13 = load ptr, ptr %0, align 8
  %14 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %15 = load ptr, ptr %14, align 8
  %16 = icmp eq ptr %15, null
  %17 = getelementptr inbounds i64, ptr %15, i64 %1
  %18 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %19 = select i1 %16, ptr %18, ptr %17
  %20 = load i64, ptr %19, align 8
  %21 = icmp slt i64 %20, 0
  br i1 %21, label %308, label %22

22:                                               ; preds = %3
  %23 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %24 = load ptr, ptr %23, align 8
  %25 = icmp eq ptr %24, null
  br i1 %25, label %30, label %26

26:                                               ; preds = %22
  %27 = getelementptr inbounds double, ptr %24, i64 %20
  %28 = load double, ptr %27, align 8
  %29 = fcmp uno double %28, 0.000000e+00
  br i1 %29, label %308, label %34

30:                                               ; preds = %22
  %31 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %32 = load i32, ptr %31, align 8
  %33 = icmp eq i32 %32, 1
  br i1 %33, label %308, label %34

34:                                               ; preds = %26, %30
  %35 = getelementptr inbounds %struct.World, ptr %13, i64 0, i32 12
  %36 = load ptr, ptr %35, align 8
  %37 = getelementptr inbounds i64, ptr %36, i64 %1
  %38 = load i64, ptr %37, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %4) #15
  store double 0xFFF0000000000000, ptr %4, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %5) #15
  store double 0x7FF0000000000000, ptr %5, align 8
  %39 = icmp eq i64 %38, 5
  br i1 %39, label %47, label %40

40:                                               ; preds = %34
  %41 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %42 = load i64, ptr %41, align 8
  %43 = getelementptr inbounds i64, ptr %36, i64 %42
  %44 = load i64, ptr %43, align 8
  %45 = add i64 %44, -3
  %46 = icmp ult i64 %45, 3
  br i1 %46, label %47, label %81

47:                                               ; preds = %40, %34
  br i1 %25, label %68, label %48

48:                                               ; preds = %47
  %49 = getelementptr inbounds double, ptr %24, i64 %20
  %50 = load double, ptr %49, align 8
  %51 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %52 = load double, ptr %51, align 8
  %53 = tail call double @llvm.minnum.f64(double %50, double %52)
  %54 = fcmp ugt double %53, 0xFFF0000000000000
  br i1 %54, label %55, label %307

55:                                               ; preds = %48
  %56 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %57 = load ptr, ptr %56, align 8
  %58 = icmp ne ptr %57, null
  %59 = fcmp oeq double %50, 0x7FF0000000000000
  %60 = select i1 %58, i1 %59, i1 false
  br i1 %60, label %61, label %67

61:                                               ; preds = %55
  %62 = getelementptr inbounds %struct.World, ptr %13, i64 0, i32 40
  %63 = load ptr, ptr %62, align 8
  %64 = load i64, ptr %57, align 8
  %65 = add nsw i64 %64, 1
  store i64 %65, ptr %57, align 8
  %66 = getelementptr inbounds i64, ptr %63, i64 %64
  store i64 %20, ptr %66, align 8
  br label %67

67:                                               ; preds = %61, %55
  store double 0x7FF8000000000000, ptr %49, align 8
  br label %307

68:                                               ; preds = %47
  %69 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %70 = load double, ptr %69, align 8
  %71 = fcmp ult double %70, 0x7FF0000000000000
  br i1 %71, label %74, label %72

72:                                               ; preds = %68
  %73 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  store i32 1, ptr %73, align 8
  br label %307

74:                                               ; preds = %68
  %75 = fcmp ult double %70, 0xFFF0000000000000
  br i1 %75, label %307, label %76

76:                                               ; preds = %74
  %77 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %78 = load i32, ptr %77, align 8
  %79 = icmp eq i32 %78, 0
  br i1 %79, label %80, label %307

80:                                               ; preds = %76
  store i32 2, ptr %77, align 8
  br label %307

81:                                               ; preds = %40
  switch i64 %38, label %142 [
    i64 3, label %82
    i64 4, label %99
  ]

82:                                               ; preds = %81
  %83 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %84 = load ptr, ptr %83, align 8
  %85 = tail call fastcc double @over_plane(ptr noundef nonnull %13, i64 noundef %42, ptr noundef %84, i64 noundef %1)
  br i1 %25, label %92, label %86

86:                                               ; preds = %82
  %87 = getelementptr inbounds double, ptr %24, i64 %20
  %88 = load double, ptr %87, align 8
  %89 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %90 = load double, ptr %89, align 8
  %91 = tail call double @llvm.minnum.f64(double %88, double %90)
  br label %95

92:                                               ; preds = %82
  %93 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %94 = load double, ptr %93, align 8
  br label %95

95:                                               ; preds = %86, %92
  %96 = phi double [ %91, %86 ], [ %94, %92 ]
  %97 = fcmp ugt double %85, %96
  br i1 %97, label %307, label %98

98:                                               ; preds = %95
  tail call fastcc void @tell(ptr noundef nonnull %0, i64 noundef %1, i32 noundef 1, double noundef %85, double noundef %85)
  br label %307

99:                                               ; preds = %81
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %6) #15
  %100 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %7) #15
  %101 = getelementptr inbounds %struct.World, ptr %13, i64 0, i32 33
  %102 = load ptr, ptr %101, align 8
  %103 = getelementptr inbounds %struct.World, ptr %13, i64 0, i32 35
  %104 = load ptr, ptr %103, align 8
  %105 = getelementptr inbounds i64, ptr %104, i64 %1
  %106 = load i64, ptr %105, align 8
  %107 = mul nsw i64 %106, 6
  %108 = getelementptr inbounds double, ptr %102, i64 %107
  call fastcc void @facing(ptr nonnull sret(%struct.Plane) align 8 %7, ptr noundef nonnull %13, i64 noundef %42, ptr noundef %108)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %100, ptr noundef nonnull align 8 dereferenceable(32) %7, i64 32, i1 false)
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %7) #15
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %6, ptr noundef nonnull align 8 dereferenceable(32) %100, i64 32, i1 false)
  %109 = load ptr, ptr %103, align 8
  %110 = getelementptr inbounds i64, ptr %109, i64 %1
  %111 = load i64, ptr %110, align 8
  call fastcc void @surface(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %111, ptr noundef nonnull %6)
  %112 = getelementptr inbounds %struct.World, ptr %13, i64 0, i32 17
  %113 = load ptr, ptr %112, align 8
  %114 = mul nsw i64 %1, 3
  %115 = getelementptr inbounds double, ptr %113, i64 %114
  %116 = load double, ptr %115, align 8
  %117 = fcmp ogt double %116, 0.000000e+00
  br i1 %117, label %118, label %141

118:                                              ; preds = %99
  %119 = load ptr, ptr %23, align 8
  %120 = icmp eq ptr %119, null
  br i1 %120, label %130, label %121

121:                                              ; preds = %118
  %122 = load ptr, ptr %14, align 8
  %123 = icmp eq ptr %122, null
  %124 = getelementptr inbounds i64, ptr %122, i64 %1
  %125 = select i1 %123, ptr %18, ptr %124
  %126 = load i64, ptr %125, align 8
  %127 = getelementptr inbounds double, ptr %119, i64 %126
  %128 = load double, ptr %127, align 8
  %129 = fcmp uno double %128, 0.000000e+00
  br i1 %129, label %141, label %134

130:                                              ; preds = %118
  %131 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %132 = load i32, ptr %131, align 8
  %133 = icmp eq i32 %132, 1
  br i1 %133, label %141, label %134

134:                                              ; preds = %121, %130
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #15
  %135 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %136 = load ptr, ptr %135, align 8
  call fastcc void @support(ptr noundef %136, ptr noundef nonnull @__const.nearest_of.share, ptr noundef nonnull %8)
  %137 = call fastcc i32 @within(ptr noundef nonnull %13, i64 noundef %1, ptr noundef nonnull %8)
  %138 = icmp eq i32 %137, 0
  br i1 %138, label %140, label %139

139:                                              ; preds = %134
  call fastcc void @tell(ptr noundef nonnull %0, i64 noundef %1, i32 noundef 0, double noundef 0xFFF0000000000000, double noundef 0x7FF0000000000000)
  br label %140

140:                                              ; preds = %139, %134
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #15
  br label %141

141:                                              ; preds = %121, %140, %130, %99
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %6) #15
  br label %307

142:                                              ; preds = %81
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #15
  br i1 %25, label %149, label %143

143:                                              ; preds = %142
  %144 = getelementptr inbounds double, ptr %24, i64 %20
  %145 = load double, ptr %144, align 8
  %146 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %147 = load double, ptr %146, align 8
  %148 = tail call double @llvm.minnum.f64(double %145, double %147)
  br label %152

149:                                              ; preds = %142
  %150 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %151 = load double, ptr %150, align 8
  br label %152

152:                                              ; preds = %143, %149
  %153 = phi double [ 0xFFF0000000000000, %143 ], [ %151, %149 ]
  %154 = phi double [ %148, %143 ], [ %151, %149 ]
  %155 = getelementptr inbounds %struct.World, ptr %13, i64 0, i32 38
  %156 = load ptr, ptr %155, align 8
  %157 = mul nsw i64 %42, 3
  %158 = getelementptr inbounds double, ptr %156, i64 %157
  %159 = mul nsw i64 %1, 3
  %160 = getelementptr inbounds double, ptr %156, i64 %159
  br label %186

161:                                              ; preds = %186
  %162 = getelementptr inbounds %struct.World, ptr %13, i64 0, i32 18
  %163 = load ptr, ptr %162, align 8
  %164 = shl nsw i64 %42, 2
  %165 = or i64 %164, 3
  %166 = getelementptr inbounds double, ptr %163, i64 %165
  %167 = load double, ptr %166, align 8
  %168 = fadd double %154, %167
  %169 = shl nsw i64 %1, 2
  %170 = or i64 %169, 3
  %171 = getelementptr inbounds double, ptr %163, i64 %170
  %172 = load double, ptr %171, align 8
  %173 = fadd double %168, %172
  %174 = load double, ptr %9, align 16
  %175 = fmul double %174, %174
  %176 = getelementptr inbounds double, ptr %9, i64 1
  %177 = load double, ptr %176, align 8
  %178 = fmul double %177, %177
  %179 = fadd double %175, %178
  %180 = getelementptr inbounds double, ptr %9, i64 2
  %181 = load double, ptr %180, align 16
  %182 = fmul double %181, %181
  %183 = fadd double %179, %182
  %184 = fmul double %173, %173
  %185 = fcmp ogt double %183, %184
  br i1 %185, label %306, label %196

186:                                              ; preds = %152, %186
  %187 = phi i64 [ 0, %152 ], [ %194, %186 ]
  %188 = getelementptr inbounds double, ptr %158, i64 %187
  %189 = load double, ptr %188, align 8
  %190 = getelementptr inbounds double, ptr %160, i64 %187
  %191 = load double, ptr %190, align 8
  %192 = fsub double %189, %191
  %193 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %187
  store double %192, ptr %193, align 8
  %194 = add nuw nsw i64 %187, 1
  %195 = icmp eq i64 %194, 3
  br i1 %195, label %161, label %186

196:                                              ; preds = %161
  %197 = tail call fastcc i32 @is_beside(ptr noundef nonnull %13, ptr noundef nonnull %160, double noundef %172, i64 noundef %42, double noundef %154)
  %198 = icmp eq i32 %197, 0
  br i1 %198, label %199, label %306

199:                                              ; preds = %196
  %200 = tail call fastcc i32 @is_beside(ptr noundef nonnull %13, ptr noundef nonnull %158, double noundef %167, i64 noundef %1, double noundef %154)
  %201 = icmp eq i32 %200, 0
  br i1 %201, label %202, label %306

202:                                              ; preds = %199
  %203 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  %204 = load ptr, ptr %203, align 8
  %205 = icmp eq ptr %204, null
  br i1 %205, label %221, label %206

206:                                              ; preds = %202
  %207 = mul nsw i64 %20, 3
  %208 = getelementptr inbounds double, ptr %204, i64 %207
  %209 = load double, ptr %208, align 8
  %210 = fmul double %209, %209
  %211 = getelementptr inbounds double, ptr %208, i64 1
  %212 = load double, ptr %211, align 8
  %213 = fmul double %212, %212
  %214 = fadd double %210, %213
  %215 = getelementptr inbounds double, ptr %208, i64 2
  %216 = load double, ptr %215, align 8
  %217 = fmul double %216, %216
  %218 = fadd double %214, %217
  %219 = fcmp ogt double %218, 0.000000e+00
  br i1 %219, label %220, label %221

220:                                              ; preds = %206
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %9, ptr noundef nonnull align 8 dereferenceable(24) %208, i64 24, i1 false)
  br label %267

221:                                              ; preds = %202, %206
  %222 = phi ptr [ %208, %206 ], [ null, %202 ]
  %223 = icmp eq ptr %2, null
  br i1 %223, label %267, label %224

224:                                              ; preds = %221, %224
  %225 = phi i64 [ %242, %224 ], [ 0, %221 ]
  %226 = phi double [ %241, %224 ], [ 0.000000e+00, %221 ]
  %227 = getelementptr inbounds double, ptr %2, i64 %225
  %228 = load double, ptr %227, align 8
  %229 = getelementptr inbounds double, ptr %158, i64 %225
  %230 = load double, ptr %229, align 8
  %231 = fsub double %228, %230
  %232 = add nuw nsw i64 %225, 3
  %233 = getelementptr inbounds double, ptr %2, i64 %232
  %234 = load double, ptr %233, align 8
  %235 = fsub double %230, %234
  %236 = fcmp ogt double %231, %235
  %237 = select i1 %236, double %231, double %235
  %238 = fcmp ogt double %237, 0.000000e+00
  %239 = select i1 %238, double %237, double 0.000000e+00
  %240 = fmul double %239, %239
  %241 = fadd double %226, %240
  %242 = add nuw nsw i64 %225, 1
  %243 = icmp eq i64 %242, 3
  br i1 %243, label %244, label %224

244:                                              ; preds = %224
  %245 = fcmp ogt double %241, 0.000000e+00
  br i1 %245, label %246, label %267

246:                                              ; preds = %244, %262
  %247 = phi i64 [ %265, %262 ], [ 0, %244 ]
  %248 = getelementptr inbounds double, ptr %158, i64 %247
  %249 = load double, ptr %248, align 8
  %250 = getelementptr inbounds double, ptr %2, i64 %247
  %251 = load double, ptr %250, align 8
  %252 = fcmp olt double %249, %251
  br i1 %252, label %253, label %255

253:                                              ; preds = %246
  %254 = fsub double %249, %251
  br label %262

255:                                              ; preds = %246
  %256 = add nuw nsw i64 %247, 3
  %257 = getelementptr inbounds double, ptr %2, i64 %256
  %258 = load double, ptr %257, align 8
  %259 = fcmp ogt double %249, %258
  br i1 %259, label %260, label %262

260:                                              ; preds = %255
  %261 = fsub double %249, %258
  br label %262

262:                                              ; preds = %260, %255, %253
  %263 = phi double [ %254, %253 ], [ %261, %260 ], [ 0.000000e+00, %255 ]
  %264 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %247
  store double %263, ptr %264, align 8
  %265 = add nuw nsw i64 %247, 1
  %266 = icmp eq i64 %265, 3
  br i1 %266, label %267, label %246

267:                                              ; preds = %262, %221, %244, %220
  %268 = phi ptr [ %222, %221 ], [ %222, %244 ], [ %208, %220 ], [ %222, %262 ]
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %10) #15
  call fastcc void @core_of(ptr noundef %13, i64 noundef %1, ptr noundef nonnull %10)
  call void @llvm.lifetime.start.p0(i64 224, ptr nonnull %11) #15
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %12) #15
  %269 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %270 = load ptr, ptr %269, align 8
  %271 = call fastcc i32 @shape_bounds(ptr noundef %13, i64 noundef %42, ptr noundef %270, i64 noundef %1, ptr noundef nonnull %10, ptr noundef nonnull %9, double noundef %154, double noundef %153, ptr noundef nonnull %4, ptr noundef nonnull %5, ptr noundef null, ptr noundef nonnull %11)
  br i1 %205, label %273, label %272

272:                                              ; preds = %267
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %268, ptr noundef nonnull align 16 dereferenceable(24) %9, i64 24, i1 false)
  br label %273

273:                                              ; preds = %272, %267
  %274 = icmp eq i32 %271, 0
  br i1 %274, label %277, label %275

275:                                              ; preds = %273
  %276 = load double, ptr %4, align 8
  br label %298

277:                                              ; preds = %273
  %278 = load ptr, ptr %23, align 8
  %279 = icmp eq ptr %278, null
  br i1 %279, label %296, label %280

280:                                              ; preds = %277
  %281 = load ptr, ptr %269, align 8
  %282 = call fastcc i32 @depth_of(ptr noundef %281, ptr noundef nonnull %10, ptr noundef nonnull %11, ptr noundef nonnull %12, ptr noundef null, ptr noundef null, ptr noundef null)
  %283 = icmp eq i32 %282, 0
  br i1 %283, label %296, label %284

284:                                              ; preds = %280
  %285 = load double, ptr %12, align 8
  %286 = fneg double %285
  %287 = getelementptr inbounds %struct.World, ptr %13, i64 0, i32 15
  %288 = load ptr, ptr %287, align 8
  %289 = load i64, ptr %41, align 8
  %290 = getelementptr inbounds double, ptr %288, i64 %289
  %291 = load double, ptr %290, align 8
  %292 = fsub double %286, %291
  %293 = getelementptr inbounds double, ptr %288, i64 %1
  %294 = load double, ptr %293, align 8
  %295 = fsub double %292, %294
  store double %295, ptr %5, align 8
  br label %298

296:                                              ; preds = %280, %277
  %297 = load double, ptr %4, align 8
  br label %301

298:                                              ; preds = %275, %284
  %299 = phi double [ %276, %275 ], [ %295, %284 ]
  %300 = fcmp ugt double %299, %154
  br i1 %300, label %305, label %301

301:                                              ; preds = %296, %298
  %302 = phi double [ %297, %296 ], [ %299, %298 ]
  %303 = phi i32 [ 0, %296 ], [ 1, %298 ]
  %304 = load double, ptr %5, align 8
  call fastcc void @tell(ptr noundef nonnull %0, i64 noundef %1, i32 noundef %303, double noundef %302, double noundef %304)
  br label %305

305:                                              ; preds = %298, %301
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %12) #15
  call void @llvm.lifetime.end.p0(i64 224, ptr nonnull %11) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %10) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #15
  br label %307

306:                                              ; preds = %161, %196, %199
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #15
  br label %307

307:                                              ; preds = %80, %76, %74, %72, %67, %48, %141, %95, %98, %305, %306
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %5) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %4) #15
  br label %308

308:                                              ; preds = %26, %3, %30, %307
  ret void
}

define dso_local void @manipplan_intervals(ptr noundef %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, i64 noundef %3, ptr nocapture noundef readonly %4, ptr nocapture noundef readonly %5, ptr nocapture noundef readonly %6, ptr noundef %7, ptr nocapture noundef writeonly %8) local_unnamed_addr #0 {
  %10 = alloca [3 x double], align 16
  %11 = alloca i64, align 8
  %12 = alloca %struct.Core, align 8
  %13 = alloca %struct.Core, align 8
  %14 = alloca %struct.Plane, align 8
  %15 = alloca double, align 8
  %16 = alloca double, align 8
  %17 = alloca [3 x double], align 16
  %18 = alloca [3 x double], align 16
  %19 = alloca [12 x double], align 16
  %20 = alloca [3 x double], align 16
  %21 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %10) #15
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %10, i8 0, i64 24, i1 false)
  %22 = icmp sgt i64 %3, 0
  br i1 %22, label %23, label %40

23:                                               ; preds = %9
  %24 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %25 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 12
  %26 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %27 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 15
  %28 = getelementptr inbounds double, ptr %10, i64 1
  %29 = getelementptr inbounds double, ptr %10, i64 2
  %30 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 38
  %31 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 37
  %32 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 16
  %33 = getelementptr inbounds double, ptr %14, i64 1
  %34 = getelementptr inbounds double, ptr %18, i64 1
  %35 = getelementptr inbounds double, ptr %14, i64 2
  %36 = getelementptr inbounds double, ptr %18, i64 2
  %37 = getelementptr inbounds double, ptr %17, i64 1
  %38 = getelementptr inbounds double, ptr %17, i64 2
  %39 = getelementptr inbounds i8, ptr %19, i64 72
  br label %41

40:                                               ; preds = %299, %9
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %10) #15
  ret void

41:                                               ; preds = %23, %299
  %42 = phi ptr [ %2, %23 ], [ %302, %299 ]
  %43 = phi i64 [ 0, %23 ], [ %300, %299 ]
  %44 = shl nuw nsw i64 %43, 1
  %45 = getelementptr inbounds i64, ptr %4, i64 %44
  %46 = load i64, ptr %45, align 8
  %47 = or i64 %44, 1
  %48 = getelementptr inbounds i64, ptr %4, i64 %47
  %49 = load i64, ptr %48, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %11) #15
  %50 = icmp eq i64 %43, 0
  br i1 %50, label %62, label %51

51:                                               ; preds = %41
  %52 = add nsw i64 %44, -2
  %53 = getelementptr inbounds i64, ptr %4, i64 %52
  %54 = load i64, ptr %53, align 8
  %55 = icmp eq i64 %46, %54
  br i1 %55, label %56, label %61

56:                                               ; preds = %51
  %57 = add nsw i64 %44, -1
  %58 = getelementptr inbounds i64, ptr %4, i64 %57
  %59 = load i64, ptr %58, align 8
  %60 = icmp eq i64 %49, %59
  br i1 %60, label %63, label %61

61:                                               ; preds = %56, %51
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %10, i8 0, i64 24, i1 false)
  br label %63

62:                                               ; preds = %41
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %10, i8 0, i64 24, i1 false)
  br label %73

63:                                               ; preds = %56, %61
  %64 = load i64, ptr %24, align 8
  %65 = mul nsw i64 %64, %43
  %66 = getelementptr inbounds double, ptr %1, i64 %65
  %67 = add nsw i64 %43, -1
  %68 = mul nsw i64 %64, %67
  %69 = getelementptr inbounds double, ptr %1, i64 %68
  %70 = shl i64 %64, 3
  %71 = call i32 @bcmp(ptr %66, ptr %69, i64 %70)
  %72 = icmp eq i32 %71, 0
  br i1 %72, label %76, label %73

73:                                               ; preds = %62, %63
  %74 = phi i64 [ 0, %62 ], [ %65, %63 ]
  %75 = getelementptr inbounds double, ptr %1, i64 %74
  call fastcc void @place(ptr noundef %0, ptr noundef %75)
  br label %76

76:                                               ; preds = %73, %63
  %77 = getelementptr inbounds double, ptr %8, i64 %43
  store double 0xFFF0000000000000, ptr %77, align 8
  %78 = load ptr, ptr %25, align 8
  %79 = getelementptr inbounds i64, ptr %78, i64 %49
  %80 = load i64, ptr %79, align 8
  %81 = icmp eq i64 %80, 3
  br i1 %81, label %82, label %89

82:                                               ; preds = %76
  %83 = load ptr, ptr %26, align 8
  %84 = getelementptr inbounds i64, ptr %83, i64 %46
  %85 = load i64, ptr %84, align 8
  %86 = getelementptr inbounds i64, ptr %83, i64 %49
  %87 = load i64, ptr %86, align 8
  %88 = icmp slt i64 %85, %87
  br label %89

89:                                               ; preds = %82, %76
  %90 = phi i1 [ false, %76 ], [ %88, %82 ]
  %91 = getelementptr inbounds i64, ptr %78, i64 %46
  %92 = load i64, ptr %91, align 8
  %93 = icmp sgt i64 %92, 2
  %94 = icmp sgt i64 %80, 3
  %95 = select i1 %93, i1 true, i1 %94
  %96 = select i1 %95, i1 true, i1 %90
  br i1 %96, label %102, label %97

97:                                               ; preds = %89
  %98 = getelementptr inbounds double, ptr %6, i64 %43
  %99 = load double, ptr %98, align 8
  %100 = call double @llvm.fabs.f64(double %99) #14
  %101 = fcmp ueq double %100, 0x7FF0000000000000
  br i1 %101, label %102, label %108

102:                                              ; preds = %97, %89
  %103 = load i64, ptr %24, align 8
  %104 = mul nsw i64 %103, %43
  %105 = getelementptr inbounds double, ptr %1, i64 %104
  %106 = getelementptr inbounds double, ptr %5, i64 %43
  %107 = getelementptr inbounds double, ptr %7, i64 %43
  call void @manipplan_pairs(ptr noundef nonnull %0, ptr noundef %105, i64 noundef 1, ptr noundef nonnull %45, ptr noundef %106, ptr noundef %107, ptr noundef nonnull %11)
  br label %299

108:                                              ; preds = %97
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %12) #15
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %13) #15
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %14) #15
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %15) #15
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %16) #15
  %109 = load ptr, ptr %27, align 8
  %110 = getelementptr inbounds double, ptr %109, i64 %46
  %111 = load double, ptr %110, align 8
  %112 = getelementptr inbounds double, ptr %109, i64 %49
  %113 = load double, ptr %112, align 8
  %114 = fadd double %111, %113
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %17) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %18) #15
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %46, ptr noundef nonnull %12)
  %115 = load i64, ptr %79, align 8
  %116 = icmp eq i64 %115, 3
  br i1 %116, label %117, label %188

117:                                              ; preds = %108
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %19) #15
  %118 = load ptr, ptr %31, align 8
  %119 = load ptr, ptr %26, align 8
  %120 = getelementptr inbounds i64, ptr %119, i64 %49
  %121 = load i64, ptr %120, align 8
  %122 = mul nsw i64 %121, 12
  %123 = getelementptr inbounds double, ptr %118, i64 %122
  %124 = load ptr, ptr %32, align 8
  %125 = mul nsw i64 %49, 12
  %126 = getelementptr inbounds double, ptr %124, i64 %125
  %127 = getelementptr inbounds double, ptr %126, i64 9
  %128 = getelementptr inbounds double, ptr %126, i64 10
  %129 = getelementptr inbounds double, ptr %126, i64 11
  %130 = load double, ptr %127, align 8
  %131 = load double, ptr %128, align 8
  %132 = load double, ptr %129, align 8
  br label %133

133:                                              ; preds = %144, %117
  %134 = phi i64 [ 0, %117 ], [ %155, %144 ]
  %135 = mul nuw nsw i64 %134, 3
  %136 = getelementptr inbounds double, ptr %123, i64 %135
  %137 = add nuw nsw i64 %135, 1
  %138 = getelementptr inbounds double, ptr %123, i64 %137
  %139 = add nuw nsw i64 %135, 2
  %140 = getelementptr inbounds double, ptr %123, i64 %139
  %141 = load double, ptr %136, align 8
  %142 = load double, ptr %138, align 8
  %143 = load double, ptr %140, align 8
  br label %158

144:                                              ; preds = %158
  %145 = fmul double %141, %130
  %146 = fmul double %142, %131
  %147 = fadd double %145, %146
  %148 = fmul double %143, %132
  %149 = fadd double %147, %148
  %150 = add nuw nsw i64 %134, 9
  %151 = getelementptr inbounds double, ptr %123, i64 %150
  %152 = load double, ptr %151, align 8
  %153 = fadd double %152, %149
  %154 = getelementptr inbounds double, ptr %19, i64 %150
  store double %153, ptr %154, align 8
  %155 = add nuw nsw i64 %134, 1
  %156 = icmp eq i64 %155, 3
  br i1 %156, label %157, label %133

157:                                              ; preds = %144
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %18, ptr noundef nonnull align 8 dereferenceable(24) %39, i64 24, i1 false)
  br label %179

158:                                              ; preds = %158, %133
  %159 = phi i64 [ 0, %133 ], [ %175, %158 ]
  %160 = getelementptr inbounds double, ptr %126, i64 %159
  %161 = load double, ptr %160, align 8
  %162 = fmul double %141, %161
  %163 = add nuw nsw i64 %159, 3
  %164 = getelementptr inbounds double, ptr %126, i64 %163
  %165 = load double, ptr %164, align 8
  %166 = fmul double %142, %165
  %167 = fadd double %162, %166
  %168 = add nuw nsw i64 %159, 6
  %169 = getelementptr inbounds double, ptr %126, i64 %168
  %170 = load double, ptr %169, align 8
  %171 = fmul double %143, %170
  %172 = fadd double %167, %171
  %173 = add nuw nsw i64 %159, %135
  %174 = getelementptr inbounds double, ptr %19, i64 %173
  store double %172, ptr %174, align 8
  %175 = add nuw nsw i64 %159, 1
  %176 = icmp eq i64 %175, 3
  br i1 %176, label %144, label %158

177:                                              ; preds = %179
  %178 = call fastcc double @over_plane(ptr noundef %0, i64 noundef %46, ptr noundef nonnull %12, i64 noundef %49)
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %19) #15
  br label %234

179:                                              ; preds = %157, %179
  %180 = phi i64 [ 0, %157 ], [ %186, %179 ]
  %181 = mul nuw nsw i64 %180, 3
  %182 = add nuw nsw i64 %181, 2
  %183 = getelementptr inbounds [12 x double], ptr %19, i64 0, i64 %182
  %184 = load double, ptr %183, align 8
  %185 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %180
  store double %184, ptr %185, align 8
  %186 = add nuw nsw i64 %180, 1
  %187 = icmp eq i64 %186, 3
  br i1 %187, label %177, label %179

188:                                              ; preds = %108
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %49, ptr noundef nonnull %13)
  %189 = load double, ptr %10, align 16
  %190 = fmul double %189, %189
  %191 = load double, ptr %28, align 8
  %192 = fmul double %191, %191
  %193 = fadd double %190, %192
  %194 = load double, ptr %29, align 16
  %195 = fmul double %194, %194
  %196 = fadd double %193, %195
  %197 = fcmp ogt double %196, 0.000000e+00
  br i1 %197, label %214, label %198

198:                                              ; preds = %188
  %199 = load ptr, ptr %30, align 8
  %200 = mul nsw i64 %46, 3
  %201 = mul nsw i64 %49, 3
  br label %202

202:                                              ; preds = %198, %202
  %203 = phi i64 [ 0, %198 ], [ %212, %202 ]
  %204 = add nsw i64 %200, %203
  %205 = getelementptr inbounds double, ptr %199, i64 %204
  %206 = load double, ptr %205, align 8
  %207 = add nsw i64 %201, %203
  %208 = getelementptr inbounds double, ptr %199, i64 %207
  %209 = load double, ptr %208, align 8
  %210 = fsub double %206, %209
  %211 = getelementptr inbounds [3 x double], ptr %10, i64 0, i64 %203
  store double %210, ptr %211, align 8
  %212 = add nuw nsw i64 %203, 1
  %213 = icmp eq i64 %212, 3
  br i1 %213, label %214, label %202

214:                                              ; preds = %202, %188
  %215 = getelementptr inbounds double, ptr %5, i64 %43
  %216 = load double, ptr %215, align 8
  %217 = load double, ptr %110, align 8
  %218 = load double, ptr %112, align 8
  %219 = fadd double %217, %218
  %220 = fadd double %216, %219
  %221 = fadd double %219, 0xFFF0000000000000
  %222 = call fastcc i32 @bounds(ptr noundef nonnull %12, ptr noundef nonnull %13, ptr noundef nonnull %10, double noundef %220, double noundef %221, double noundef 0x3DA5FD7FE1796495, ptr noundef nonnull %15, ptr noundef nonnull %16, ptr noundef nonnull %14, ptr noundef null)
  %223 = icmp eq i32 %222, 0
  br i1 %223, label %224, label %229

224:                                              ; preds = %214
  %225 = load i64, ptr %24, align 8
  %226 = mul nsw i64 %225, %43
  %227 = getelementptr inbounds double, ptr %1, i64 %226
  %228 = getelementptr inbounds double, ptr %7, i64 %43
  call void @manipplan_pairs(ptr noundef nonnull %0, ptr noundef %227, i64 noundef 1, ptr noundef nonnull %45, ptr noundef nonnull %215, ptr noundef %228, ptr noundef nonnull %11)
  br label %298

229:                                              ; preds = %214
  %230 = load double, ptr %16, align 8
  %231 = fsub double %230, %219
  %232 = load double, ptr %15, align 8
  %233 = fsub double %232, %219
  call fastcc void @support(ptr noundef nonnull %13, ptr noundef nonnull %14, ptr noundef nonnull %18)
  br label %234

234:                                              ; preds = %229, %177
  %235 = phi double [ %231, %229 ], [ %178, %177 ]
  %236 = phi double [ %233, %229 ], [ %178, %177 ]
  %237 = getelementptr inbounds double, ptr %5, i64 %43
  %238 = load double, ptr %237, align 8
  %239 = fcmp ogt double %236, %238
  br i1 %239, label %245, label %240

240:                                              ; preds = %234
  %241 = fsub double %235, %236
  %242 = fcmp ugt double %241, 1.000000e-08
  br i1 %242, label %243, label %245

243:                                              ; preds = %240
  %244 = getelementptr inbounds double, ptr %7, i64 %43
  store double 0x7FF8000000000000, ptr %244, align 8
  br label %298

245:                                              ; preds = %240, %234
  %246 = phi double [ %238, %234 ], [ %235, %240 ]
  %247 = getelementptr inbounds double, ptr %7, i64 %43
  store double %246, ptr %247, align 8
  %248 = fcmp uno double %246, 0.000000e+00
  br i1 %248, label %298, label %249

249:                                              ; preds = %245
  %250 = load double, ptr %237, align 8
  %251 = fcmp ult double %246, %250
  br i1 %251, label %252, label %298

252:                                              ; preds = %249
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %20) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %21) #15
  %253 = load ptr, ptr %26, align 8
  %254 = getelementptr inbounds i64, ptr %253, i64 %46
  %255 = load i64, ptr %254, align 8
  %256 = getelementptr inbounds i64, ptr %253, i64 %49
  %257 = load i64, ptr %256, align 8
  %258 = icmp slt i64 %255, %257
  br i1 %258, label %285, label %259

259:                                              ; preds = %252
  call fastcc void @twist_of(ptr noundef nonnull %0, i64 noundef %257, i64 noundef %255, ptr noundef %42, ptr noundef nonnull %20, ptr noundef nonnull %21)
  %260 = load double, ptr %14, align 8
  %261 = load double, ptr %18, align 16
  %262 = fmul double %260, %261
  %263 = load double, ptr %33, align 8
  %264 = load double, ptr %34, align 8
  %265 = fmul double %263, %264
  %266 = fadd double %262, %265
  %267 = load double, ptr %35, align 8
  %268 = load double, ptr %36, align 16
  %269 = fmul double %267, %268
  %270 = fadd double %266, %269
  %271 = call fastcc double @stays_apart(ptr noundef nonnull %12, double noundef %270, ptr noundef nonnull %14, ptr noundef nonnull %20, ptr noundef nonnull %21)
  br label %293

272:                                              ; preds = %285
  call fastcc void @support(ptr noundef nonnull %12, ptr noundef nonnull %17, ptr noundef nonnull %18)
  call fastcc void @twist_of(ptr noundef %0, i64 noundef %255, i64 noundef %257, ptr noundef %42, ptr noundef nonnull %20, ptr noundef nonnull %21)
  %273 = load double, ptr %17, align 16
  %274 = load double, ptr %18, align 16
  %275 = fmul double %273, %274
  %276 = load double, ptr %37, align 8
  %277 = load double, ptr %34, align 8
  %278 = fmul double %276, %277
  %279 = fadd double %275, %278
  %280 = load double, ptr %38, align 16
  %281 = load double, ptr %36, align 16
  %282 = fmul double %280, %281
  %283 = fadd double %279, %282
  %284 = call fastcc double @stays_apart(ptr noundef nonnull %13, double noundef %283, ptr noundef nonnull %17, ptr noundef nonnull %20, ptr noundef nonnull %21)
  br label %293

285:                                              ; preds = %252, %285
  %286 = phi i64 [ %291, %285 ], [ 0, %252 ]
  %287 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %286
  %288 = load double, ptr %287, align 8
  %289 = fneg double %288
  %290 = getelementptr inbounds [3 x double], ptr %17, i64 0, i64 %286
  store double %289, ptr %290, align 8
  %291 = add nuw nsw i64 %286, 1
  %292 = icmp eq i64 %291, 3
  br i1 %292, label %272, label %285

293:                                              ; preds = %272, %259
  %294 = phi double [ %284, %272 ], [ %271, %259 ]
  %295 = fsub double %294, %114
  %296 = load double, ptr %98, align 8
  %297 = fsub double %295, %296
  store double %297, ptr %77, align 8
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %21) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %20) #15
  br label %298

298:                                              ; preds = %243, %245, %249, %293, %224
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %18) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %17) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %16) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %15) #15
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %14) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %13) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %12) #15
  br label %299

299:                                              ; preds = %298, %102
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %11) #15
  %300 = add nuw nsw i64 %43, 1
  %301 = load i64, ptr %24, align 8
  %302 = getelementptr inbounds double, ptr %42, i64 %301
  %303 = icmp eq i64 %300, %3
  br i1 %303, label %40, label %41
}

define internal fastcc double @over_plane(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef readonly %2, i64 noundef %3) unnamed_addr #6 {
  %5 = alloca [12 x double], align 16
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %5) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #15
  %8 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 37
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i64, ptr %11, i64 %3
  %13 = load i64, ptr %12, align 8
  %14 = mul nsw i64 %13, 12
  %15 = getelementptr inbounds double, ptr %9, i64 %14
  %16 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 16
  %17 = load ptr, ptr %16, align 8
  %18 = mul nsw i64 %3, 12
  %19 = getelementptr inbounds double, ptr %17, i64 %18
  %20 = getelementptr inbounds double, ptr %19, i64 9
  %21 = getelementptr inbounds double, ptr %19, i64 10
  %22 = getelementptr inbounds double, ptr %19, i64 11
  %23 = load double, ptr %20, align 8
  %24 = load double, ptr %21, align 8
  %25 = load double, ptr %22, align 8
  br label %26

26:                                               ; preds = %37, %4
  %27 = phi i64 [ 0, %4 ], [ %48, %37 ]
  %28 = mul nuw nsw i64 %27, 3
  %29 = getelementptr inbounds double, ptr %15, i64 %28
  %30 = add nuw nsw i64 %28, 1
  %31 = getelementptr inbounds double, ptr %15, i64 %30
  %32 = add nuw nsw i64 %28, 2
  %33 = getelementptr inbounds double, ptr %15, i64 %32
  %34 = load double, ptr %29, align 8
  %35 = load double, ptr %31, align 8
  %36 = load double, ptr %33, align 8
  br label %50

37:                                               ; preds = %50
  %38 = fmul double %34, %23
  %39 = fmul double %35, %24
  %40 = fadd double %38, %39
  %41 = fmul double %36, %25
  %42 = fadd double %40, %41
  %43 = add nuw nsw i64 %27, 9
  %44 = getelementptr inbounds double, ptr %15, i64 %43
  %45 = load double, ptr %44, align 8
  %46 = fadd double %45, %42
  %47 = getelementptr inbounds double, ptr %5, i64 %43
  store double %46, ptr %47, align 8
  %48 = add nuw nsw i64 %27, 1
  %49 = icmp eq i64 %48, 3
  br i1 %49, label %70, label %26

50:                                               ; preds = %50, %26
  %51 = phi i64 [ 0, %26 ], [ %67, %50 ]
  %52 = getelementptr inbounds double, ptr %19, i64 %51
  %53 = load double, ptr %52, align 8
  %54 = fmul double %34, %53
  %55 = add nuw nsw i64 %51, 3
  %56 = getelementptr inbounds double, ptr %19, i64 %55
  %57 = load double, ptr %56, align 8
  %58 = fmul double %35, %57
  %59 = fadd double %54, %58
  %60 = add nuw nsw i64 %51, 6
  %61 = getelementptr inbounds double, ptr %19, i64 %60
  %62 = load double, ptr %61, align 8
  %63 = fmul double %36, %62
  %64 = fadd double %59, %63
  %65 = add nuw nsw i64 %51, %28
  %66 = getelementptr inbounds double, ptr %5, i64 %65
  store double %64, ptr %66, align 8
  %67 = add nuw nsw i64 %51, 1
  %68 = icmp eq i64 %67, 3
  br i1 %68, label %37, label %50

69:                                               ; preds = %70
  call fastcc void @support(ptr noundef %2, ptr noundef nonnull %6, ptr noundef nonnull %7)
  br label %89

70:                                               ; preds = %37, %70
  %71 = phi i64 [ %78, %70 ], [ 0, %37 ]
  %72 = mul nuw nsw i64 %71, 3
  %73 = add nuw nsw i64 %72, 2
  %74 = getelementptr inbounds [12 x double], ptr %5, i64 0, i64 %73
  %75 = load double, ptr %74, align 8
  %76 = fneg double %75
  %77 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %71
  store double %76, ptr %77, align 8
  %78 = add nuw nsw i64 %71, 1
  %79 = icmp eq i64 %78, 3
  br i1 %79, label %69, label %70

80:                                               ; preds = %89
  %81 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 15
  %82 = load ptr, ptr %81, align 8
  %83 = getelementptr inbounds double, ptr %82, i64 %1
  %84 = load double, ptr %83, align 8
  %85 = fsub double %101, %84
  %86 = getelementptr inbounds double, ptr %82, i64 %3
  %87 = load double, ptr %86, align 8
  %88 = fsub double %85, %87
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #15
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %5) #15
  ret double %88

89:                                               ; preds = %69, %89
  %90 = phi i64 [ 0, %69 ], [ %102, %89 ]
  %91 = phi double [ 0.000000e+00, %69 ], [ %101, %89 ]
  %92 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %90
  %93 = load double, ptr %92, align 8
  %94 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %90
  %95 = load double, ptr %94, align 8
  %96 = add nuw nsw i64 %90, 9
  %97 = getelementptr inbounds [12 x double], ptr %5, i64 0, i64 %96
  %98 = load double, ptr %97, align 8
  %99 = fsub double %95, %98
  %100 = fmul double %93, %99
  %101 = fsub double %91, %100
  %102 = add nuw nsw i64 %90, 1
  %103 = icmp eq i64 %102, 3
  br i1 %103, label %80, label %89
}

define internal fastcc i32 @shape_bounds(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef readonly %2, i64 noundef %3, ptr nocapture noundef readonly %4, ptr nocapture noundef %5, double noundef %6, double noundef %7, ptr nocapture noundef %8, ptr nocapture noundef %9, ptr noundef %10, ptr noundef %11) unnamed_addr #0 {
  %13 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 15
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds double, ptr %14, i64 %1
  %16 = load double, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %14, i64 %3
  %18 = load double, ptr %17, align 8
  %19 = fadd double %16, %18
  %20 = fadd double %19, %6
  %21 = fadd double %19, %7
  %22 = tail call fastcc i32 @bounds(ptr noundef %2, ptr noundef %4, ptr noundef %5, double noundef %20, double noundef %21, double noundef 0x3DA5FD7FE1796495, ptr noundef %8, ptr noundef %9, ptr noundef %10, ptr noundef %11)
  %23 = load double, ptr %8, align 8
  %24 = fsub double %23, %19
  store double %24, ptr %8, align 8
  %25 = load double, ptr %9, align 8
  %26 = fsub double %25, %19
  store double %26, ptr %9, align 8
  ret i32 %22
}

define internal fastcc void @support(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef writeonly %2) unnamed_addr #6 {
  %4 = alloca [64 x double], align 16
  %5 = alloca [8 x double], align 16
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #15
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
  switch i64 %34, label %158 [
    i64 0, label %38
    i64 1, label %35
  ]

35:                                               ; preds = %33
  %36 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 6
  %37 = load ptr, ptr %36, align 8
  br label %146

38:                                               ; preds = %33
  %39 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 2
  %40 = load ptr, ptr %39, align 8
  %41 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 3
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 4
  %44 = load ptr, ptr %43, align 8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %4) #15
  %45 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 1
  %46 = load i64, ptr %45, align 8
  %47 = icmp sgt i64 %46, 0
  br i1 %47, label %48, label %138

48:                                               ; preds = %38
  %49 = getelementptr inbounds double, ptr %6, i64 1
  %50 = getelementptr inbounds double, ptr %6, i64 2
  %51 = load double, ptr %6, align 16
  %52 = load double, ptr %49, align 8
  %53 = load double, ptr %50, align 16
  br label %54

54:                                               ; preds = %132, %48
  %55 = phi i64 [ %46, %48 ], [ %137, %132 ]
  %56 = phi double [ 0xFFF0000000000000, %48 ], [ %134, %132 ]
  %57 = phi i64 [ 0, %48 ], [ %135, %132 ]
  %58 = phi i64 [ 0, %48 ], [ %133, %132 ]
  %59 = tail call i64 @llvm.smin.i64(i64 %55, i64 64)
  call void @llvm.lifetime.start.p0(i64 64, ptr nonnull %5) #15
  br label %62

60:                                               ; preds = %62
  %61 = tail call i64 @llvm.smax.i64(i64 %59, i64 1)
  br label %70

62:                                               ; preds = %62, %54
  %63 = phi i64 [ 0, %54 ], [ %65, %62 ]
  %64 = getelementptr inbounds [8 x double], ptr %5, i64 0, i64 %63
  store double 0xFFF0000000000000, ptr %64, align 8
  %65 = add nuw nsw i64 %63, 1
  %66 = icmp eq i64 %65, 8
  br i1 %66, label %60, label %62

67:                                               ; preds = %70
  %68 = and i64 %61, 7
  %69 = icmp eq i64 %68, 0
  br i1 %69, label %87, label %89

70:                                               ; preds = %60, %70
  %71 = phi i64 [ %85, %70 ], [ 0, %60 ]
  %72 = add nuw nsw i64 %71, %57
  %73 = getelementptr inbounds double, ptr %40, i64 %72
  %74 = load double, ptr %73, align 8
  %75 = fmul double %51, %74
  %76 = getelementptr inbounds double, ptr %42, i64 %72
  %77 = load double, ptr %76, align 8
  %78 = fmul double %52, %77
  %79 = fadd double %75, %78
  %80 = getelementptr inbounds double, ptr %44, i64 %72
  %81 = load double, ptr %80, align 8
  %82 = fmul double %53, %81
  %83 = fadd double %79, %82
  %84 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %71
  store double %83, ptr %84, align 8
  %85 = add nuw nsw i64 %71, 1
  %86 = icmp eq i64 %85, %61
  br i1 %86, label %67, label %70

87:                                               ; preds = %89, %67
  %88 = phi i64 [ %61, %67 ], [ %92, %89 ]
  br label %95

89:                                               ; preds = %67, %89
  %90 = phi i64 [ %92, %89 ], [ %61, %67 ]
  %91 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %90
  store double 0xFFF0000000000000, ptr %91, align 8
  %92 = add nuw nsw i64 %90, 1
  %93 = and i64 %92, 7
  %94 = icmp eq i64 %93, 0
  br i1 %94, label %87, label %89

95:                                               ; preds = %99, %87
  %96 = phi i64 [ %100, %99 ], [ 0, %87 ]
  br label %102

97:                                               ; preds = %99
  %98 = load double, ptr %5, align 16
  br label %115

99:                                               ; preds = %102
  %100 = add nuw nsw i64 %96, 8
  %101 = icmp ult i64 %100, %88
  br i1 %101, label %95, label %97

102:                                              ; preds = %102, %95
  %103 = phi i64 [ 0, %95 ], [ %111, %102 ]
  %104 = add nuw nsw i64 %103, %96
  %105 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %104
  %106 = load double, ptr %105, align 8
  %107 = getelementptr inbounds [8 x double], ptr %5, i64 0, i64 %103
  %108 = load double, ptr %107, align 8
  %109 = fcmp ogt double %106, %108
  %110 = select i1 %109, double %106, double %108
  store double %110, ptr %107, align 8
  %111 = add nuw nsw i64 %103, 1
  %112 = icmp eq i64 %111, 8
  br i1 %112, label %99, label %102

113:                                              ; preds = %115
  %114 = fcmp ogt double %121, %56
  br i1 %114, label %124, label %132

115:                                              ; preds = %115, %97
  %116 = phi i64 [ 1, %97 ], [ %122, %115 ]
  %117 = phi double [ %98, %97 ], [ %121, %115 ]
  %118 = getelementptr inbounds [8 x double], ptr %5, i64 0, i64 %116
  %119 = load double, ptr %118, align 8
  %120 = fcmp ogt double %119, %117
  %121 = select i1 %120, double %119, double %117
  %122 = add nuw nsw i64 %116, 1
  %123 = icmp eq i64 %122, 8
  br i1 %123, label %113, label %115

124:                                              ; preds = %113, %124
  %125 = phi i64 [ %129, %124 ], [ 0, %113 ]
  %126 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %125
  %127 = load double, ptr %126, align 8
  %128 = fcmp une double %127, %121
  %129 = add nuw nsw i64 %125, 1
  br i1 %128, label %124, label %130

130:                                              ; preds = %124
  %131 = add nuw nsw i64 %125, %57
  br label %132

132:                                              ; preds = %130, %113
  %133 = phi i64 [ %131, %130 ], [ %58, %113 ]
  %134 = phi double [ %121, %130 ], [ %56, %113 ]
  call void @llvm.lifetime.end.p0(i64 64, ptr nonnull %5) #15
  %135 = add nuw nsw i64 %57, 64
  %136 = icmp sgt i64 %46, %135
  %137 = add i64 %55, -64
  br i1 %136, label %54, label %138

138:                                              ; preds = %132, %38
  %139 = phi i64 [ 0, %38 ], [ %133, %132 ]
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %4) #15
  %140 = getelementptr inbounds double, ptr %40, i64 %139
  %141 = load double, ptr %140, align 8
  %142 = getelementptr inbounds double, ptr %42, i64 %139
  %143 = load double, ptr %142, align 8
  %144 = getelementptr inbounds double, ptr %44, i64 %139
  %145 = load double, ptr %144, align 8
  br label %191

146:                                              ; preds = %35, %146
  %147 = phi i64 [ 0, %35 ], [ %156, %146 ]
  %148 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %147
  %149 = load double, ptr %148, align 8
  %150 = fcmp ult double %149, 0.000000e+00
  %151 = getelementptr inbounds double, ptr %37, i64 %147
  %152 = load double, ptr %151, align 8
  %153 = fneg double %152
  %154 = select i1 %150, double %153, double %152
  %155 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %147
  store double %154, ptr %155, align 8
  %156 = add nuw nsw i64 %147, 1
  %157 = icmp eq i64 %156, 3
  br i1 %157, label %185, label %146

158:                                              ; preds = %33
  %159 = load double, ptr %6, align 16
  %160 = fmul double %159, %159
  %161 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 1
  %162 = load double, ptr %161, align 8
  %163 = fmul double %162, %162
  %164 = fadd double %160, %163
  %165 = tail call double @llvm.sqrt.f64(double %164)
  %166 = fcmp ogt double %165, 0.000000e+00
  br i1 %166, label %167, label %172

167:                                              ; preds = %158
  %168 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 6
  %169 = load ptr, ptr %168, align 8
  %170 = load double, ptr %169, align 8
  %171 = fdiv double %170, %165
  br label %172

172:                                              ; preds = %158, %167
  %173 = phi double [ %171, %167 ], [ 0.000000e+00, %158 ]
  %174 = fmul double %159, %173
  %175 = fmul double %162, %173
  %176 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 2
  %177 = load double, ptr %176, align 16
  %178 = fcmp ult double %177, 0.000000e+00
  %179 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 6
  %180 = load ptr, ptr %179, align 8
  %181 = getelementptr inbounds double, ptr %180, i64 1
  %182 = load double, ptr %181, align 8
  %183 = fneg double %182
  %184 = select i1 %178, double %183, double %182
  br label %191

185:                                              ; preds = %146
  %186 = load double, ptr %7, align 16
  %187 = getelementptr inbounds double, ptr %7, i64 1
  %188 = load double, ptr %187, align 8
  %189 = getelementptr inbounds double, ptr %7, i64 2
  %190 = load double, ptr %189, align 16
  br label %191

191:                                              ; preds = %185, %172, %138
  %192 = phi double [ %190, %185 ], [ %184, %172 ], [ %145, %138 ]
  %193 = phi double [ %188, %185 ], [ %175, %172 ], [ %143, %138 ]
  %194 = phi double [ %186, %185 ], [ %174, %172 ], [ %141, %138 ]
  br label %195

195:                                              ; preds = %195, %191
  %196 = phi i64 [ 0, %191 ], [ %216, %195 ]
  %197 = mul nuw nsw i64 %196, 3
  %198 = getelementptr inbounds double, ptr %9, i64 %197
  %199 = load double, ptr %198, align 8
  %200 = fmul double %199, %194
  %201 = add nuw nsw i64 %197, 1
  %202 = getelementptr inbounds double, ptr %9, i64 %201
  %203 = load double, ptr %202, align 8
  %204 = fmul double %203, %193
  %205 = fadd double %200, %204
  %206 = add nuw nsw i64 %197, 2
  %207 = getelementptr inbounds double, ptr %9, i64 %206
  %208 = load double, ptr %207, align 8
  %209 = fmul double %208, %192
  %210 = fadd double %205, %209
  %211 = add nuw nsw i64 %196, 9
  %212 = getelementptr inbounds double, ptr %9, i64 %211
  %213 = load double, ptr %212, align 8
  %214 = fadd double %213, %210
  %215 = getelementptr inbounds double, ptr %2, i64 %196
  store double %214, ptr %215, align 8
  %216 = add nuw nsw i64 %196, 1
  %217 = icmp eq i64 %216, 3
  br i1 %217, label %218, label %195

218:                                              ; preds = %195
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #15
  ret void
}

define internal fastcc void @twist_of(ptr nocapture noundef readonly %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef %4, ptr nocapture noundef %5) unnamed_addr #6 {
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
  %20 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 37
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
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #15
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

define internal fastcc double @stays_apart(ptr nocapture noundef readonly %0, double noundef %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4) unnamed_addr #6 {
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  %8 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #15
  ret double %43

44:                                               ; preds = %33, %48
  %45 = phi i32 [ -1, %33 ], [ %74, %48 ]
  %46 = phi double [ 0x7FF0000000000000, %33 ], [ %73, %48 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #15
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
  %8 = alloca [3 x double], align 16
  %9 = alloca [3 x double], align 16
  %10 = alloca %struct.Core, align 8
  %11 = alloca %struct.Core, align 8
  %12 = alloca [3 x double], align 16
  %13 = alloca [9 x double], align 16
  %14 = alloca double, align 8
  %15 = alloca double, align 8
  %16 = alloca [12 x double], align 16
  %17 = alloca [3 x double], align 16
  %18 = alloca double, align 8
  %19 = alloca %struct.Search, align 8
  %20 = alloca %struct.Simplex, align 8
  %21 = alloca [3 x double], align 16
  %22 = alloca [3 x double], align 16
  %23 = alloca double, align 8
  %24 = alloca [3 x double], align 16
  %25 = alloca [3 x double], align 16
  %26 = alloca [3 x double], align 16
  %27 = alloca [3 x double], align 16
  %28 = alloca [3 x double], align 16
  %29 = icmp sgt i64 %2, 0
  br i1 %29, label %30, label %83

30:                                               ; preds = %5
  %31 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %32 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %33 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 12
  %34 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 1
  %35 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 2
  %36 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 3
  %37 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 5
  %38 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 6
  %39 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 7
  %40 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 8
  %41 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 9
  %42 = getelementptr inbounds %struct.Search, ptr %19, i64 0, i32 10
  %43 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 36
  %44 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 1
  %45 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 5
  %46 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 2
  %47 = getelementptr inbounds double, ptr %13, i64 3
  %48 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 3
  %49 = getelementptr inbounds double, ptr %13, i64 6
  %50 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 4
  %51 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 37
  %52 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 16
  %53 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 38
  %54 = getelementptr inbounds %struct.Simplex, ptr %20, i64 0, i32 2
  %55 = getelementptr inbounds double, ptr %7, i64 1
  %56 = getelementptr inbounds double, ptr %7, i64 2
  %57 = getelementptr inbounds double, ptr %8, i64 1
  %58 = getelementptr inbounds double, ptr %8, i64 2
  %59 = getelementptr inbounds double, ptr %9, i64 1
  %60 = getelementptr inbounds double, ptr %9, i64 2
  %61 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 1
  %62 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 2
  %63 = getelementptr inbounds %struct.Simplex, ptr %20, i64 0, i32 3
  %64 = getelementptr inbounds %struct.Simplex, ptr %20, i64 0, i32 3, i64 1
  %65 = getelementptr inbounds %struct.Simplex, ptr %20, i64 0, i32 3, i64 2
  %66 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 15
  %67 = getelementptr inbounds double, ptr %24, i64 1
  %68 = getelementptr inbounds double, ptr %24, i64 2
  %69 = getelementptr inbounds double, ptr %25, i64 1
  %70 = getelementptr inbounds double, ptr %25, i64 2
  %71 = getelementptr inbounds double, ptr %21, i64 1
  %72 = getelementptr inbounds double, ptr %21, i64 2
  %73 = getelementptr inbounds double, ptr %22, i64 1
  %74 = getelementptr inbounds double, ptr %22, i64 2
  %75 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 8
  %76 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 6
  %77 = getelementptr inbounds double, ptr %27, i64 1
  %78 = getelementptr inbounds double, ptr %27, i64 2
  %79 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 9
  %80 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 3
  %81 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 2
  %82 = load i64, ptr %32, align 8
  br label %84

83:                                               ; preds = %710, %5
  ret void

84:                                               ; preds = %30, %710
  %85 = phi i64 [ %82, %30 ], [ %712, %710 ]
  %86 = phi ptr [ %1, %30 ], [ %713, %710 ]
  %87 = phi ptr [ %4, %30 ], [ %715, %710 ]
  %88 = phi i64 [ 0, %30 ], [ %711, %710 ]
  %89 = shl nuw nsw i64 %88, 1
  %90 = getelementptr inbounds i64, ptr %3, i64 %89
  %91 = load i64, ptr %90, align 8
  %92 = or i64 %89, 1
  %93 = getelementptr inbounds i64, ptr %3, i64 %92
  %94 = load i64, ptr %93, align 8
  %95 = load ptr, ptr %31, align 8
  %96 = getelementptr inbounds i64, ptr %95, i64 %91
  %97 = load i64, ptr %96, align 8
  %98 = getelementptr inbounds i64, ptr %95, i64 %94
  %99 = load i64, ptr %98, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %21) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %22) #15
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %23) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %24) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %25) #15
  %100 = icmp sgt i64 %85, 0
  br i1 %100, label %103, label %114

101:                                              ; preds = %103
  %102 = icmp eq i32 %111, 0
  br i1 %102, label %442, label %114

103:                                              ; preds = %84, %103
  %104 = phi i32 [ %111, %103 ], [ 1, %84 ]
  %105 = phi i64 [ %112, %103 ], [ 0, %84 ]
  %106 = getelementptr inbounds double, ptr %86, i64 %105
  %107 = load double, ptr %106, align 8
  %108 = call double @llvm.fabs.f64(double %107) #14
  %109 = fcmp one double %108, 0x7FF0000000000000
  %110 = zext i1 %109 to i32
  %111 = and i32 %104, %110
  %112 = add nuw nsw i64 %105, 1
  %113 = icmp eq i64 %112, %85
  br i1 %113, label %101, label %103

114:                                              ; preds = %84, %101
  call fastcc void @place(ptr noundef nonnull %0, ptr noundef %86)
  %115 = load ptr, ptr %33, align 8
  %116 = getelementptr inbounds i64, ptr %115, i64 %91
  %117 = load i64, ptr %116, align 8
  %118 = icmp sgt i64 %117, 2
  br i1 %118, label %442, label %119

119:                                              ; preds = %114
  %120 = getelementptr inbounds i64, ptr %115, i64 %94
  %121 = load i64, ptr %120, align 8
  %122 = icmp eq i64 %121, 5
  br i1 %122, label %442, label %123

123:                                              ; preds = %119
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %10) #15
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %11) #15
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %91, ptr noundef nonnull %10)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %12) #15
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %13) #15
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %14) #15
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %15) #15
  %124 = load i64, ptr %120, align 8
  switch i64 %124, label %273 [
    i64 3, label %125
    i64 4, label %224
  ]

125:                                              ; preds = %123
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %16) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %17) #15
  %126 = load ptr, ptr %51, align 8
  %127 = load ptr, ptr %31, align 8
  %128 = getelementptr inbounds i64, ptr %127, i64 %94
  %129 = load i64, ptr %128, align 8
  %130 = mul nsw i64 %129, 12
  %131 = getelementptr inbounds double, ptr %126, i64 %130
  %132 = load ptr, ptr %52, align 8
  %133 = mul nsw i64 %94, 12
  %134 = getelementptr inbounds double, ptr %132, i64 %133
  %135 = getelementptr inbounds double, ptr %134, i64 9
  %136 = getelementptr inbounds double, ptr %134, i64 10
  %137 = getelementptr inbounds double, ptr %134, i64 11
  %138 = load double, ptr %135, align 8
  %139 = load double, ptr %136, align 8
  %140 = load double, ptr %137, align 8
  br label %141

141:                                              ; preds = %152, %125
  %142 = phi i64 [ 0, %125 ], [ %163, %152 ]
  %143 = mul nuw nsw i64 %142, 3
  %144 = getelementptr inbounds double, ptr %131, i64 %143
  %145 = add nuw nsw i64 %143, 1
  %146 = getelementptr inbounds double, ptr %131, i64 %145
  %147 = add nuw nsw i64 %143, 2
  %148 = getelementptr inbounds double, ptr %131, i64 %147
  %149 = load double, ptr %144, align 8
  %150 = load double, ptr %146, align 8
  %151 = load double, ptr %148, align 8
  br label %165

152:                                              ; preds = %165
  %153 = fmul double %138, %149
  %154 = fmul double %139, %150
  %155 = fadd double %153, %154
  %156 = fmul double %140, %151
  %157 = fadd double %155, %156
  %158 = add nuw nsw i64 %142, 9
  %159 = getelementptr inbounds double, ptr %131, i64 %158
  %160 = load double, ptr %159, align 8
  %161 = fadd double %157, %160
  %162 = getelementptr inbounds double, ptr %16, i64 %158
  store double %161, ptr %162, align 8
  %163 = add nuw nsw i64 %142, 1
  %164 = icmp eq i64 %163, 3
  br i1 %164, label %185, label %141

165:                                              ; preds = %165, %141
  %166 = phi i64 [ 0, %141 ], [ %182, %165 ]
  %167 = getelementptr inbounds double, ptr %134, i64 %166
  %168 = load double, ptr %167, align 8
  %169 = fmul double %149, %168
  %170 = add nuw nsw i64 %166, 3
  %171 = getelementptr inbounds double, ptr %134, i64 %170
  %172 = load double, ptr %171, align 8
  %173 = fmul double %150, %172
  %174 = fadd double %169, %173
  %175 = add nuw nsw i64 %166, 6
  %176 = getelementptr inbounds double, ptr %134, i64 %175
  %177 = load double, ptr %176, align 8
  %178 = fmul double %151, %177
  %179 = fadd double %174, %178
  %180 = add nuw nsw i64 %166, %143
  %181 = getelementptr inbounds double, ptr %16, i64 %180
  store double %179, ptr %181, align 8
  %182 = add nuw nsw i64 %166, 1
  %183 = icmp eq i64 %182, 3
  br i1 %183, label %152, label %165

184:                                              ; preds = %185
  call fastcc void @support(ptr noundef nonnull %10, ptr noundef nonnull %17, ptr noundef nonnull %21)
  br label %196

185:                                              ; preds = %152, %185
  %186 = phi i64 [ %194, %185 ], [ 0, %152 ]
  %187 = mul nuw nsw i64 %186, 3
  %188 = add nuw nsw i64 %187, 2
  %189 = getelementptr inbounds [12 x double], ptr %16, i64 0, i64 %188
  %190 = load double, ptr %189, align 8
  %191 = getelementptr inbounds double, ptr %24, i64 %186
  store double %190, ptr %191, align 8
  %192 = fneg double %190
  %193 = getelementptr inbounds [3 x double], ptr %17, i64 0, i64 %186
  store double %192, ptr %193, align 8
  %194 = add nuw nsw i64 %186, 1
  %195 = icmp eq i64 %194, 3
  br i1 %195, label %184, label %185

196:                                              ; preds = %196, %184
  %197 = phi i64 [ 0, %184 ], [ %209, %196 ]
  %198 = phi double [ 0.000000e+00, %184 ], [ %208, %196 ]
  %199 = getelementptr inbounds double, ptr %24, i64 %197
  %200 = load double, ptr %199, align 8
  %201 = getelementptr inbounds double, ptr %21, i64 %197
  %202 = load double, ptr %201, align 8
  %203 = add nuw nsw i64 %197, 9
  %204 = getelementptr inbounds [12 x double], ptr %16, i64 0, i64 %203
  %205 = load double, ptr %204, align 8
  %206 = fsub double %202, %205
  %207 = fmul double %200, %206
  %208 = fadd double %198, %207
  %209 = add nuw nsw i64 %197, 1
  %210 = icmp eq i64 %209, 3
  br i1 %210, label %211, label %196

211:                                              ; preds = %196
  store double %208, ptr %23, align 8
  br label %213

212:                                              ; preds = %213
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %17) #15
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %16) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %15) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %14) #15
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %13) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %12) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %11) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %10) #15
  br label %453

213:                                              ; preds = %211, %213
  %214 = phi i64 [ %222, %213 ], [ 0, %211 ]
  %215 = getelementptr inbounds double, ptr %21, i64 %214
  %216 = load double, ptr %215, align 8
  %217 = getelementptr inbounds double, ptr %24, i64 %214
  %218 = load double, ptr %217, align 8
  %219 = fmul double %208, %218
  %220 = fsub double %216, %219
  %221 = getelementptr inbounds double, ptr %22, i64 %214
  store double %220, ptr %221, align 8
  %222 = add nuw nsw i64 %214, 1
  %223 = icmp eq i64 %222, 3
  br i1 %223, label %212, label %213

224:                                              ; preds = %123
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %18) #15
  store double 0x7FF0000000000000, ptr %18, align 8
  call void @llvm.lifetime.start.p0(i64 120, ptr nonnull %19) #15
  store ptr %0, ptr %19, align 8
  store i64 %91, ptr %34, align 8
  store ptr %10, ptr %35, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %36, i8 0, i64 16, i1 false)
  store double 0x7FF0000000000000, ptr %37, align 8
  store ptr %18, ptr %38, align 8
  store ptr null, ptr %39, align 8
  store i32 0, ptr %40, align 8
  store i64 -1, ptr %41, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(40) %42, i8 0, i64 40, i1 false)
  call fastcc void @look_at(ptr noundef nonnull %19, i64 noundef %94, ptr noundef null)
  %225 = load double, ptr %18, align 8
  %226 = fcmp ord double %225, 0.000000e+00
  %227 = load i64, ptr %41, align 8
  %228 = icmp sgt i64 %227, -1
  %229 = select i1 %226, i1 %228, i1 false
  br i1 %229, label %230, label %437

230:                                              ; preds = %224
  %231 = load ptr, ptr %43, align 8
  %232 = mul nsw i64 %227, 9
  %233 = getelementptr inbounds double, ptr %231, i64 %232
  br label %234

234:                                              ; preds = %264, %230
  %235 = phi i64 [ 0, %230 ], [ %268, %264 ]
  %236 = phi i32 [ 1, %230 ], [ %267, %264 ]
  %237 = mul nuw nsw i64 %235, 3
  br label %247

238:                                              ; preds = %247
  %239 = add nuw nsw i64 %235, 3
  %240 = getelementptr inbounds double, ptr %233, i64 %239
  %241 = load double, ptr %240, align 8
  %242 = getelementptr inbounds double, ptr %233, i64 %235
  %243 = load double, ptr %242, align 8
  %244 = fsub double %241, %243
  %245 = call double @llvm.fabs.f64(double %244)
  %246 = fcmp olt double %245, 3.000000e-07
  br i1 %246, label %257, label %264

247:                                              ; preds = %247, %234
  %248 = phi i64 [ 0, %234 ], [ %255, %247 ]
  %249 = mul nuw nsw i64 %248, 3
  %250 = add nuw nsw i64 %249, %235
  %251 = getelementptr inbounds double, ptr %233, i64 %250
  %252 = load double, ptr %251, align 8
  %253 = add nuw nsw i64 %248, %237
  %254 = getelementptr inbounds double, ptr %13, i64 %253
  store double %252, ptr %254, align 8
  %255 = add nuw nsw i64 %248, 1
  %256 = icmp eq i64 %255, 3
  br i1 %256, label %238, label %247

257:                                              ; preds = %238
  %258 = add nuw nsw i64 %235, 6
  %259 = getelementptr inbounds double, ptr %233, i64 %258
  %260 = load double, ptr %259, align 8
  %261 = fsub double %260, %243
  %262 = call double @llvm.fabs.f64(double %261)
  %263 = fcmp olt double %262, 3.000000e-07
  br label %264

264:                                              ; preds = %257, %238
  %265 = phi i1 [ false, %238 ], [ %263, %257 ]
  %266 = zext i1 %265 to i32
  %267 = and i32 %236, %266
  %268 = add nuw nsw i64 %235, 1
  %269 = icmp eq i64 %268, 3
  br i1 %269, label %270, label %234

270:                                              ; preds = %264
  store i64 0, ptr %11, align 8
  %271 = icmp eq i32 %267, 0
  %272 = select i1 %271, i64 3, i64 1
  store i64 %272, ptr %44, align 8
  store ptr @place.still, ptr %45, align 8
  store ptr %13, ptr %46, align 8
  store ptr %47, ptr %48, align 8
  store ptr %49, ptr %50, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %12, ptr noundef nonnull align 8 dereferenceable(24) %42, i64 24, i1 false)
  call void @llvm.lifetime.end.p0(i64 120, ptr nonnull %19) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %18) #15
  br label %289

273:                                              ; preds = %123
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %94, ptr noundef nonnull %11)
  %274 = load ptr, ptr %53, align 8
  %275 = mul nsw i64 %91, 3
  %276 = mul nsw i64 %94, 3
  br label %277

277:                                              ; preds = %277, %273
  %278 = phi i64 [ 0, %273 ], [ %287, %277 ]
  %279 = add nsw i64 %278, %275
  %280 = getelementptr inbounds double, ptr %274, i64 %279
  %281 = load double, ptr %280, align 8
  %282 = add nsw i64 %278, %276
  %283 = getelementptr inbounds double, ptr %274, i64 %282
  %284 = load double, ptr %283, align 8
  %285 = fsub double %281, %284
  %286 = getelementptr inbounds [3 x double], ptr %12, i64 0, i64 %278
  store double %285, ptr %286, align 8
  %287 = add nuw nsw i64 %278, 1
  %288 = icmp eq i64 %287, 3
  br i1 %288, label %289, label %277

289:                                              ; preds = %277, %270
  call void @llvm.lifetime.start.p0(i64 224, ptr nonnull %20) #15
  %290 = call fastcc i32 @bounds(ptr noundef nonnull %10, ptr noundef nonnull %11, ptr noundef nonnull %12, double noundef 0x7FF0000000000000, double noundef 0xFFF0000000000000, double noundef 1.000000e-15, ptr noundef nonnull %14, ptr noundef nonnull %15, ptr noundef null, ptr noundef nonnull %20)
  %291 = icmp eq i32 %290, 0
  br i1 %291, label %292, label %303

292:                                              ; preds = %289
  %293 = load ptr, ptr %33, align 8
  %294 = getelementptr inbounds i64, ptr %293, i64 %94
  %295 = load i64, ptr %294, align 8
  %296 = icmp eq i64 %295, 4
  br i1 %296, label %438, label %297

297:                                              ; preds = %292
  %298 = call fastcc i32 @depth_of(ptr noundef nonnull %10, ptr noundef nonnull %11, ptr noundef nonnull %20, ptr noundef nonnull %23, ptr noundef nonnull %24, ptr noundef nonnull %21, ptr noundef nonnull %22)
  %299 = icmp eq i32 %298, 0
  br i1 %299, label %438, label %300

300:                                              ; preds = %297
  %301 = load double, ptr %23, align 8
  %302 = fneg double %301
  store double %302, ptr %23, align 8
  br label %439

303:                                              ; preds = %289
  %304 = load double, ptr %15, align 8
  %305 = load double, ptr %14, align 8
  %306 = fsub double %304, %305
  %307 = fcmp ogt double %306, 1.000000e-08
  %308 = fcmp olt double %304, 0x3EB0C6F7A0B5ED8D
  %309 = or i1 %308, %307
  br i1 %309, label %438, label %310

310:                                              ; preds = %303
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #15
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %6, ptr noundef nonnull align 16 dereferenceable(24) @__const.nearest_of.share, i64 24, i1 false)
  %311 = load i32, ptr %54, align 8
  %312 = add i32 %311, -4
  %313 = icmp ult i32 %312, -3
  br i1 %313, label %418, label %314

314:                                              ; preds = %310
  %315 = icmp ugt i32 %311, 1
  br i1 %315, label %316, label %391

316:                                              ; preds = %314
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #15
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %8, i8 0, i64 24, i1 false)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #15
  %317 = icmp eq i32 %311, 3
  br label %335

318:                                              ; preds = %352
  %319 = load double, ptr %7, align 16
  %320 = fmul double %319, %319
  %321 = load double, ptr %55, align 8
  %322 = fmul double %321, %321
  %323 = fadd double %320, %322
  %324 = load double, ptr %56, align 16
  %325 = fmul double %324, %324
  %326 = fadd double %323, %325
  %327 = load double, ptr %8, align 16
  %328 = fmul double %319, %327
  %329 = load double, ptr %57, align 8
  %330 = fmul double %321, %329
  %331 = fadd double %328, %330
  %332 = load double, ptr %58, align 16
  %333 = fmul double %324, %332
  %334 = fadd double %331, %333
  br i1 %317, label %355, label %361

335:                                              ; preds = %352, %316
  %336 = phi i64 [ 0, %316 ], [ %353, %352 ]
  %337 = getelementptr inbounds [4 x [3 x double]], ptr %20, i64 0, i64 1, i64 %336
  %338 = load double, ptr %337, align 8
  %339 = getelementptr inbounds [3 x double], ptr %20, i64 0, i64 %336
  %340 = load double, ptr %339, align 8
  %341 = fsub double %338, %340
  %342 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %336
  store double %341, ptr %342, align 8
  %343 = getelementptr inbounds %struct.Simplex, ptr %20, i64 0, i32 3, i64 %336
  %344 = load double, ptr %343, align 8
  %345 = fsub double %344, %340
  %346 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %336
  store double %345, ptr %346, align 8
  br i1 %317, label %347, label %352

347:                                              ; preds = %335
  %348 = getelementptr inbounds [4 x [3 x double]], ptr %20, i64 0, i64 2, i64 %336
  %349 = load double, ptr %348, align 8
  %350 = fsub double %349, %340
  %351 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %336
  store double %350, ptr %351, align 8
  br label %352

352:                                              ; preds = %347, %335
  %353 = add nuw nsw i64 %336, 1
  %354 = icmp eq i64 %353, 3
  br i1 %354, label %318, label %335

355:                                              ; preds = %318
  %356 = fmul double %327, %327
  %357 = fmul double %329, %329
  %358 = fadd double %356, %357
  %359 = fmul double %332, %332
  %360 = fadd double %358, %359
  br label %361

361:                                              ; preds = %355, %318
  %362 = phi double [ %360, %355 ], [ 1.000000e+00, %318 ]
  %363 = fmul double %326, %362
  %364 = fmul double %334, %334
  %365 = fsub double %363, %364
  %366 = fcmp ogt double %365, 0.000000e+00
  br i1 %366, label %367, label %417

367:                                              ; preds = %361
  %368 = load double, ptr %9, align 16
  %369 = fmul double %319, %368
  %370 = load double, ptr %59, align 8
  %371 = fmul double %321, %370
  %372 = fadd double %369, %371
  %373 = load double, ptr %60, align 16
  %374 = fmul double %324, %373
  %375 = fadd double %372, %374
  %376 = fmul double %362, %375
  %377 = fmul double %327, %368
  %378 = fmul double %329, %370
  %379 = fadd double %377, %378
  %380 = fmul double %332, %373
  %381 = fadd double %379, %380
  %382 = fmul double %334, %381
  %383 = fsub double %376, %382
  %384 = fdiv double %383, %365
  store double %384, ptr %61, align 8
  %385 = fmul double %326, %381
  %386 = fmul double %334, %375
  %387 = fsub double %385, %386
  %388 = fdiv double %387, %365
  store double %388, ptr %62, align 16
  %389 = fsub double 1.000000e+00, %384
  %390 = fsub double %389, %388
  store double %390, ptr %6, align 16
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #15
  br label %391

391:                                              ; preds = %367, %314
  %392 = icmp sgt i32 %311, 0
  %393 = zext i32 %311 to i64
  br label %394

394:                                              ; preds = %398, %391
  %395 = phi i64 [ 0, %391 ], [ %404, %398 ]
  %396 = getelementptr inbounds double, ptr %21, i64 %395
  store double 0.000000e+00, ptr %396, align 8
  br i1 %392, label %406, label %398

397:                                              ; preds = %406
  store double %414, ptr %396, align 8
  br label %398

398:                                              ; preds = %397, %394
  %399 = phi double [ 0.000000e+00, %394 ], [ %414, %397 ]
  %400 = getelementptr inbounds %struct.Simplex, ptr %20, i64 0, i32 3, i64 %395
  %401 = load double, ptr %400, align 8
  %402 = fsub double %399, %401
  %403 = getelementptr inbounds double, ptr %22, i64 %395
  store double %402, ptr %403, align 8
  %404 = add nuw nsw i64 %395, 1
  %405 = icmp eq i64 %404, 3
  br i1 %405, label %419, label %394

406:                                              ; preds = %394, %406
  %407 = phi i64 [ %415, %406 ], [ 0, %394 ]
  %408 = phi double [ %414, %406 ], [ 0.000000e+00, %394 ]
  %409 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %407
  %410 = load double, ptr %409, align 8
  %411 = getelementptr inbounds %struct.Simplex, ptr %20, i64 0, i32 1, i64 %407, i64 %395
  %412 = load double, ptr %411, align 8
  %413 = fmul double %410, %412
  %414 = fadd double %408, %413
  %415 = add nuw nsw i64 %407, 1
  %416 = icmp eq i64 %415, %393
  br i1 %416, label %397, label %406

417:                                              ; preds = %361
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #15
  br label %418

418:                                              ; preds = %417, %310
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #15
  br label %438

419:                                              ; preds = %398
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #15
  %420 = load double, ptr %63, align 8
  %421 = fmul double %420, %420
  %422 = load double, ptr %64, align 8
  %423 = fmul double %422, %422
  %424 = fadd double %421, %423
  %425 = load double, ptr %65, align 8
  %426 = fmul double %425, %425
  %427 = fadd double %424, %426
  %428 = call double @llvm.sqrt.f64(double %427)
  store double %428, ptr %23, align 8
  br label %429

429:                                              ; preds = %429, %419
  %430 = phi i64 [ 0, %419 ], [ %435, %429 ]
  %431 = getelementptr inbounds %struct.Simplex, ptr %20, i64 0, i32 3, i64 %430
  %432 = load double, ptr %431, align 8
  %433 = fdiv double %432, %428
  %434 = getelementptr inbounds double, ptr %24, i64 %430
  store double %433, ptr %434, align 8
  %435 = add nuw nsw i64 %430, 1
  %436 = icmp eq i64 %435, 3
  br i1 %436, label %439, label %429

437:                                              ; preds = %224
  call void @llvm.lifetime.end.p0(i64 120, ptr nonnull %19) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %18) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %15) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %14) #15
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %13) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %12) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %11) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %10) #15
  br label %442

438:                                              ; preds = %297, %292, %303, %418
  call void @llvm.lifetime.end.p0(i64 224, ptr nonnull %20) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %15) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %14) #15
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %13) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %12) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %11) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %10) #15
  br label %442

439:                                              ; preds = %429, %300
  %440 = phi double [ %302, %300 ], [ %428, %429 ]
  call void @llvm.lifetime.end.p0(i64 224, ptr nonnull %20) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %15) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %14) #15
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %13) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %12) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %11) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %10) #15
  %441 = load ptr, ptr %51, align 8
  br label %453

442:                                              ; preds = %114, %119, %438, %437, %101
  %443 = load i64, ptr %32, align 8
  %444 = icmp sgt i64 %443, -13
  br i1 %444, label %445, label %710

445:                                              ; preds = %442
  %446 = add i64 %443, 12
  %447 = call i64 @llvm.smax.i64(i64 %446, i64 0)
  br label %448

448:                                              ; preds = %445, %448
  %449 = phi i64 [ %451, %448 ], [ 0, %445 ]
  %450 = getelementptr inbounds double, ptr %87, i64 %449
  store double 0x7FF8000000000000, ptr %450, align 8
  %451 = add nuw i64 %449, 1
  %452 = icmp eq i64 %449, %447
  br i1 %452, label %710, label %448

453:                                              ; preds = %439, %212
  %454 = phi double [ %440, %439 ], [ %208, %212 ]
  %455 = phi ptr [ %441, %439 ], [ %126, %212 ]
  %456 = mul nsw i64 %97, 12
  %457 = mul nsw i64 %99, 12
  br label %590

458:                                              ; preds = %590
  %459 = getelementptr inbounds double, ptr %455, i64 %457
  %460 = load ptr, ptr %66, align 8
  %461 = getelementptr inbounds double, ptr %460, i64 %91
  %462 = load double, ptr %461, align 8
  %463 = fsub double %454, %462
  %464 = getelementptr inbounds double, ptr %460, i64 %94
  %465 = load double, ptr %464, align 8
  %466 = fsub double %463, %465
  store double %466, ptr %87, align 8
  %467 = getelementptr inbounds double, ptr %87, i64 1
  %468 = load double, ptr %24, align 16
  %469 = load double, ptr %67, align 8
  %470 = load double, ptr %68, align 16
  br label %471

471:                                              ; preds = %471, %458
  %472 = phi i64 [ 0, %458 ], [ %487, %471 ]
  %473 = getelementptr inbounds double, ptr %459, i64 %472
  %474 = load double, ptr %473, align 8
  %475 = fmul double %474, %468
  %476 = add nuw nsw i64 %472, 3
  %477 = getelementptr inbounds double, ptr %459, i64 %476
  %478 = load double, ptr %477, align 8
  %479 = fmul double %478, %469
  %480 = fadd double %475, %479
  %481 = add nuw nsw i64 %472, 6
  %482 = getelementptr inbounds double, ptr %459, i64 %481
  %483 = load double, ptr %482, align 8
  %484 = fmul double %483, %470
  %485 = fadd double %480, %484
  %486 = getelementptr inbounds double, ptr %467, i64 %472
  store double %485, ptr %486, align 8
  %487 = add nuw nsw i64 %472, 1
  %488 = icmp eq i64 %487, 3
  br i1 %488, label %489, label %471

489:                                              ; preds = %471
  %490 = getelementptr inbounds double, ptr %455, i64 %456
  %491 = getelementptr inbounds double, ptr %87, i64 4
  %492 = load double, ptr %25, align 16
  %493 = load double, ptr %69, align 8
  %494 = load double, ptr %70, align 16
  br label %495

495:                                              ; preds = %495, %489
  %496 = phi i64 [ 0, %489 ], [ %511, %495 ]
  %497 = getelementptr inbounds double, ptr %490, i64 %496
  %498 = load double, ptr %497, align 8
  %499 = fmul double %498, %492
  %500 = add nuw nsw i64 %496, 3
  %501 = getelementptr inbounds double, ptr %490, i64 %500
  %502 = load double, ptr %501, align 8
  %503 = fmul double %502, %493
  %504 = fadd double %499, %503
  %505 = add nuw nsw i64 %496, 6
  %506 = getelementptr inbounds double, ptr %490, i64 %505
  %507 = load double, ptr %506, align 8
  %508 = fmul double %507, %494
  %509 = fadd double %504, %508
  %510 = getelementptr inbounds double, ptr %491, i64 %496
  store double %509, ptr %510, align 8
  %511 = add nuw nsw i64 %496, 1
  %512 = icmp eq i64 %511, 3
  br i1 %512, label %513, label %495

513:                                              ; preds = %495
  %514 = getelementptr inbounds double, ptr %87, i64 7
  %515 = load double, ptr %21, align 16
  %516 = getelementptr inbounds double, ptr %490, i64 9
  %517 = load double, ptr %516, align 8
  %518 = fsub double %515, %517
  %519 = load double, ptr %71, align 8
  %520 = getelementptr inbounds double, ptr %490, i64 10
  %521 = load double, ptr %520, align 8
  %522 = fsub double %519, %521
  %523 = load double, ptr %72, align 16
  %524 = getelementptr inbounds double, ptr %490, i64 11
  %525 = load double, ptr %524, align 8
  %526 = fsub double %523, %525
  br label %527

527:                                              ; preds = %527, %513
  %528 = phi i64 [ 0, %513 ], [ %543, %527 ]
  %529 = getelementptr inbounds double, ptr %490, i64 %528
  %530 = load double, ptr %529, align 8
  %531 = fmul double %518, %530
  %532 = add nuw nsw i64 %528, 3
  %533 = getelementptr inbounds double, ptr %490, i64 %532
  %534 = load double, ptr %533, align 8
  %535 = fmul double %522, %534
  %536 = fadd double %531, %535
  %537 = add nuw nsw i64 %528, 6
  %538 = getelementptr inbounds double, ptr %490, i64 %537
  %539 = load double, ptr %538, align 8
  %540 = fmul double %526, %539
  %541 = fadd double %536, %540
  %542 = getelementptr inbounds double, ptr %514, i64 %528
  store double %541, ptr %542, align 8
  %543 = add nuw nsw i64 %528, 1
  %544 = icmp eq i64 %543, 3
  br i1 %544, label %545, label %527

545:                                              ; preds = %527
  %546 = getelementptr inbounds double, ptr %87, i64 10
  %547 = load double, ptr %22, align 16
  %548 = getelementptr inbounds double, ptr %459, i64 9
  %549 = load double, ptr %548, align 8
  %550 = fsub double %547, %549
  %551 = load double, ptr %73, align 8
  %552 = getelementptr inbounds double, ptr %459, i64 10
  %553 = load double, ptr %552, align 8
  %554 = fsub double %551, %553
  %555 = load double, ptr %74, align 16
  %556 = getelementptr inbounds double, ptr %459, i64 11
  %557 = load double, ptr %556, align 8
  %558 = fsub double %555, %557
  br label %559

559:                                              ; preds = %559, %545
  %560 = phi i64 [ 0, %545 ], [ %575, %559 ]
  %561 = getelementptr inbounds double, ptr %459, i64 %560
  %562 = load double, ptr %561, align 8
  %563 = fmul double %550, %562
  %564 = add nuw nsw i64 %560, 3
  %565 = getelementptr inbounds double, ptr %459, i64 %564
  %566 = load double, ptr %565, align 8
  %567 = fmul double %554, %566
  %568 = fadd double %563, %567
  %569 = add nuw nsw i64 %560, 6
  %570 = getelementptr inbounds double, ptr %459, i64 %569
  %571 = load double, ptr %570, align 8
  %572 = fmul double %558, %571
  %573 = fadd double %568, %572
  %574 = getelementptr inbounds double, ptr %546, i64 %560
  store double %573, ptr %574, align 8
  %575 = add nuw nsw i64 %560, 1
  %576 = icmp eq i64 %575, 3
  br i1 %576, label %577, label %559

577:                                              ; preds = %559
  %578 = getelementptr inbounds double, ptr %87, i64 13
  %579 = load i64, ptr %32, align 8
  %580 = shl i64 %579, 3
  call void @llvm.memset.p0.i64(ptr nonnull align 8 %578, i8 0, i64 %580, i1 false)
  %581 = load i64, ptr %0, align 8
  %582 = icmp slt i64 %581, 1
  br i1 %582, label %710, label %583

583:                                              ; preds = %577
  %584 = load ptr, ptr %51, align 8
  %585 = load ptr, ptr %75, align 8
  %586 = load ptr, ptr %76, align 8
  %587 = add nuw i64 %581, 1
  %588 = load ptr, ptr %80, align 8
  %589 = load ptr, ptr %81, align 8
  br label %598

590:                                              ; preds = %453, %590
  %591 = phi i64 [ 0, %453 ], [ %596, %590 ]
  %592 = getelementptr inbounds [3 x double], ptr %24, i64 0, i64 %591
  %593 = load double, ptr %592, align 8
  %594 = fneg double %593
  %595 = getelementptr inbounds [3 x double], ptr %25, i64 0, i64 %591
  store double %594, ptr %595, align 8
  %596 = add nuw nsw i64 %591, 1
  %597 = icmp eq i64 %596, 3
  br i1 %597, label %458, label %590

598:                                              ; preds = %583, %632
  %599 = phi i64 [ 1, %583 ], [ %642, %632 ]
  %600 = mul nuw nsw i64 %599, 12
  %601 = getelementptr inbounds double, ptr %584, i64 %600
  %602 = add nsw i64 %599, -1
  %603 = mul nuw nsw i64 %602, 3
  %604 = getelementptr inbounds double, ptr %585, i64 %603
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %26) #15
  %605 = load double, ptr %604, align 8
  %606 = getelementptr inbounds double, ptr %604, i64 1
  %607 = load double, ptr %606, align 8
  %608 = getelementptr inbounds double, ptr %604, i64 2
  %609 = load double, ptr %608, align 8
  br label %615

610:                                              ; preds = %615
  %611 = getelementptr inbounds double, ptr %601, i64 9
  %612 = getelementptr inbounds double, ptr %601, i64 10
  %613 = getelementptr inbounds double, ptr %601, i64 11
  %614 = load double, ptr %26, align 16
  br label %644

615:                                              ; preds = %598, %615
  %616 = phi i64 [ 0, %598 ], [ %630, %615 ]
  %617 = mul nuw nsw i64 %616, 3
  %618 = getelementptr inbounds double, ptr %601, i64 %617
  %619 = load double, ptr %618, align 8
  %620 = fmul double %619, %605
  %621 = getelementptr inbounds double, ptr %618, i64 1
  %622 = load double, ptr %621, align 8
  %623 = fmul double %622, %607
  %624 = fadd double %620, %623
  %625 = getelementptr inbounds double, ptr %618, i64 2
  %626 = load double, ptr %625, align 8
  %627 = fmul double %626, %609
  %628 = fadd double %624, %627
  %629 = getelementptr inbounds [3 x double], ptr %26, i64 0, i64 %616
  store double %628, ptr %629, align 8
  %630 = add nuw nsw i64 %616, 1
  %631 = icmp eq i64 %630, 3
  br i1 %631, label %610, label %615

632:                                              ; preds = %708
  %633 = getelementptr inbounds double, ptr %588, i64 %602
  %634 = load double, ptr %633, align 8
  %635 = fmul double %709, %634
  %636 = getelementptr inbounds i64, ptr %589, i64 %602
  %637 = load i64, ptr %636, align 8
  %638 = add nsw i64 %637, 13
  %639 = getelementptr inbounds double, ptr %87, i64 %638
  %640 = load double, ptr %639, align 8
  %641 = fadd double %635, %640
  store double %641, ptr %639, align 8
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %26) #15
  %642 = add nuw i64 %599, 1
  %643 = icmp eq i64 %599, %581
  br i1 %643, label %710, label %598

644:                                              ; preds = %610, %708
  %645 = phi i1 [ true, %610 ], [ false, %708 ]
  %646 = phi double [ 0.000000e+00, %610 ], [ %709, %708 ]
  %647 = select i1 %645, i64 %97, i64 %99
  %648 = mul nsw i64 %647, %587
  %649 = add nsw i64 %648, %599
  %650 = getelementptr inbounds i64, ptr %586, i64 %649
  %651 = load i64, ptr %650, align 8
  %652 = icmp eq i64 %651, 0
  br i1 %652, label %708, label %653

653:                                              ; preds = %644
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %27) #15
  %654 = select i1 %645, double %515, double %547
  %655 = load double, ptr %611, align 8
  %656 = fsub double %654, %655
  store double %656, ptr %27, align 16
  %657 = select i1 %645, double %519, double %551
  %658 = load double, ptr %612, align 8
  %659 = fsub double %657, %658
  store double %659, ptr %77, align 8
  %660 = select i1 %645, double %523, double %555
  %661 = load double, ptr %613, align 8
  %662 = fsub double %660, %661
  store double %662, ptr %78, align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %28) #15
  br label %663

663:                                              ; preds = %663, %653
  %664 = phi i64 [ 0, %653 ], [ %665, %663 ]
  %665 = add nuw nsw i64 %664, 1
  %666 = icmp ult i64 %664, 2
  %667 = add nuw nsw i64 %664, 4294967294
  %668 = select i1 %666, i64 %665, i64 %667
  %669 = and i64 %668, 4294967295
  %670 = getelementptr inbounds double, ptr %26, i64 %669
  %671 = load double, ptr %670, align 8
  %672 = icmp eq i64 %664, 0
  %673 = add nuw nsw i64 %664, 4294967295
  %674 = and i64 %673, 4294967295
  %675 = select i1 %672, i64 2, i64 %674
  %676 = getelementptr inbounds double, ptr %27, i64 %675
  %677 = load double, ptr %676, align 8
  %678 = fmul double %671, %677
  %679 = getelementptr inbounds double, ptr %26, i64 %675
  %680 = load double, ptr %679, align 8
  %681 = getelementptr inbounds double, ptr %27, i64 %669
  %682 = load double, ptr %681, align 8
  %683 = fmul double %680, %682
  %684 = fsub double %678, %683
  %685 = getelementptr inbounds double, ptr %28, i64 %664
  store double %684, ptr %685, align 8
  %686 = icmp eq i64 %665, 3
  br i1 %686, label %687, label %663

687:                                              ; preds = %663
  %688 = load ptr, ptr %79, align 8
  %689 = getelementptr inbounds i64, ptr %688, i64 %602
  %690 = load i64, ptr %689, align 8
  %691 = icmp eq i64 %690, 0
  %692 = load double, ptr %28, align 16
  %693 = select i1 %691, double %692, double %614
  %694 = fmul double %468, %693
  %695 = select i1 %691, ptr %28, ptr %26
  %696 = getelementptr inbounds double, ptr %695, i64 1
  %697 = load double, ptr %696, align 8
  %698 = fmul double %469, %697
  %699 = fadd double %694, %698
  %700 = select i1 %691, ptr %28, ptr %26
  %701 = getelementptr inbounds double, ptr %700, i64 2
  %702 = load double, ptr %701, align 16
  %703 = fmul double %470, %702
  %704 = fadd double %699, %703
  %705 = fneg double %704
  %706 = select i1 %645, double %704, double %705
  %707 = fadd double %646, %706
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %28) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %27) #15
  br label %708

708:                                              ; preds = %644, %687
  %709 = phi double [ %707, %687 ], [ %646, %644 ]
  br i1 %645, label %644, label %632

710:                                              ; preds = %632, %448, %577, %442
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %25) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %24) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %23) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %22) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %21) #15
  %711 = add nuw nsw i64 %88, 1
  %712 = load i64, ptr %32, align 8
  %713 = getelementptr inbounds double, ptr %86, i64 %712
  %714 = add nsw i64 %712, 13
  %715 = getelementptr inbounds double, ptr %87, i64 %714
  %716 = icmp eq i64 %711, %2
  br i1 %716, label %83, label %84
}

define dso_local i64 @manipplan_tree(ptr noundef %0, ptr noundef %1, i64 noundef %2, ptr noundef %3, i64 noundef %4, ptr noundef %5, ptr noundef %6) local_unnamed_addr #7 {
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

declare void @llvm.memcpy.p0.p0.i64(ptr noalias nocapture writeonly, ptr noalias nocapture readonly, i64, i1 immarg) #8

define internal fastcc i32 @is_near(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, i64 noundef %3) unnamed_addr #9 {
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
  %22 = getelementptr inbounds %struct.World, ptr %9, i64 0, i32 38
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

declare double @llvm.sin.f64(double) #3

declare double @llvm.cos.f64(double) #3

define internal fastcc void @tell(ptr nocapture noundef %0, i64 noundef %1, i32 noundef %2, double noundef %3, double noundef %4) unnamed_addr #10 {
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
  %38 = getelementptr inbounds %struct.World, ptr %37, i64 0, i32 40
  %39 = load ptr, ptr %38, align 8
  %40 = load i64, ptr %31, align 8
  %41 = add nsw i64 %40, 1
  store i64 %41, ptr %31, align 8
  %42 = getelementptr inbounds i64, ptr %39, i64 %40
  store i64 %16, ptr %42, align 8
  br label %43

43:                                               ; preds = %36, %33, %29
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

60:                                               ; preds = %43, %22, %51, %59, %55, %53
  ret void
}

define internal fastcc void @facing(ptr noalias nocapture sret(%struct.Plane) align 8 %0, ptr nocapture noundef readonly %1, i64 noundef %2, ptr nocapture noundef readonly %3) unnamed_addr #6 {
  %5 = getelementptr inbounds %struct.World, ptr %1, i64 0, i32 18
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds %struct.World, ptr %1, i64 0, i32 38
  %8 = load ptr, ptr %7, align 8
  %9 = mul nsw i64 %2, 3
  %10 = getelementptr inbounds double, ptr %8, i64 %9
  br label %14

11:                                               ; preds = %14
  %12 = tail call double @llvm.sqrt.f64(double %29)
  %13 = fcmp ogt double %12, 0.000000e+00
  br label %59

14:                                               ; preds = %4, %14
  %15 = phi i64 [ 0, %4 ], [ %30, %14 ]
  %16 = phi double [ 0.000000e+00, %4 ], [ %29, %14 ]
  %17 = getelementptr inbounds double, ptr %10, i64 %15
  %18 = load double, ptr %17, align 8
  %19 = getelementptr inbounds double, ptr %3, i64 %15
  %20 = load double, ptr %19, align 8
  %21 = add nuw nsw i64 %15, 3
  %22 = getelementptr inbounds double, ptr %3, i64 %21
  %23 = load double, ptr %22, align 8
  %24 = fadd double %20, %23
  %25 = fmul double %24, 5.000000e-01
  %26 = fsub double %18, %25
  %27 = getelementptr inbounds [3 x double], ptr %0, i64 0, i64 %15
  store double %26, ptr %27, align 8
  %28 = fmul double %26, %26
  %29 = fadd double %16, %28
  %30 = add nuw nsw i64 %15, 1
  %31 = icmp eq i64 %30, 3
  br i1 %31, label %11, label %14

32:                                               ; preds = %68
  %33 = shl nsw i64 %2, 2
  %34 = getelementptr inbounds double, ptr %6, i64 %33
  %35 = load double, ptr %0, align 8
  %36 = load double, ptr %10, align 8
  %37 = fmul double %35, %36
  %38 = getelementptr inbounds double, ptr %0, i64 1
  %39 = load double, ptr %38, align 8
  %40 = getelementptr inbounds double, ptr %10, i64 1
  %41 = load double, ptr %40, align 8
  %42 = fmul double %39, %41
  %43 = fadd double %37, %42
  %44 = getelementptr inbounds double, ptr %0, i64 2
  %45 = load double, ptr %44, align 8
  %46 = getelementptr inbounds double, ptr %10, i64 2
  %47 = load double, ptr %46, align 8
  %48 = fmul double %45, %47
  %49 = fadd double %43, %48
  %50 = getelementptr inbounds double, ptr %34, i64 3
  %51 = load double, ptr %50, align 8
  %52 = getelementptr inbounds %struct.World, ptr %1, i64 0, i32 15
  %53 = load ptr, ptr %52, align 8
  %54 = getelementptr inbounds double, ptr %53, i64 %2
  %55 = load double, ptr %54, align 8
  %56 = fsub double %51, %55
  %57 = fsub double %49, %56
  %58 = getelementptr inbounds %struct.Plane, ptr %0, i64 0, i32 1
  store double %57, ptr %58, align 8
  ret void

59:                                               ; preds = %11, %68
  %60 = phi i64 [ 0, %11 ], [ %71, %68 ]
  br i1 %13, label %61, label %65

61:                                               ; preds = %59
  %62 = getelementptr inbounds [3 x double], ptr %0, i64 0, i64 %60
  %63 = load double, ptr %62, align 8
  %64 = fdiv double %63, %12
  br label %68

65:                                               ; preds = %59
  %66 = icmp eq i64 %60, 0
  %67 = uitofp i1 %66 to double
  br label %68

68:                                               ; preds = %65, %61
  %69 = phi double [ %64, %61 ], [ %67, %65 ]
  %70 = getelementptr inbounds [3 x double], ptr %0, i64 0, i64 %60
  store double %69, ptr %70, align 8
  %71 = add nuw nsw i64 %60, 1
  %72 = icmp eq i64 %71, 3
  br i1 %72, label %32, label %59
}

define internal fastcc void @surface(ptr noundef %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3) unnamed_addr #0 {
  %5 = alloca [3 x double], align 16
  %6 = alloca double, align 8
  %7 = alloca double, align 8
  %8 = alloca [9 x double], align 16
  %9 = alloca %struct.Core, align 8
  %10 = alloca %struct.Plane, align 8
  %11 = alloca [3 x double], align 16
  %12 = alloca %struct.Plane, align 8
  %13 = alloca [3 x double], align 16
  %14 = alloca %struct.Core, align 8
  %15 = alloca [3 x double], align 16
  %16 = load ptr, ptr %0, align 8
  %17 = getelementptr inbounds %struct.World, ptr %16, i64 0, i32 33
  %18 = load ptr, ptr %17, align 8
  %19 = mul nsw i64 %2, 6
  %20 = getelementptr inbounds double, ptr %18, i64 %19
  %21 = getelementptr inbounds %struct.World, ptr %16, i64 0, i32 38
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %24 = load i64, ptr %23, align 8
  %25 = mul nsw i64 %24, 3
  %26 = getelementptr inbounds double, ptr %22, i64 %25
  %27 = getelementptr inbounds %struct.World, ptr %16, i64 0, i32 15
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %28, i64 %1
  %30 = load double, ptr %29, align 8
  %31 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %32 = load ptr, ptr %31, align 8
  %33 = icmp eq ptr %32, null
  br i1 %33, label %47, label %34

34:                                               ; preds = %4
  %35 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %36 = load ptr, ptr %35, align 8
  %37 = icmp eq ptr %36, null
  %38 = getelementptr inbounds i64, ptr %36, i64 %1
  %39 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %40 = select i1 %37, ptr %39, ptr %38
  %41 = load i64, ptr %40, align 8
  %42 = getelementptr inbounds double, ptr %32, i64 %41
  %43 = load double, ptr %42, align 8
  %44 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %45 = load double, ptr %44, align 8
  %46 = tail call double @llvm.minnum.f64(double %43, double %45)
  br label %50

47:                                               ; preds = %4
  %48 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %49 = load double, ptr %48, align 8
  br label %50

50:                                               ; preds = %34, %47
  %51 = phi double [ 0xFFF0000000000000, %34 ], [ %49, %47 ]
  %52 = phi double [ %46, %34 ], [ %49, %47 ]
  %53 = getelementptr inbounds double, ptr %28, i64 %24
  %54 = load double, ptr %53, align 8
  br label %55

55:                                               ; preds = %55, %50
  %56 = phi i64 [ 0, %50 ], [ %73, %55 ]
  %57 = phi double [ 0.000000e+00, %50 ], [ %72, %55 ]
  %58 = getelementptr inbounds double, ptr %20, i64 %56
  %59 = load double, ptr %58, align 8
  %60 = getelementptr inbounds double, ptr %26, i64 %56
  %61 = load double, ptr %60, align 8
  %62 = fsub double %59, %61
  %63 = add nuw nsw i64 %56, 3
  %64 = getelementptr inbounds double, ptr %20, i64 %63
  %65 = load double, ptr %64, align 8
  %66 = fsub double %61, %65
  %67 = fcmp ogt double %62, %66
  %68 = select i1 %67, double %62, double %66
  %69 = fcmp ogt double %68, 0.000000e+00
  %70 = select i1 %69, double %68, double 0.000000e+00
  %71 = fmul double %70, %70
  %72 = fadd double %57, %71
  %73 = add nuw nsw i64 %56, 1
  %74 = icmp eq i64 %73, 3
  br i1 %74, label %75, label %55

75:                                               ; preds = %55
  %76 = fneg double %30
  %77 = fsub double %76, %54
  %78 = tail call double @llvm.sqrt.f64(double %72)
  %79 = getelementptr inbounds %struct.World, ptr %16, i64 0, i32 18
  %80 = load ptr, ptr %79, align 8
  %81 = shl nsw i64 %24, 2
  %82 = or i64 %81, 3
  %83 = getelementptr inbounds double, ptr %80, i64 %82
  %84 = load double, ptr %83, align 8
  br i1 %33, label %96, label %85

85:                                               ; preds = %75
  %86 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %87 = load ptr, ptr %86, align 8
  %88 = icmp eq ptr %87, null
  %89 = getelementptr inbounds i64, ptr %87, i64 %1
  %90 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %91 = select i1 %88, ptr %90, ptr %89
  %92 = load i64, ptr %91, align 8
  %93 = getelementptr inbounds double, ptr %32, i64 %92
  %94 = load double, ptr %93, align 8
  %95 = fcmp uno double %94, 0.000000e+00
  br i1 %95, label %394, label %100

96:                                               ; preds = %75
  %97 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %98 = load i32, ptr %97, align 8
  %99 = icmp eq i32 %98, 1
  br i1 %99, label %394, label %100

100:                                              ; preds = %85, %96
  %101 = fsub double %78, %84
  %102 = fsub double %101, %30
  %103 = fcmp ogt double %102, %52
  br i1 %103, label %394, label %104

104:                                              ; preds = %100, %104
  %105 = phi i64 [ %117, %104 ], [ 0, %100 ]
  %106 = phi double [ %116, %104 ], [ 0.000000e+00, %100 ]
  %107 = getelementptr inbounds [3 x double], ptr %3, i64 0, i64 %105
  %108 = load double, ptr %107, align 8
  %109 = fcmp ogt double %108, 0.000000e+00
  %110 = add nuw nsw i64 %105, 3
  %111 = select i1 %109, i64 %110, i64 %105
  %112 = and i64 %111, 4294967295
  %113 = getelementptr inbounds double, ptr %20, i64 %112
  %114 = load double, ptr %113, align 8
  %115 = fmul double %108, %114
  %116 = fadd double %106, %115
  %117 = add nuw nsw i64 %105, 1
  %118 = icmp eq i64 %117, 3
  br i1 %118, label %119, label %104

119:                                              ; preds = %104
  %120 = getelementptr inbounds %struct.Plane, ptr %3, i64 0, i32 1
  %121 = load double, ptr %120, align 8
  %122 = fsub double %121, %116
  %123 = fadd double %77, %122
  %124 = fcmp ogt double %123, %52
  br i1 %124, label %394, label %125

125:                                              ; preds = %119
  %126 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10
  br label %127

127:                                              ; preds = %127, %125
  %128 = phi i64 [ 0, %125 ], [ %140, %127 ]
  %129 = phi double [ 0.000000e+00, %125 ], [ %139, %127 ]
  %130 = getelementptr inbounds [3 x double], ptr %126, i64 0, i64 %128
  %131 = load double, ptr %130, align 8
  %132 = fcmp ogt double %131, 0.000000e+00
  %133 = add nuw nsw i64 %128, 3
  %134 = select i1 %132, i64 %133, i64 %128
  %135 = and i64 %134, 4294967295
  %136 = getelementptr inbounds double, ptr %20, i64 %135
  %137 = load double, ptr %136, align 8
  %138 = fmul double %131, %137
  %139 = fadd double %129, %138
  %140 = add nuw nsw i64 %128, 1
  %141 = icmp eq i64 %140, 3
  br i1 %141, label %142, label %127

142:                                              ; preds = %127
  %143 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10, i32 1
  %144 = load double, ptr %143, align 8
  %145 = fsub double %144, %139
  %146 = fadd double %77, %145
  %147 = fcmp ogt double %146, %52
  br i1 %147, label %394, label %148

148:                                              ; preds = %142
  %149 = getelementptr inbounds %struct.World, ptr %16, i64 0, i32 34
  %150 = load ptr, ptr %149, align 8
  %151 = shl nsw i64 %2, 1
  %152 = getelementptr inbounds i64, ptr %150, i64 %151
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %6) #15
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %7) #15
  %153 = load i64, ptr %152, align 8
  %154 = icmp slt i64 %153, 0
  br i1 %154, label %155, label %203

155:                                              ; preds = %148
  %156 = getelementptr inbounds %struct.World, ptr %16, i64 0, i32 36
  %157 = load ptr, ptr %156, align 8
  %158 = getelementptr inbounds i64, ptr %152, i64 1
  %159 = load i64, ptr %158, align 8
  %160 = mul nsw i64 %159, 9
  %161 = getelementptr inbounds double, ptr %157, i64 %160
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %8) #15
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %9) #15
  call fastcc void @leaf_core(ptr noundef %161, ptr noundef nonnull %8, ptr noundef nonnull %9)
  %162 = load double, ptr %126, align 8
  %163 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10, i32 0, i64 1
  %164 = load double, ptr %163, align 8
  %165 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10, i32 0, i64 2
  %166 = load double, ptr %165, align 8
  br label %171

167:                                              ; preds = %171
  %168 = fsub double %144, %186
  %169 = fadd double %77, %168
  %170 = fcmp ogt double %169, %52
  br i1 %170, label %202, label %189

171:                                              ; preds = %155, %171
  %172 = phi i64 [ 0, %155 ], [ %187, %171 ]
  %173 = phi double [ 0xFFF0000000000000, %155 ], [ %186, %171 ]
  %174 = mul nuw nsw i64 %172, 3
  %175 = getelementptr inbounds double, ptr %161, i64 %174
  %176 = load double, ptr %175, align 8
  %177 = fmul double %162, %176
  %178 = getelementptr inbounds double, ptr %175, i64 1
  %179 = load double, ptr %178, align 8
  %180 = fmul double %164, %179
  %181 = fadd double %177, %180
  %182 = getelementptr inbounds double, ptr %175, i64 2
  %183 = load double, ptr %182, align 8
  %184 = fmul double %166, %183
  %185 = fadd double %181, %184
  %186 = call double @llvm.maxnum.f64(double %173, double %185)
  %187 = add nuw nsw i64 %172, 1
  %188 = icmp eq i64 %187, 3
  br i1 %188, label %167, label %171

189:                                              ; preds = %167
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %10) #15
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %10, ptr noundef nonnull align 8 dereferenceable(32) %126, i64 32, i1 false)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %11) #15
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %11, ptr noundef nonnull align 8 dereferenceable(24) %126, i64 24, i1 false)
  %190 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %191 = load ptr, ptr %190, align 8
  %192 = call fastcc i32 @shape_bounds(ptr noundef %16, i64 noundef %24, ptr noundef %191, i64 noundef %1, ptr noundef nonnull %9, ptr noundef nonnull %11, double noundef %52, double noundef %51, ptr noundef nonnull %6, ptr noundef nonnull %7, ptr noundef nonnull %10, ptr noundef null)
  %193 = icmp ne i32 %192, 0
  %194 = load double, ptr %6, align 8
  %195 = fcmp ugt double %194, %52
  %196 = select i1 %193, i1 %195, i1 false
  br i1 %196, label %201, label %197

197:                                              ; preds = %189
  %198 = load double, ptr %7, align 8
  call fastcc void @tell(ptr noundef nonnull %0, i64 noundef %1, i32 noundef %192, double noundef %194, double noundef %198)
  %199 = load i64, ptr %158, align 8
  %200 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  store i64 %199, ptr %200, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %126, ptr noundef nonnull align 8 dereferenceable(32) %10, i64 32, i1 false)
  br label %201

201:                                              ; preds = %189, %197
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %11) #15
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %10) #15
  br label %202

202:                                              ; preds = %167, %201
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %9) #15
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %8) #15
  br label %393

203:                                              ; preds = %148
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %12) #15
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %12, ptr noundef nonnull align 8 dereferenceable(32) %3, i64 32, i1 false)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %13) #15
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %14) #15
  %204 = getelementptr inbounds %struct.Core, ptr %14, i64 0, i32 7
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %204, ptr noundef nonnull align 16 dereferenceable(72) @box_core.straight, i64 72, i1 false)
  br label %205

205:                                              ; preds = %205, %203
  %206 = phi i64 [ 0, %203 ], [ %221, %205 ]
  %207 = getelementptr inbounds double, ptr %20, i64 %206
  %208 = load double, ptr %207, align 8
  %209 = add nuw nsw i64 %206, 3
  %210 = getelementptr inbounds double, ptr %20, i64 %209
  %211 = load double, ptr %210, align 8
  %212 = fadd double %208, %211
  %213 = fmul double %212, 5.000000e-01
  %214 = add nuw nsw i64 %206, 9
  %215 = getelementptr inbounds %struct.Core, ptr %14, i64 0, i32 7, i64 %214
  store double %213, ptr %215, align 8
  %216 = load double, ptr %210, align 8
  %217 = load double, ptr %207, align 8
  %218 = fsub double %216, %217
  %219 = fmul double %218, 5.000000e-01
  %220 = getelementptr inbounds double, ptr %13, i64 %206
  store double %219, ptr %220, align 8
  %221 = add nuw nsw i64 %206, 1
  %222 = icmp eq i64 %221, 3
  br i1 %222, label %223, label %205

223:                                              ; preds = %205
  store i64 1, ptr %14, align 8
  %224 = getelementptr inbounds %struct.Core, ptr %14, i64 0, i32 5
  store ptr %204, ptr %224, align 8
  %225 = getelementptr inbounds %struct.Core, ptr %14, i64 0, i32 6
  store ptr %13, ptr %225, align 8
  %226 = getelementptr inbounds %struct.Core, ptr %14, i64 0, i32 7, i64 9
  %227 = load double, ptr %13, align 16
  %228 = fmul double %227, %227
  %229 = getelementptr inbounds double, ptr %13, i64 1
  %230 = load double, ptr %229, align 8
  %231 = fmul double %230, %230
  %232 = fadd double %228, %231
  %233 = getelementptr inbounds double, ptr %13, i64 2
  %234 = load double, ptr %233, align 16
  %235 = fmul double %234, %234
  %236 = fadd double %232, %235
  %237 = call double @llvm.sqrt.f64(double %236)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %5) #15
  %238 = getelementptr inbounds %struct.World, ptr %16, i64 0, i32 37
  %239 = load ptr, ptr %238, align 8
  %240 = getelementptr inbounds %struct.World, ptr %16, i64 0, i32 11
  %241 = load ptr, ptr %240, align 8
  %242 = getelementptr inbounds i64, ptr %241, i64 %24
  %243 = load i64, ptr %242, align 8
  %244 = mul nsw i64 %243, 12
  %245 = getelementptr inbounds double, ptr %239, i64 %244
  %246 = load double, ptr %226, align 8
  %247 = getelementptr inbounds double, ptr %245, i64 9
  %248 = load double, ptr %247, align 8
  %249 = fsub double %246, %248
  %250 = getelementptr inbounds %struct.Core, ptr %14, i64 0, i32 7, i64 10
  %251 = load double, ptr %250, align 8
  %252 = getelementptr inbounds double, ptr %245, i64 10
  %253 = load double, ptr %252, align 8
  %254 = fsub double %251, %253
  %255 = getelementptr inbounds %struct.Core, ptr %14, i64 0, i32 7, i64 11
  %256 = load double, ptr %255, align 8
  %257 = getelementptr inbounds double, ptr %245, i64 11
  %258 = load double, ptr %257, align 8
  %259 = fsub double %256, %258
  br label %260

260:                                              ; preds = %260, %223
  %261 = phi i64 [ 0, %223 ], [ %276, %260 ]
  %262 = getelementptr inbounds double, ptr %245, i64 %261
  %263 = load double, ptr %262, align 8
  %264 = fmul double %249, %263
  %265 = add nuw nsw i64 %261, 3
  %266 = getelementptr inbounds double, ptr %245, i64 %265
  %267 = load double, ptr %266, align 8
  %268 = fmul double %254, %267
  %269 = fadd double %264, %268
  %270 = add nuw nsw i64 %261, 6
  %271 = getelementptr inbounds double, ptr %245, i64 %270
  %272 = load double, ptr %271, align 8
  %273 = fmul double %259, %272
  %274 = fadd double %269, %273
  %275 = getelementptr inbounds double, ptr %5, i64 %261
  store double %274, ptr %275, align 8
  %276 = add nuw nsw i64 %261, 1
  %277 = icmp eq i64 %276, 3
  br i1 %277, label %278, label %260

278:                                              ; preds = %260
  %279 = getelementptr inbounds %struct.World, ptr %16, i64 0, i32 19
  %280 = load ptr, ptr %279, align 8
  %281 = mul nsw i64 %24, 6
  %282 = getelementptr inbounds double, ptr %280, i64 %281
  br label %283

283:                                              ; preds = %283, %278
  %284 = phi i64 [ 0, %278 ], [ %301, %283 ]
  %285 = phi double [ 0.000000e+00, %278 ], [ %300, %283 ]
  %286 = getelementptr inbounds double, ptr %282, i64 %284
  %287 = load double, ptr %286, align 8
  %288 = getelementptr inbounds double, ptr %5, i64 %284
  %289 = load double, ptr %288, align 8
  %290 = fsub double %287, %289
  %291 = add nuw nsw i64 %284, 3
  %292 = getelementptr inbounds double, ptr %282, i64 %291
  %293 = load double, ptr %292, align 8
  %294 = fsub double %289, %293
  %295 = fcmp ogt double %290, %294
  %296 = select i1 %295, double %290, double %294
  %297 = fcmp ogt double %296, 0.000000e+00
  %298 = select i1 %297, double %296, double 0.000000e+00
  %299 = fmul double %298, %298
  %300 = fadd double %285, %299
  %301 = add nuw nsw i64 %284, 1
  %302 = icmp eq i64 %301, 3
  br i1 %302, label %303, label %283

303:                                              ; preds = %283
  %304 = fadd double %30, %52
  %305 = fadd double %304, %237
  %306 = fmul double %305, %305
  %307 = fcmp ule double %300, %306
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5) #15
  br i1 %307, label %308, label %392

308:                                              ; preds = %303
  %309 = fadd double %227, %230
  %310 = fadd double %309, %234
  %311 = load double, ptr %83, align 8
  %312 = fmul double %311, 2.000000e+00
  %313 = fcmp olt double %310, %312
  br i1 %313, label %314, label %339

314:                                              ; preds = %308
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %15) #15
  br label %321

315:                                              ; preds = %321
  %316 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %317 = load ptr, ptr %316, align 8
  %318 = fsub double %52, %77
  %319 = call fastcc i32 @bounds(ptr noundef %317, ptr noundef nonnull %14, ptr noundef nonnull %15, double noundef %318, double noundef %318, double noundef 0x3DA5FD7FE1796495, ptr noundef nonnull %6, ptr noundef nonnull %7, ptr noundef nonnull %12, ptr noundef null)
  %320 = icmp eq i32 %319, 0
  br i1 %320, label %336, label %332

321:                                              ; preds = %314, %321
  %322 = phi i64 [ 0, %314 ], [ %330, %321 ]
  %323 = getelementptr inbounds double, ptr %26, i64 %322
  %324 = load double, ptr %323, align 8
  %325 = add nuw nsw i64 %322, 9
  %326 = getelementptr inbounds %struct.Core, ptr %14, i64 0, i32 7, i64 %325
  %327 = load double, ptr %326, align 8
  %328 = fsub double %324, %327
  %329 = getelementptr inbounds [3 x double], ptr %15, i64 0, i64 %322
  store double %328, ptr %329, align 8
  %330 = add nuw nsw i64 %322, 1
  %331 = icmp eq i64 %330, 3
  br i1 %331, label %315, label %321

332:                                              ; preds = %315
  %333 = load double, ptr %6, align 8
  %334 = fadd double %77, %333
  %335 = fcmp ogt double %334, %52
  br i1 %335, label %338, label %336

336:                                              ; preds = %332, %315
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %15) #15
  %337 = load ptr, ptr %17, align 8
  br label %339

338:                                              ; preds = %332
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %15) #15
  br label %392

339:                                              ; preds = %336, %308
  %340 = phi ptr [ %337, %336 ], [ %18, %308 ]
  %341 = load i64, ptr %152, align 8
  %342 = mul nsw i64 %341, 6
  %343 = getelementptr inbounds double, ptr %340, i64 %342
  br label %344

344:                                              ; preds = %344, %339
  %345 = phi i64 [ 0, %339 ], [ %357, %344 ]
  %346 = phi double [ 0.000000e+00, %339 ], [ %356, %344 ]
  %347 = getelementptr inbounds [3 x double], ptr %12, i64 0, i64 %345
  %348 = load double, ptr %347, align 8
  %349 = fcmp ogt double %348, 0.000000e+00
  %350 = add nuw nsw i64 %345, 3
  %351 = select i1 %349, i64 %350, i64 %345
  %352 = and i64 %351, 4294967295
  %353 = getelementptr inbounds double, ptr %343, i64 %352
  %354 = load double, ptr %353, align 8
  %355 = fmul double %348, %354
  %356 = fadd double %346, %355
  %357 = add nuw nsw i64 %345, 1
  %358 = icmp eq i64 %357, 3
  br i1 %358, label %359, label %344

359:                                              ; preds = %344
  %360 = getelementptr inbounds %struct.Plane, ptr %12, i64 0, i32 1
  %361 = load double, ptr %360, align 8
  %362 = getelementptr inbounds i64, ptr %152, i64 1
  %363 = load i64, ptr %362, align 8
  %364 = mul nsw i64 %363, 6
  %365 = getelementptr inbounds double, ptr %340, i64 %364
  br label %366

366:                                              ; preds = %366, %359
  %367 = phi i64 [ 0, %359 ], [ %379, %366 ]
  %368 = phi double [ 0.000000e+00, %359 ], [ %378, %366 ]
  %369 = getelementptr inbounds [3 x double], ptr %12, i64 0, i64 %367
  %370 = load double, ptr %369, align 8
  %371 = fcmp ogt double %370, 0.000000e+00
  %372 = add nuw nsw i64 %367, 3
  %373 = select i1 %371, i64 %372, i64 %367
  %374 = and i64 %373, 4294967295
  %375 = getelementptr inbounds double, ptr %365, i64 %374
  %376 = load double, ptr %375, align 8
  %377 = fmul double %370, %376
  %378 = fadd double %368, %377
  %379 = add nuw nsw i64 %367, 1
  %380 = icmp eq i64 %379, 3
  br i1 %380, label %381, label %366

381:                                              ; preds = %366
  %382 = fsub double %361, %356
  %383 = fsub double %361, %378
  %384 = fcmp olt double %383, %382
  %385 = zext i1 %384 to i64
  %386 = getelementptr inbounds i64, ptr %152, i64 %385
  %387 = load i64, ptr %386, align 8
  call fastcc void @surface(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %387, ptr noundef nonnull %12)
  %388 = xor i1 %384, true
  %389 = zext i1 %388 to i64
  %390 = getelementptr inbounds i64, ptr %152, i64 %389
  %391 = load i64, ptr %390, align 8
  call fastcc void @surface(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %391, ptr noundef nonnull %12)
  br label %392

392:                                              ; preds = %338, %303, %381
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %14) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %13) #15
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %12) #15
  br label %393

393:                                              ; preds = %392, %202
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %7) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %6) #15
  br label %394

394:                                              ; preds = %85, %119, %142, %96, %100, %393
  ret void
}

define internal fastcc i32 @within(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2) unnamed_addr #9 {
  %4 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 33
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 35
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i64, ptr %7, i64 %1
  %9 = load i64, ptr %8, align 8
  %10 = mul nsw i64 %9, 6
  %11 = getelementptr inbounds double, ptr %5, i64 %10
  br label %12

12:                                               ; preds = %12, %3
  %13 = phi i64 [ 0, %3 ], [ %30, %12 ]
  %14 = phi double [ 0.000000e+00, %3 ], [ %29, %12 ]
  %15 = getelementptr inbounds double, ptr %11, i64 %13
  %16 = load double, ptr %15, align 8
  %17 = getelementptr inbounds double, ptr %2, i64 %13
  %18 = load double, ptr %17, align 8
  %19 = fsub double %16, %18
  %20 = add nuw nsw i64 %13, 3
  %21 = getelementptr inbounds double, ptr %11, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = fsub double %18, %22
  %24 = fcmp ogt double %19, %23
  %25 = select i1 %24, double %19, double %23
  %26 = fcmp ogt double %25, 0.000000e+00
  %27 = select i1 %26, double %25, double 0.000000e+00
  %28 = fmul double %27, %27
  %29 = fadd double %14, %28
  %30 = add nuw nsw i64 %13, 1
  %31 = icmp eq i64 %30, 3
  br i1 %31, label %32, label %12

32:                                               ; preds = %12
  %33 = tail call double @llvm.sqrt.f64(double %29)
  %34 = fcmp ogt double %33, 0.000000e+00
  br i1 %34, label %48, label %38

35:                                               ; preds = %38
  %36 = icmp ugt i32 %45, 1
  %37 = zext i1 %36 to i32
  br label %48

38:                                               ; preds = %32, %38
  %39 = phi i64 [ %46, %38 ], [ 0, %32 ]
  %40 = phi i32 [ %45, %38 ], [ 0, %32 ]
  %41 = getelementptr inbounds [3 x [3 x double]], ptr @within.ray, i64 0, i64 %39
  %42 = tail call fastcc i32 @leaves(ptr noundef %0, i64 noundef %9, ptr noundef %2, ptr noundef nonnull %41)
  %43 = icmp ne i32 %42, 0
  %44 = zext i1 %43 to i32
  %45 = add nuw nsw i32 %40, %44
  %46 = add nuw nsw i64 %39, 1
  %47 = icmp eq i64 %46, 3
  br i1 %47, label %35, label %38

48:                                               ; preds = %32, %35
  %49 = phi i32 [ %37, %35 ], [ 0, %32 ]
  ret i32 %49
}

define internal fastcc i32 @is_beside(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, double noundef %2, i64 noundef %3, double noundef %4) unnamed_addr #9 {
  %6 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #15
  %7 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 37
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %10 = load ptr, ptr %9, align 8
  %11 = getelementptr inbounds i64, ptr %10, i64 %3
  %12 = load i64, ptr %11, align 8
  %13 = mul nsw i64 %12, 12
  %14 = getelementptr inbounds double, ptr %8, i64 %13
  %15 = load double, ptr %1, align 8
  %16 = getelementptr inbounds double, ptr %14, i64 9
  %17 = load double, ptr %16, align 8
  %18 = fsub double %15, %17
  %19 = getelementptr inbounds double, ptr %1, i64 1
  %20 = load double, ptr %19, align 8
  %21 = getelementptr inbounds double, ptr %14, i64 10
  %22 = load double, ptr %21, align 8
  %23 = fsub double %20, %22
  %24 = getelementptr inbounds double, ptr %1, i64 2
  %25 = load double, ptr %24, align 8
  %26 = getelementptr inbounds double, ptr %14, i64 11
  %27 = load double, ptr %26, align 8
  %28 = fsub double %25, %27
  br label %29

29:                                               ; preds = %29, %5
  %30 = phi i64 [ 0, %5 ], [ %45, %29 ]
  %31 = getelementptr inbounds double, ptr %14, i64 %30
  %32 = load double, ptr %31, align 8
  %33 = fmul double %18, %32
  %34 = add nuw nsw i64 %30, 3
  %35 = getelementptr inbounds double, ptr %14, i64 %34
  %36 = load double, ptr %35, align 8
  %37 = fmul double %23, %36
  %38 = fadd double %33, %37
  %39 = add nuw nsw i64 %30, 6
  %40 = getelementptr inbounds double, ptr %14, i64 %39
  %41 = load double, ptr %40, align 8
  %42 = fmul double %28, %41
  %43 = fadd double %38, %42
  %44 = getelementptr inbounds double, ptr %6, i64 %30
  store double %43, ptr %44, align 8
  %45 = add nuw nsw i64 %30, 1
  %46 = icmp eq i64 %45, 3
  br i1 %46, label %47, label %29

47:                                               ; preds = %29
  %48 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 19
  %49 = load ptr, ptr %48, align 8
  %50 = mul nsw i64 %3, 6
  %51 = getelementptr inbounds double, ptr %49, i64 %50
  br label %52

52:                                               ; preds = %52, %47
  %53 = phi i64 [ 0, %47 ], [ %70, %52 ]
  %54 = phi double [ 0.000000e+00, %47 ], [ %69, %52 ]
  %55 = getelementptr inbounds double, ptr %51, i64 %53
  %56 = load double, ptr %55, align 8
  %57 = getelementptr inbounds double, ptr %6, i64 %53
  %58 = load double, ptr %57, align 8
  %59 = fsub double %56, %58
  %60 = add nuw nsw i64 %53, 3
  %61 = getelementptr inbounds double, ptr %51, i64 %60
  %62 = load double, ptr %61, align 8
  %63 = fsub double %58, %62
  %64 = fcmp ogt double %59, %63
  %65 = select i1 %64, double %59, double %63
  %66 = fcmp ogt double %65, 0.000000e+00
  %67 = select i1 %66, double %65, double 0.000000e+00
  %68 = fmul double %67, %67
  %69 = fadd double %54, %68
  %70 = add nuw nsw i64 %53, 1
  %71 = icmp eq i64 %70, 3
  br i1 %71, label %72, label %52

72:                                               ; preds = %52
  %73 = fadd double %2, %4
  %74 = fmul double %73, %73
  %75 = fcmp ogt double %69, %74
  %76 = zext i1 %75 to i32
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #15
  ret i32 %76
}

define internal fastcc i32 @depth_of(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef %3, ptr noundef %4, ptr nocapture noundef %5, ptr nocapture noundef writeonly %6) unnamed_addr #11 {
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
  call void @llvm.lifetime.start.p0(i64 3072, ptr nonnull %26) #15
  call void @llvm.lifetime.start.p0(i64 3072, ptr nonnull %27) #15
  call void @llvm.lifetime.start.p0(i64 12288, ptr nonnull %28) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %20) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %21) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %22) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %23) #15
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
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %24) #15
  %155 = icmp eq i64 %154, 0
  %156 = icmp eq i64 %154, 1
  %157 = select i1 %156, double %132, double %133
  br label %181

158:                                              ; preds = %191
  %159 = add nuw nsw i64 %154, 2
  %160 = getelementptr inbounds [3 x double], ptr %26, i64 %159
  %161 = getelementptr inbounds [3 x double], ptr %27, i64 %159
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %18) #15
  %162 = load double, ptr %24, align 16
  %163 = fneg double %162
  store double %163, ptr %18, align 16
  %164 = load double, ptr %135, align 8
  %165 = fneg double %164
  store double %165, ptr %134, align 8
  %166 = load double, ptr %137, align 16
  %167 = fneg double %166
  store double %167, ptr %136, align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %19) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %19) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %18) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %24) #15
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
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %16) #15
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
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %17) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %17) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %16) #15
  %244 = getelementptr inbounds [3 x double], ptr %26, i64 4
  %245 = getelementptr inbounds [3 x double], ptr %27, i64 4
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %14) #15
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
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %15) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %15) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %14) #15
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
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %25) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %25) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %23) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %22) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %21) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %20) #15
  br label %748

380:                                              ; preds = %376
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %23) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %22) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %21) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %20) #15
  %381 = getelementptr inbounds double, ptr %12, i64 1
  %382 = getelementptr inbounds double, ptr %12, i64 2
  %383 = getelementptr inbounds double, ptr %29, i64 1
  %384 = getelementptr inbounds double, ptr %29, i64 2
  br label %385

385:                                              ; preds = %380, %746
  %386 = phi i64 [ %40, %380 ], [ %460, %746 ]
  %387 = phi i32 [ %279, %380 ], [ %558, %746 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %29) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %30) #15
  %388 = icmp sgt i32 %387, 1
  br i1 %388, label %389, label %391

389:                                              ; preds = %385
  %390 = zext i32 %387 to i64
  br label %414

391:                                              ; preds = %414, %385
  %392 = phi i32 [ 0, %385 ], [ %424, %414 ]
  %393 = sext i32 %392 to i64
  %394 = getelementptr inbounds %struct.Face, ptr %28, i64 %393, i32 1
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %12) #15
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
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %13) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %13) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %12) #15
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
  call void @llvm.lifetime.start.p0(i64 3072, ptr nonnull %11) #15
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
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %31) #15
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
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %10) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %10) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %31) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %30) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %29) #15
  br label %748

745:                                              ; preds = %553, %554, %457, %565
  call void @llvm.lifetime.end.p0(i64 3072, ptr nonnull %11) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %30) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %29) #15
  br label %748

746:                                              ; preds = %575
  call void @llvm.lifetime.end.p0(i64 3072, ptr nonnull %11) #15
  %747 = icmp eq i32 %558, 0
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %30) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %29) #15
  br i1 %747, label %748, label %385

748:                                              ; preds = %746, %745, %743, %379
  %749 = phi i32 [ 0, %379 ], [ %744, %743 ], [ 0, %745 ], [ 0, %746 ]
  call void @llvm.lifetime.end.p0(i64 12288, ptr nonnull %28) #15
  call void @llvm.lifetime.end.p0(i64 3072, ptr nonnull %27) #15
  call void @llvm.lifetime.end.p0(i64 3072, ptr nonnull %26) #15
  ret i32 %749
}

declare double @llvm.minnum.f64(double, double) #3

declare double @llvm.sqrt.f64(double) #3

define internal fastcc void @leaf_core(ptr nocapture noundef readonly %0, ptr noundef %1, ptr nocapture noundef writeonly %2) unnamed_addr #7 {
  br label %4

4:                                                ; preds = %3, %44
  %5 = phi i64 [ 0, %3 ], [ %48, %44 ]
  %6 = phi i32 [ 1, %3 ], [ %47, %44 ]
  %7 = mul nuw nsw i64 %5, 3
  br label %27

8:                                                ; preds = %44
  store i64 0, ptr %2, align 8
  %9 = icmp eq i32 %47, 0
  %10 = select i1 %9, i64 3, i64 1
  %11 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 1
  store i64 %10, ptr %11, align 8
  %12 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 5
  store ptr @place.still, ptr %12, align 8
  %13 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 2
  store ptr %1, ptr %13, align 8
  %14 = getelementptr inbounds double, ptr %1, i64 3
  %15 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 3
  store ptr %14, ptr %15, align 8
  %16 = getelementptr inbounds double, ptr %1, i64 6
  %17 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 4
  store ptr %16, ptr %17, align 8
  ret void

18:                                               ; preds = %27
  %19 = add nuw nsw i64 %5, 3
  %20 = getelementptr inbounds double, ptr %0, i64 %19
  %21 = load double, ptr %20, align 8
  %22 = getelementptr inbounds double, ptr %0, i64 %5
  %23 = load double, ptr %22, align 8
  %24 = fsub double %21, %23
  %25 = tail call double @llvm.fabs.f64(double %24)
  %26 = fcmp olt double %25, 3.000000e-07
  br i1 %26, label %37, label %44

27:                                               ; preds = %4, %27
  %28 = phi i64 [ 0, %4 ], [ %35, %27 ]
  %29 = mul nuw nsw i64 %28, 3
  %30 = add nuw nsw i64 %29, %5
  %31 = getelementptr inbounds double, ptr %0, i64 %30
  %32 = load double, ptr %31, align 8
  %33 = add nuw nsw i64 %28, %7
  %34 = getelementptr inbounds double, ptr %1, i64 %33
  store double %32, ptr %34, align 8
  %35 = add nuw nsw i64 %28, 1
  %36 = icmp eq i64 %35, 3
  br i1 %36, label %18, label %27

37:                                               ; preds = %18
  %38 = add nuw nsw i64 %5, 6
  %39 = getelementptr inbounds double, ptr %0, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = fsub double %40, %23
  %42 = tail call double @llvm.fabs.f64(double %41)
  %43 = fcmp olt double %42, 3.000000e-07
  br label %44

44:                                               ; preds = %37, %18
  %45 = phi i1 [ false, %18 ], [ %43, %37 ]
  %46 = zext i1 %45 to i32
  %47 = and i32 %6, %46
  %48 = add nuw nsw i64 %5, 1
  %49 = icmp eq i64 %48, 3
  br i1 %49, label %8, label %4
}

declare double @llvm.maxnum.f64(double, double) #3

define internal fastcc i32 @bounds(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef %2, double noundef %3, double noundef %4, double noundef %5, ptr nocapture noundef %6, ptr nocapture noundef %7, ptr noundef %8, ptr noundef %9) unnamed_addr #0 {
  %11 = alloca [3 x double], align 16
  %12 = alloca [3 x double], align 16
  %13 = alloca [3 x double], align 16
  %14 = alloca [3 x double], align 16
  %15 = alloca [3 x i32], align 4
  %16 = alloca [3 x double], align 16
  %17 = alloca [3 x double], align 16
  %18 = alloca [3 x double], align 16
  %19 = alloca [3 x double], align 16
  %20 = alloca [3 x i32], align 4
  %21 = alloca %struct.Simplex, align 8
  %22 = alloca %struct.Simplex, align 8
  %23 = alloca [3 x double], align 16
  %24 = alloca [3 x double], align 16
  %25 = alloca [3 x double], align 16
  %26 = alloca [3 x double], align 16
  %27 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 224, ptr nonnull %21) #15
  call void @llvm.lifetime.start.p0(i64 224, ptr nonnull %22)
  %28 = icmp ne ptr %9, null
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %23) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %24) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %25) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %26) #15
  %29 = load double, ptr %2, align 8
  %30 = fmul double %29, %29
  %31 = getelementptr inbounds double, ptr %2, i64 1
  %32 = load double, ptr %31, align 8
  %33 = fmul double %32, %32
  %34 = fadd double %30, %33
  %35 = getelementptr inbounds double, ptr %2, i64 2
  %36 = load double, ptr %35, align 8
  %37 = fmul double %36, %36
  %38 = fadd double %34, %37
  %39 = tail call double @llvm.sqrt.f64(double %38)
  %40 = fcmp ogt double %39, 0.000000e+00
  br label %94

41:                                               ; preds = %103
  %42 = select i1 %28, ptr %9, ptr %21
  store double 0xFFF0000000000000, ptr %6, align 8
  store double 0x7FF0000000000000, ptr %7, align 8
  %43 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 2
  %44 = getelementptr inbounds %struct.Simplex, ptr %21, i64 0, i32 2
  %45 = select i1 %28, ptr %43, ptr %44
  store i32 0, ptr %45, align 8
  %46 = getelementptr inbounds double, ptr %27, i64 1
  %47 = getelementptr inbounds [3 x double], ptr %24, i64 0, i64 1
  %48 = getelementptr inbounds [3 x double], ptr %25, i64 0, i64 1
  %49 = getelementptr inbounds double, ptr %27, i64 2
  %50 = getelementptr inbounds [3 x double], ptr %24, i64 0, i64 2
  %51 = getelementptr inbounds [3 x double], ptr %25, i64 0, i64 2
  %52 = getelementptr inbounds double, ptr %23, i64 1
  %53 = getelementptr inbounds double, ptr %23, i64 2
  %54 = icmp eq ptr %8, null
  %55 = getelementptr inbounds double, ptr %8, i64 1
  %56 = getelementptr inbounds double, ptr %8, i64 2
  %57 = getelementptr inbounds %struct.Plane, ptr %8, i64 0, i32 1
  %58 = getelementptr inbounds double, ptr %13, i64 1
  %59 = getelementptr inbounds double, ptr %13, i64 2
  %60 = select i1 %28, ptr %9, ptr %21
  %61 = getelementptr inbounds double, ptr %60, i64 1
  %62 = select i1 %28, ptr %9, ptr %21
  %63 = getelementptr inbounds double, ptr %62, i64 2
  %64 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 3
  %65 = getelementptr inbounds %struct.Simplex, ptr %21, i64 0, i32 3
  %66 = select i1 %28, ptr %64, ptr %65
  %67 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 1, i64 1
  %68 = getelementptr inbounds %struct.Simplex, ptr %21, i64 0, i32 1, i64 1
  %69 = select i1 %28, ptr %67, ptr %68
  %70 = getelementptr inbounds [4 x [3 x double]], ptr %9, i64 0, i64 1
  %71 = getelementptr inbounds [4 x [3 x double]], ptr %21, i64 0, i64 1
  %72 = select i1 %28, ptr %70, ptr %71
  %73 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 1, i64 0
  %74 = getelementptr inbounds %struct.Simplex, ptr %21, i64 0, i32 1, i64 0
  %75 = select i1 %28, ptr %73, ptr %74
  %76 = getelementptr inbounds [3 x double], ptr %16, i64 0, i64 1
  %77 = getelementptr inbounds [3 x double], ptr %17, i64 0, i64 2
  %78 = getelementptr inbounds [3 x double], ptr %16, i64 0, i64 2
  %79 = getelementptr inbounds [3 x double], ptr %17, i64 0, i64 1
  %80 = getelementptr inbounds double, ptr %18, i64 1
  %81 = getelementptr inbounds double, ptr %18, i64 2
  %82 = getelementptr inbounds double, ptr %11, i64 1
  %83 = getelementptr inbounds double, ptr %11, i64 2
  %84 = getelementptr inbounds double, ptr %12, i64 1
  %85 = getelementptr inbounds double, ptr %12, i64 2
  %86 = getelementptr inbounds double, ptr %19, i64 1
  %87 = getelementptr inbounds double, ptr %19, i64 2
  %88 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 3, i64 1
  %89 = getelementptr inbounds %struct.Simplex, ptr %21, i64 0, i32 3, i64 1
  %90 = select i1 %28, ptr %88, ptr %89
  %91 = getelementptr inbounds %struct.Simplex, ptr %9, i64 0, i32 3, i64 2
  %92 = getelementptr inbounds %struct.Simplex, ptr %21, i64 0, i32 3, i64 2
  %93 = select i1 %28, ptr %91, ptr %92
  br label %108

94:                                               ; preds = %10, %103
  %95 = phi i64 [ 0, %10 ], [ %106, %103 ]
  br i1 %40, label %96, label %100

96:                                               ; preds = %94
  %97 = getelementptr inbounds double, ptr %2, i64 %95
  %98 = load double, ptr %97, align 8
  %99 = fdiv double %98, %39
  br label %103

100:                                              ; preds = %94
  %101 = icmp eq i64 %95, 0
  %102 = uitofp i1 %101 to double
  br label %103

103:                                              ; preds = %100, %96
  %104 = phi double [ %99, %96 ], [ %102, %100 ]
  %105 = getelementptr inbounds [3 x double], ptr %23, i64 0, i64 %95
  store double %104, ptr %105, align 8
  %106 = add nuw nsw i64 %95, 1
  %107 = icmp eq i64 %106, 3
  br i1 %107, label %41, label %94

108:                                              ; preds = %41, %622
  %109 = phi i32 [ 0, %41 ], [ %618, %622 ]
  %110 = phi i32 [ 0, %41 ], [ %623, %622 ]
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %2, ptr noundef nonnull align 16 dereferenceable(24) %23, i64 24, i1 false)
  br label %138

111:                                              ; preds = %138
  call fastcc void @support(ptr noundef %0, ptr noundef nonnull %26, ptr noundef nonnull %24)
  call fastcc void @support(ptr noundef %1, ptr noundef nonnull %23, ptr noundef nonnull %25)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %27) #15
  %112 = load double, ptr %24, align 16
  %113 = load double, ptr %25, align 16
  %114 = fsub double %112, %113
  store double %114, ptr %27, align 16
  %115 = load double, ptr %47, align 8
  %116 = load double, ptr %48, align 8
  %117 = fsub double %115, %116
  store double %117, ptr %46, align 8
  %118 = load double, ptr %50, align 16
  %119 = load double, ptr %51, align 16
  %120 = fsub double %118, %119
  store double %120, ptr %49, align 16
  %121 = load double, ptr %23, align 16
  %122 = fmul double %121, %121
  %123 = load double, ptr %52, align 8
  %124 = fmul double %123, %123
  %125 = fadd double %122, %124
  %126 = load double, ptr %53, align 16
  %127 = fmul double %126, %126
  %128 = fadd double %125, %127
  %129 = tail call double @llvm.sqrt.f64(double %128)
  %130 = fmul double %114, %121
  %131 = fmul double %117, %123
  %132 = fadd double %130, %131
  %133 = fmul double %120, %126
  %134 = fadd double %132, %133
  %135 = fdiv double %134, %129
  %136 = load double, ptr %6, align 8
  %137 = fcmp ogt double %135, %136
  br i1 %137, label %146, label %165

138:                                              ; preds = %108, %138
  %139 = phi i64 [ 0, %108 ], [ %144, %138 ]
  %140 = getelementptr inbounds [3 x double], ptr %23, i64 0, i64 %139
  %141 = load double, ptr %140, align 8
  %142 = fneg double %141
  %143 = getelementptr inbounds [3 x double], ptr %26, i64 0, i64 %139
  store double %142, ptr %143, align 8
  %144 = add nuw nsw i64 %139, 1
  %145 = icmp eq i64 %144, 3
  br i1 %145, label %111, label %138

146:                                              ; preds = %111
  store double %135, ptr %6, align 8
  br i1 %54, label %165, label %157

147:                                              ; preds = %157
  %148 = load double, ptr %8, align 8
  %149 = fmul double %112, %148
  %150 = load double, ptr %55, align 8
  %151 = fmul double %150, %115
  %152 = fadd double %149, %151
  %153 = load double, ptr %56, align 8
  %154 = fmul double %153, %118
  %155 = fadd double %152, %154
  store double %155, ptr %57, align 8
  %156 = load double, ptr %6, align 8
  br label %165

157:                                              ; preds = %146, %157
  %158 = phi i64 [ %163, %157 ], [ 0, %146 ]
  %159 = getelementptr inbounds [3 x double], ptr %23, i64 0, i64 %158
  %160 = load double, ptr %159, align 8
  %161 = fdiv double %160, %129
  %162 = getelementptr inbounds [3 x double], ptr %8, i64 0, i64 %158
  store double %161, ptr %162, align 8
  %163 = add nuw nsw i64 %158, 1
  %164 = icmp eq i64 %163, 3
  br i1 %164, label %147, label %157

165:                                              ; preds = %146, %147, %111
  %166 = phi double [ %135, %146 ], [ %156, %147 ], [ %136, %111 ]
  %167 = fcmp ogt double %166, %3
  br i1 %167, label %620, label %168

168:                                              ; preds = %165
  %169 = load double, ptr %7, align 8
  %170 = fsub double %169, %166
  %171 = fcmp ugt double %170, %5
  br i1 %171, label %172, label %620

172:                                              ; preds = %168
  %173 = icmp sgt i32 %109, 0
  br i1 %173, label %174, label %184

174:                                              ; preds = %172
  %175 = zext i32 %109 to i64
  br label %179

176:                                              ; preds = %179
  %177 = add nuw nsw i64 %180, 1
  %178 = icmp eq i64 %177, %175
  br i1 %178, label %184, label %179

179:                                              ; preds = %174, %176
  %180 = phi i64 [ 0, %174 ], [ %177, %176 ]
  %181 = getelementptr inbounds [4 x [3 x double]], ptr %42, i64 0, i64 %180
  %182 = call i32 @bcmp(ptr noundef nonnull dereferenceable(24) %181, ptr noundef nonnull dereferenceable(24) %27, i64 24)
  %183 = icmp eq i32 %182, 0
  br i1 %183, label %620, label %176

184:                                              ; preds = %176, %172
  br i1 %28, label %185, label %186

185:                                              ; preds = %184
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(224) %22, ptr noundef nonnull align 8 dereferenceable(224) %42, i64 224, i1 false)
  br label %186

186:                                              ; preds = %185, %184
  %187 = sext i32 %109 to i64
  %188 = getelementptr inbounds [4 x [3 x double]], ptr %42, i64 0, i64 %187
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %188, ptr noundef nonnull align 16 dereferenceable(24) %27, i64 24, i1 false)
  %189 = load i32, ptr %45, align 8
  %190 = add nsw i32 %189, 1
  store i32 %190, ptr %45, align 8
  %191 = sext i32 %189 to i64
  %192 = getelementptr inbounds %struct.Simplex, ptr %42, i64 0, i32 1, i64 %191
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %192, ptr noundef nonnull align 16 dereferenceable(24) %24, i64 24, i1 false)
  %193 = load i32, ptr %45, align 8
  switch i32 %193, label %246 [
    i32 1, label %194
    i32 2, label %195
  ]

194:                                              ; preds = %186
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %66, ptr noundef nonnull align 8 dereferenceable(24) %42, i64 24, i1 false)
  br label %578

195:                                              ; preds = %186
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %13) #15
  br label %206

196:                                              ; preds = %206
  %197 = load double, ptr %13, align 16
  %198 = fmul double %197, %197
  %199 = load double, ptr %58, align 8
  %200 = fmul double %199, %199
  %201 = fadd double %198, %200
  %202 = load double, ptr %59, align 16
  %203 = fmul double %202, %202
  %204 = fadd double %201, %203
  %205 = fcmp ogt double %204, 0.000000e+00
  br i1 %205, label %216, label %243

206:                                              ; preds = %206, %195
  %207 = phi i64 [ 0, %195 ], [ %214, %206 ]
  %208 = getelementptr inbounds [4 x [3 x double]], ptr %42, i64 0, i64 1, i64 %207
  %209 = load double, ptr %208, align 8
  %210 = getelementptr inbounds [3 x double], ptr %42, i64 0, i64 %207
  %211 = load double, ptr %210, align 8
  %212 = fsub double %209, %211
  %213 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %207
  store double %212, ptr %213, align 8
  %214 = add nuw nsw i64 %207, 1
  %215 = icmp eq i64 %214, 3
  br i1 %215, label %196, label %206

216:                                              ; preds = %196
  %217 = load double, ptr %42, align 8
  %218 = fmul double %197, %217
  %219 = load double, ptr %61, align 8
  %220 = fmul double %199, %219
  %221 = fadd double %218, %220
  %222 = load double, ptr %63, align 8
  %223 = fmul double %202, %222
  %224 = fadd double %221, %223
  %225 = fneg double %224
  %226 = fdiv double %225, %204
  %227 = fcmp ugt double %226, 0.000000e+00
  br i1 %227, label %228, label %243

228:                                              ; preds = %216
  %229 = fcmp ult double %226, 1.000000e+00
  br i1 %229, label %231, label %230

230:                                              ; preds = %228
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %42, ptr noundef nonnull align 8 dereferenceable(24) %72, i64 24, i1 false)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %75, ptr noundef nonnull align 8 dereferenceable(24) %69, i64 24, i1 false)
  br label %243

231:                                              ; preds = %228, %231
  %232 = phi i64 [ %241, %231 ], [ 0, %228 ]
  %233 = getelementptr inbounds double, ptr %42, i64 %232
  %234 = load double, ptr %233, align 8
  %235 = getelementptr inbounds double, ptr %72, i64 %232
  %236 = load double, ptr %235, align 8
  %237 = fsub double %236, %234
  %238 = fmul double %226, %237
  %239 = fadd double %234, %238
  %240 = getelementptr inbounds double, ptr %66, i64 %232
  store double %239, ptr %240, align 8
  %241 = add nuw nsw i64 %232, 1
  %242 = icmp eq i64 %241, 3
  br i1 %242, label %245, label %231

243:                                              ; preds = %196, %216, %230
  %244 = phi ptr [ %72, %230 ], [ %42, %216 ], [ %42, %196 ]
  store i32 1, ptr %45, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %66, ptr noundef nonnull align 8 dereferenceable(24) %244, i64 24, i1 false)
  br label %245

245:                                              ; preds = %231, %243
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %13) #15
  br label %578

246:                                              ; preds = %186
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %14)
  call void @llvm.lifetime.start.p0(i64 12, ptr nonnull %15) #15
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 4 dereferenceable(12) %15, ptr noundef nonnull align 4 dereferenceable(12) @__const.reduce.chosen, i64 12, i1 false)
  %247 = icmp eq i32 %193, 4
  %248 = zext i1 %247 to i32
  %249 = icmp ne i32 %193, 3
  br label %253

250:                                              ; preds = %529
  %251 = icmp ne i32 %530, 0
  %252 = select i1 %247, i1 %251, i1 false
  br i1 %252, label %576, label %536

253:                                              ; preds = %529, %246
  %254 = phi i64 [ 0, %246 ], [ %533, %529 ]
  %255 = phi double [ 0x7FF0000000000000, %246 ], [ %532, %529 ]
  %256 = phi i32 [ 7, %246 ], [ %531, %529 ]
  %257 = phi i32 [ %248, %246 ], [ %530, %529 ]
  %258 = getelementptr inbounds [4 x [3 x i32]], ptr @reduce.face, i64 0, i64 %254
  %259 = load i32, ptr %258, align 4
  %260 = sext i32 %259 to i64
  %261 = getelementptr inbounds [4 x [3 x double]], ptr %42, i64 0, i64 %260
  %262 = getelementptr inbounds [4 x [3 x i32]], ptr @reduce.face, i64 0, i64 %254, i64 1
  %263 = load i32, ptr %262, align 4
  %264 = sext i32 %263 to i64
  %265 = getelementptr inbounds [4 x [3 x double]], ptr %42, i64 0, i64 %264
  %266 = getelementptr inbounds [4 x [3 x i32]], ptr @reduce.face, i64 0, i64 %254, i64 2
  %267 = load i32, ptr %266, align 4
  %268 = sext i32 %267 to i64
  %269 = getelementptr inbounds [4 x [3 x double]], ptr %42, i64 0, i64 %268
  br i1 %247, label %270, label %335

270:                                              ; preds = %253
  %271 = add i32 %259, %263
  %272 = add i32 %271, %267
  %273 = sub i32 6, %272
  %274 = sext i32 %273 to i64
  %275 = getelementptr inbounds [4 x [3 x double]], ptr %42, i64 0, i64 %274
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %16) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %17) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %18) #15
  br label %301

276:                                              ; preds = %301
  %277 = load double, ptr %76, align 8
  %278 = load double, ptr %77, align 16
  %279 = fmul double %277, %278
  %280 = load double, ptr %78, align 16
  %281 = load double, ptr %79, align 8
  %282 = fmul double %280, %281
  %283 = fsub double %279, %282
  %284 = load double, ptr %17, align 16
  %285 = fmul double %280, %284
  %286 = load double, ptr %16, align 16
  %287 = fmul double %278, %286
  %288 = fsub double %285, %287
  %289 = fmul double %281, %286
  %290 = fmul double %277, %284
  %291 = fsub double %289, %290
  %292 = load double, ptr %18, align 16
  %293 = fmul double %283, %292
  %294 = load double, ptr %80, align 8
  %295 = fmul double %288, %294
  %296 = fadd double %293, %295
  %297 = load double, ptr %81, align 16
  %298 = fmul double %291, %297
  %299 = fadd double %296, %298
  %300 = fcmp oeq double %299, 0.000000e+00
  br i1 %300, label %333, label %319

301:                                              ; preds = %301, %270
  %302 = phi i64 [ 0, %270 ], [ %317, %301 ]
  %303 = getelementptr inbounds double, ptr %265, i64 %302
  %304 = load double, ptr %303, align 8
  %305 = getelementptr inbounds double, ptr %261, i64 %302
  %306 = load double, ptr %305, align 8
  %307 = fsub double %304, %306
  %308 = getelementptr inbounds [3 x double], ptr %16, i64 0, i64 %302
  store double %307, ptr %308, align 8
  %309 = getelementptr inbounds double, ptr %269, i64 %302
  %310 = load double, ptr %309, align 8
  %311 = fsub double %310, %306
  %312 = getelementptr inbounds [3 x double], ptr %17, i64 0, i64 %302
  store double %311, ptr %312, align 8
  %313 = getelementptr inbounds double, ptr %275, i64 %302
  %314 = load double, ptr %313, align 8
  %315 = fsub double %314, %306
  %316 = getelementptr inbounds [3 x double], ptr %18, i64 0, i64 %302
  store double %315, ptr %316, align 8
  %317 = add nuw nsw i64 %302, 1
  %318 = icmp eq i64 %317, 3
  br i1 %318, label %276, label %301

319:                                              ; preds = %276
  %320 = load double, ptr %261, align 8
  %321 = fmul double %283, %320
  %322 = getelementptr inbounds double, ptr %261, i64 1
  %323 = load double, ptr %322, align 8
  %324 = fmul double %288, %323
  %325 = fadd double %321, %324
  %326 = getelementptr inbounds double, ptr %261, i64 2
  %327 = load double, ptr %326, align 8
  %328 = fmul double %291, %327
  %329 = fadd double %325, %328
  %330 = fneg double %329
  %331 = fmul double %299, %330
  %332 = fcmp ult double %331, 0.000000e+00
  br i1 %332, label %333, label %334

333:                                              ; preds = %319, %276
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %18) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %17) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %16) #15
  br label %335

334:                                              ; preds = %319
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %18) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %17) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %16) #15
  br label %529

335:                                              ; preds = %333, %253
  %336 = phi i32 [ %257, %253 ], [ 0, %333 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %19) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %11) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %12) #15
  br label %394

337:                                              ; preds = %394
  %338 = load double, ptr %11, align 16
  %339 = load double, ptr %261, align 8
  %340 = fmul double %338, %339
  %341 = load double, ptr %82, align 8
  %342 = getelementptr inbounds double, ptr %261, i64 1
  %343 = load double, ptr %342, align 8
  %344 = fmul double %341, %343
  %345 = fadd double %340, %344
  %346 = load double, ptr %83, align 16
  %347 = getelementptr inbounds double, ptr %261, i64 2
  %348 = load double, ptr %347, align 8
  %349 = fmul double %346, %348
  %350 = fadd double %345, %349
  %351 = fneg double %350
  %352 = load double, ptr %12, align 16
  %353 = fmul double %339, %352
  %354 = load double, ptr %84, align 8
  %355 = fmul double %343, %354
  %356 = fadd double %353, %355
  %357 = load double, ptr %85, align 16
  %358 = fmul double %348, %357
  %359 = fadd double %356, %358
  %360 = fneg double %359
  %361 = load double, ptr %265, align 8
  %362 = fmul double %338, %361
  %363 = getelementptr inbounds double, ptr %265, i64 1
  %364 = load double, ptr %363, align 8
  %365 = fmul double %341, %364
  %366 = fadd double %362, %365
  %367 = getelementptr inbounds double, ptr %265, i64 2
  %368 = load double, ptr %367, align 8
  %369 = fmul double %346, %368
  %370 = fadd double %366, %369
  %371 = fmul double %352, %361
  %372 = fmul double %354, %364
  %373 = fadd double %371, %372
  %374 = fmul double %357, %368
  %375 = fadd double %373, %374
  %376 = load double, ptr %269, align 8
  %377 = fmul double %338, %376
  %378 = getelementptr inbounds double, ptr %269, i64 1
  %379 = load double, ptr %378, align 8
  %380 = fmul double %341, %379
  %381 = fadd double %377, %380
  %382 = getelementptr inbounds double, ptr %269, i64 2
  %383 = load double, ptr %382, align 8
  %384 = fmul double %346, %383
  %385 = fadd double %381, %384
  %386 = fmul double %352, %376
  %387 = fmul double %354, %379
  %388 = fadd double %386, %387
  %389 = fmul double %357, %383
  %390 = fadd double %388, %389
  %391 = fcmp oge double %350, 0.000000e+00
  %392 = fcmp oge double %359, 0.000000e+00
  %393 = select i1 %391, i1 %392, i1 false
  br i1 %393, label %511, label %408

394:                                              ; preds = %394, %335
  %395 = phi i64 [ 0, %335 ], [ %406, %394 ]
  %396 = getelementptr inbounds double, ptr %265, i64 %395
  %397 = load double, ptr %396, align 8
  %398 = getelementptr inbounds double, ptr %261, i64 %395
  %399 = load double, ptr %398, align 8
  %400 = fsub double %397, %399
  %401 = getelementptr inbounds [3 x double], ptr %11, i64 0, i64 %395
  store double %400, ptr %401, align 8
  %402 = getelementptr inbounds double, ptr %269, i64 %395
  %403 = load double, ptr %402, align 8
  %404 = fsub double %403, %399
  %405 = getelementptr inbounds [3 x double], ptr %12, i64 0, i64 %395
  store double %404, ptr %405, align 8
  %406 = add nuw nsw i64 %395, 1
  %407 = icmp eq i64 %406, 3
  br i1 %407, label %337, label %394

408:                                              ; preds = %337
  %409 = fcmp ugt double %370, 0.000000e+00
  %410 = fcmp ult double %375, %370
  %411 = select i1 %409, i1 true, i1 %410
  br i1 %411, label %412, label %511

412:                                              ; preds = %408
  %413 = fcmp ugt double %390, 0.000000e+00
  %414 = fcmp ult double %385, %390
  %415 = select i1 %413, i1 true, i1 %414
  br i1 %415, label %416, label %511

416:                                              ; preds = %412
  %417 = fmul double %350, %375
  %418 = fmul double %359, %370
  %419 = fsub double %417, %418
  %420 = fcmp ole double %419, 0.000000e+00
  %421 = fcmp ole double %350, 0.000000e+00
  %422 = select i1 %420, i1 %421, i1 false
  %423 = fcmp oge double %370, 0.000000e+00
  %424 = select i1 %422, i1 %423, i1 false
  br i1 %424, label %425, label %440

425:                                              ; preds = %416
  %426 = fsub double %370, %350
  %427 = fdiv double %351, %426
  br label %428

428:                                              ; preds = %428, %425
  %429 = phi i64 [ 0, %425 ], [ %438, %428 ]
  %430 = getelementptr inbounds double, ptr %261, i64 %429
  %431 = load double, ptr %430, align 8
  %432 = getelementptr inbounds double, ptr %265, i64 %429
  %433 = load double, ptr %432, align 8
  %434 = fsub double %433, %431
  %435 = fmul double %427, %434
  %436 = fadd double %431, %435
  %437 = getelementptr inbounds double, ptr %19, i64 %429
  store double %436, ptr %437, align 8
  %438 = add nuw nsw i64 %429, 1
  %439 = icmp eq i64 %438, 3
  br i1 %439, label %514, label %428

440:                                              ; preds = %416
  %441 = fmul double %359, %385
  %442 = fmul double %350, %390
  %443 = fsub double %441, %442
  %444 = fcmp ole double %443, 0.000000e+00
  %445 = fcmp ole double %359, 0.000000e+00
  %446 = select i1 %444, i1 %445, i1 false
  %447 = fcmp oge double %390, 0.000000e+00
  %448 = select i1 %446, i1 %447, i1 false
  br i1 %448, label %449, label %464

449:                                              ; preds = %440
  %450 = fsub double %390, %359
  %451 = fdiv double %360, %450
  br label %452

452:                                              ; preds = %452, %449
  %453 = phi i64 [ 0, %449 ], [ %462, %452 ]
  %454 = getelementptr inbounds double, ptr %261, i64 %453
  %455 = load double, ptr %454, align 8
  %456 = getelementptr inbounds double, ptr %269, i64 %453
  %457 = load double, ptr %456, align 8
  %458 = fsub double %457, %455
  %459 = fmul double %451, %458
  %460 = fadd double %455, %459
  %461 = getelementptr inbounds double, ptr %19, i64 %453
  store double %460, ptr %461, align 8
  %462 = add nuw nsw i64 %453, 1
  %463 = icmp eq i64 %462, 3
  br i1 %463, label %514, label %452

464:                                              ; preds = %440
  %465 = fmul double %370, %390
  %466 = fmul double %375, %385
  %467 = fsub double %465, %466
  %468 = fcmp ugt double %467, 0.000000e+00
  br i1 %468, label %491, label %469

469:                                              ; preds = %464
  %470 = fsub double %370, %375
  %471 = fcmp ult double %470, 0.000000e+00
  %472 = fsub double %390, %385
  %473 = fcmp ult double %472, 0.000000e+00
  %474 = select i1 %471, i1 true, i1 %473
  br i1 %474, label %491, label %475

475:                                              ; preds = %469
  %476 = fsub double %470, %385
  %477 = fadd double %390, %476
  %478 = fdiv double %470, %477
  br label %479

479:                                              ; preds = %479, %475
  %480 = phi i64 [ 0, %475 ], [ %489, %479 ]
  %481 = getelementptr inbounds double, ptr %265, i64 %480
  %482 = load double, ptr %481, align 8
  %483 = getelementptr inbounds double, ptr %269, i64 %480
  %484 = load double, ptr %483, align 8
  %485 = fsub double %484, %482
  %486 = fmul double %478, %485
  %487 = fadd double %482, %486
  %488 = getelementptr inbounds double, ptr %19, i64 %480
  store double %487, ptr %488, align 8
  %489 = add nuw nsw i64 %480, 1
  %490 = icmp eq i64 %489, 3
  br i1 %490, label %514, label %479

491:                                              ; preds = %469, %464
  %492 = fadd double %467, %443
  %493 = fadd double %419, %492
  %494 = fdiv double %443, %493
  %495 = fdiv double %419, %493
  br label %496

496:                                              ; preds = %496, %491
  %497 = phi i64 [ 0, %491 ], [ %509, %496 ]
  %498 = getelementptr inbounds double, ptr %261, i64 %497
  %499 = load double, ptr %498, align 8
  %500 = getelementptr inbounds [3 x double], ptr %11, i64 0, i64 %497
  %501 = load double, ptr %500, align 8
  %502 = fmul double %494, %501
  %503 = fadd double %499, %502
  %504 = getelementptr inbounds [3 x double], ptr %12, i64 0, i64 %497
  %505 = load double, ptr %504, align 8
  %506 = fmul double %495, %505
  %507 = fadd double %503, %506
  %508 = getelementptr inbounds double, ptr %19, i64 %497
  store double %507, ptr %508, align 8
  %509 = add nuw nsw i64 %497, 1
  %510 = icmp eq i64 %509, 3
  br i1 %510, label %514, label %496

511:                                              ; preds = %412, %408, %337
  %512 = phi ptr [ %261, %337 ], [ %265, %408 ], [ %269, %412 ]
  %513 = phi i32 [ 1, %337 ], [ 2, %408 ], [ 4, %412 ]
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %19, ptr noundef nonnull align 8 dereferenceable(24) %512, i64 24, i1 false)
  br label %514

514:                                              ; preds = %479, %496, %452, %428, %511
  %515 = phi i32 [ %513, %511 ], [ 3, %428 ], [ 5, %452 ], [ 7, %496 ], [ 6, %479 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %12) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %11) #15
  %516 = load double, ptr %19, align 16
  %517 = fmul double %516, %516
  %518 = load double, ptr %86, align 8
  %519 = fmul double %518, %518
  %520 = fadd double %517, %519
  %521 = load double, ptr %87, align 16
  %522 = fmul double %521, %521
  %523 = fadd double %520, %522
  %524 = fcmp olt double %523, %255
  br i1 %524, label %525, label %526

525:                                              ; preds = %514
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %14, ptr noundef nonnull align 16 dereferenceable(24) %19, i64 24, i1 false)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 4 dereferenceable(12) %15, ptr noundef nonnull align 4 dereferenceable(12) %258, i64 12, i1 false)
  br label %526

526:                                              ; preds = %525, %514
  %527 = phi i32 [ %515, %525 ], [ %256, %514 ]
  %528 = phi double [ %523, %525 ], [ %255, %514 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %19) #15
  br label %529

529:                                              ; preds = %526, %334
  %530 = phi i32 [ %336, %526 ], [ %257, %334 ]
  %531 = phi i32 [ %527, %526 ], [ %256, %334 ]
  %532 = phi double [ %528, %526 ], [ %255, %334 ]
  %533 = add nuw nsw i64 %254, 1
  %534 = icmp ult i64 %254, 3
  %535 = select i1 %249, i1 %534, i1 false
  br i1 %535, label %253, label %250

536:                                              ; preds = %250
  %537 = fcmp oeq double %532, 0x7FF0000000000000
  br i1 %537, label %576, label %538

538:                                              ; preds = %536
  call void @llvm.lifetime.start.p0(i64 12, ptr nonnull %20) #15
  br label %559

539:                                              ; preds = %572
  %540 = icmp sgt i32 %573, 0
  br i1 %540, label %541, label %558

541:                                              ; preds = %539
  %542 = zext i32 %573 to i64
  br label %543

543:                                              ; preds = %555, %541
  %544 = phi i64 [ 0, %541 ], [ %556, %555 ]
  %545 = getelementptr inbounds i32, ptr %20, i64 %544
  %546 = load i32, ptr %545, align 4
  %547 = zext i32 %546 to i64
  %548 = icmp eq i64 %544, %547
  br i1 %548, label %555, label %549

549:                                              ; preds = %543
  %550 = getelementptr inbounds [4 x [3 x double]], ptr %42, i64 0, i64 %544
  %551 = sext i32 %546 to i64
  %552 = getelementptr inbounds [4 x [3 x double]], ptr %42, i64 0, i64 %551
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %550, ptr noundef nonnull align 8 dereferenceable(24) %552, i64 24, i1 false)
  %553 = getelementptr inbounds %struct.Simplex, ptr %42, i64 0, i32 1, i64 %544
  %554 = getelementptr inbounds %struct.Simplex, ptr %42, i64 0, i32 1, i64 %551
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %553, ptr noundef nonnull align 8 dereferenceable(24) %554, i64 24, i1 false)
  br label %555

555:                                              ; preds = %549, %543
  %556 = add nuw nsw i64 %544, 1
  %557 = icmp eq i64 %556, %542
  br i1 %557, label %558, label %543

558:                                              ; preds = %555, %539
  store i32 %573, ptr %45, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %66, ptr noundef nonnull align 16 dereferenceable(24) %14, i64 24, i1 false)
  call void @llvm.lifetime.end.p0(i64 12, ptr nonnull %20) #15
  br label %576

559:                                              ; preds = %572, %538
  %560 = phi i64 [ 0, %538 ], [ %574, %572 ]
  %561 = phi i32 [ 0, %538 ], [ %573, %572 ]
  %562 = trunc i64 %560 to i32
  %563 = shl nuw nsw i32 1, %562
  %564 = and i32 %563, %531
  %565 = icmp eq i32 %564, 0
  br i1 %565, label %572, label %566

566:                                              ; preds = %559
  %567 = getelementptr inbounds [3 x i32], ptr %15, i64 0, i64 %560
  %568 = load i32, ptr %567, align 4
  %569 = add nsw i32 %561, 1
  %570 = sext i32 %561 to i64
  %571 = getelementptr inbounds [3 x i32], ptr %20, i64 0, i64 %570
  store i32 %568, ptr %571, align 4
  br label %572

572:                                              ; preds = %566, %559
  %573 = phi i32 [ %569, %566 ], [ %561, %559 ]
  %574 = add nuw nsw i64 %560, 1
  %575 = icmp eq i64 %574, 3
  br i1 %575, label %539, label %559

576:                                              ; preds = %558, %536, %250
  %577 = phi i32 [ 0, %558 ], [ 1, %250 ], [ 0, %536 ]
  call void @llvm.lifetime.end.p0(i64 12, ptr nonnull %15) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %14)
  br label %578

578:                                              ; preds = %194, %245, %576
  %579 = phi i32 [ 0, %194 ], [ 0, %245 ], [ %577, %576 ]
  %580 = load double, ptr %66, align 8
  %581 = fmul double %580, %580
  %582 = load double, ptr %90, align 8
  %583 = fmul double %582, %582
  %584 = fadd double %581, %583
  %585 = load double, ptr %93, align 8
  %586 = fmul double %585, %585
  %587 = fadd double %584, %586
  %588 = tail call double @llvm.sqrt.f64(double %587)
  %589 = icmp eq i32 %579, 0
  br i1 %589, label %593, label %590

590:                                              ; preds = %578
  %591 = load double, ptr %6, align 8
  %592 = fcmp ugt double %591, 1.000000e-10
  br i1 %592, label %596, label %620

593:                                              ; preds = %578
  %594 = icmp ne i32 %110, 0
  %595 = select i1 %28, i1 %594, i1 false
  br i1 %595, label %599, label %604

596:                                              ; preds = %590
  %597 = icmp ne i32 %110, 0
  %598 = select i1 %28, i1 %597, i1 false
  br i1 %598, label %603, label %620

599:                                              ; preds = %593
  %600 = load double, ptr %7, align 8
  %601 = fcmp ult double %588, %600
  br i1 %601, label %604, label %602

602:                                              ; preds = %599
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(224) %42, ptr noundef nonnull align 8 dereferenceable(224) %22, i64 224, i1 false)
  br label %604

603:                                              ; preds = %596
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(224) %42, ptr noundef nonnull align 8 dereferenceable(224) %22, i64 224, i1 false)
  br label %620

604:                                              ; preds = %593, %599, %602
  %605 = phi i1 [ true, %602 ], [ %594, %593 ], [ true, %599 ]
  %606 = load double, ptr %7, align 8
  %607 = fcmp oge double %588, %606
  %608 = select i1 %607, i1 %605, i1 false
  br i1 %608, label %620, label %609

609:                                              ; preds = %604
  store double %588, ptr %7, align 8
  %610 = fcmp ugt double %588, 1.000000e-10
  br i1 %610, label %611, label %620

611:                                              ; preds = %609
  %612 = fcmp ugt double %588, %4
  br i1 %612, label %613, label %620

613:                                              ; preds = %611
  %614 = load double, ptr %6, align 8
  %615 = fsub double %588, %614
  %616 = fcmp ugt double %615, %5
  br i1 %616, label %617, label %620

617:                                              ; preds = %613
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %23, ptr noundef nonnull align 8 dereferenceable(24) %66, i64 24, i1 false)
  %618 = load i32, ptr %45, align 8
  %619 = icmp eq i32 %618, 4
  br i1 %619, label %620, label %622

620:                                              ; preds = %168, %165, %604, %609, %613, %611, %617, %179, %590, %596, %603
  %621 = phi i32 [ 1, %603 ], [ 0, %590 ], [ 1, %596 ], [ 1, %179 ], [ 1, %617 ], [ 1, %168 ], [ 1, %165 ], [ 1, %604 ], [ 0, %609 ], [ 1, %613 ], [ 1, %611 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %27) #15
  br label %625

622:                                              ; preds = %617
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %27) #15
  %623 = add nuw nsw i32 %110, 1
  %624 = icmp eq i32 %623, 300
  br i1 %624, label %625, label %108

625:                                              ; preds = %622, %620
  %626 = phi i32 [ %621, %620 ], [ 1, %622 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %26) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %25) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %24) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %23) #15
  call void @llvm.lifetime.end.p0(i64 224, ptr nonnull %22)
  call void @llvm.lifetime.end.p0(i64 224, ptr nonnull %21) #15
  ret i32 %626
}

define internal fastcc i32 @leaves(ptr noundef %0, i64 noundef %1, ptr noundef %2, ptr noundef %3) unnamed_addr #9 {
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
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %5) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5) #15
  br label %161

161:                                              ; preds = %16, %159
  %162 = phi i32 [ %160, %159 ], [ 0, %16 ]
  %163 = add nsw i32 %162, %12
  ret i32 %163
}

define internal fastcc i32 @make_face(ptr nocapture noundef readonly %0, i32 noundef %1, i32 noundef %2, i32 noundef %3, ptr nocapture noundef %4) unnamed_addr #7 {
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  %8 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #15
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
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #15
  ret i32 %95
}

declare i32 @bcmp(ptr nocapture, ptr nocapture, i64) local_unnamed_addr #12

declare i64 @llvm.smin.i64(i64, i64) #13

declare i64 @llvm.smax.i64(i64, i64) #13

attributes #0 = { nofree nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #3 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #4 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #5 = { nofree norecurse nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #6 = { nofree nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #7 = { nofree nosync nounwind memory(argmem: readwrite) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #8 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #9 = { nofree nosync nounwind memory(read, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #10 = { mustprogress nofree nosync nounwind willreturn memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #11 = { nofree nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #12 = { nofree nounwind willreturn memory(argmem: read) }
attributes #13 = { nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #14 = { memory(none) }
attributes #15 = { nounwind }


