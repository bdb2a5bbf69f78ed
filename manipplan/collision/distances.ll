; distances.c 1d3a73ddf1ae3945b9fd5f7081e14c64e8d3cb835a55bdcd679d729054ff0752: written by make kernel

%struct.Core = type { i64, i64, ptr, ptr, ptr, ptr, ptr, [12 x double] }
%struct.Search = type { ptr, i64, ptr, ptr, i64, double, ptr, ptr, i32, i64, %struct.Plane }
%struct.Plane = type { [3 x double], double }
%struct.World = type { i64, ptr, ptr, ptr, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, i64, ptr, i64, ptr, ptr, i64, ptr, ptr, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr }
%struct.Simplex = type { [4 x [3 x double]], i32, [3 x double] }

@place.still = internal constant [12 x double] [double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00], align 16
@__const.look_at.v = private unnamed_addr constant [3 x double] [double 1.000000e+00, double 0.000000e+00, double 0.000000e+00], align 16
@box_core.straight = internal unnamed_addr constant [9 x double] [double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00, double 0.000000e+00, double 0.000000e+00, double 0.000000e+00, double 1.000000e+00], align 16
@reduce.face = internal unnamed_addr constant [4 x [3 x i32]] [[3 x i32] [i32 0, i32 1, i32 2], [3 x i32] [i32 0, i32 1, i32 3], [3 x i32] [i32 0, i32 2, i32 3], [3 x i32] [i32 1, i32 2, i32 3]], align 16
@__const.reduce.chosen = private unnamed_addr constant [3 x i32] [i32 0, i32 1, i32 2], align 4
@within.ray = internal constant [3 x [3 x double]] [[3 x double] [double 6.123720e-01, double 3.535530e-01, double 7.071070e-01], [3 x double] [double -4.177900e-01, double 0x3FEA99C38B04AB60, double -3.670100e-01], [3 x double] [double 1.173100e-01, double -5.144900e-01, double -8.494300e-01]], align 16

define dso_local i32 @manipplan_check_one(ptr noundef %0, ptr nocapture noundef readonly %1, double noundef %2) local_unnamed_addr #0 {
  %4 = tail call fastcc i32 @examine(ptr noundef %0, ptr noundef %1, double noundef %2, ptr noundef null)
  ret i32 %4
}

define internal fastcc i32 @examine(ptr noundef %0, ptr nocapture noundef readonly %1, double noundef %2, ptr noundef %3) unnamed_addr #0 {
  %5 = alloca [3 x double], align 16
  %6 = alloca %struct.Core, align 8
  %7 = alloca %struct.Search, align 8
  %8 = alloca %struct.Core, align 8
  %9 = alloca %struct.Search, align 8
  %10 = load i64, ptr %0, align 8
  %11 = icmp sgt i64 %10, 0
  br i1 %11, label %25, label %45

12:                                               ; preds = %25
  %13 = icmp eq i32 %33, 0
  br i1 %13, label %14, label %45

14:                                               ; preds = %12
  %15 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 25
  %16 = icmp eq ptr %3, null
  br i1 %16, label %242, label %17

17:                                               ; preds = %14
  %18 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 33
  %19 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 34
  %20 = load i64, ptr %15, align 8
  %21 = icmp sgt i64 %20, 0
  br i1 %21, label %22, label %242

22:                                               ; preds = %17
  %23 = load ptr, ptr %18, align 8
  %24 = load ptr, ptr %19, align 8
  br label %36

25:                                               ; preds = %4, %25
  %26 = phi i32 [ %33, %25 ], [ 1, %4 ]
  %27 = phi i64 [ %34, %25 ], [ 0, %4 ]
  %28 = getelementptr inbounds double, ptr %1, i64 %27
  %29 = load double, ptr %28, align 8
  %30 = tail call double @llvm.fabs.f64(double %29) #14
  %31 = fcmp one double %30, 0x7FF0000000000000
  %32 = zext i1 %31 to i32
  %33 = and i32 %26, %32
  %34 = add nuw nsw i64 %27, 1
  %35 = icmp eq i64 %34, %10
  br i1 %35, label %12, label %25

36:                                               ; preds = %22, %36
  %37 = phi i64 [ %42, %36 ], [ 0, %22 ]
  %38 = getelementptr inbounds double, ptr %23, i64 %37
  store double 0x7FF8000000000000, ptr %38, align 8
  %39 = load i64, ptr %3, align 8
  %40 = add nsw i64 %39, 1
  store i64 %40, ptr %3, align 8
  %41 = getelementptr inbounds i64, ptr %24, i64 %39
  store i64 %37, ptr %41, align 8
  %42 = add nuw nsw i64 %37, 1
  %43 = load i64, ptr %15, align 8
  %44 = icmp slt i64 %42, %43
  br i1 %44, label %36, label %242

45:                                               ; preds = %4, %12
  %46 = icmp eq ptr %3, null
  br i1 %46, label %50, label %47

47:                                               ; preds = %45
  %48 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 33
  %49 = load ptr, ptr %48, align 8
  br label %50

50:                                               ; preds = %45, %47
  %51 = phi ptr [ %49, %47 ], [ null, %45 ]
  tail call fastcc void @place(ptr noundef nonnull %0, ptr noundef %1)
  %52 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 22
  %53 = load i64, ptr %52, align 8
  %54 = icmp sgt i64 %53, 0
  br i1 %54, label %55, label %161

55:                                               ; preds = %50
  %56 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 26
  %57 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 23
  %58 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 24
  %59 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %60 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 1
  %61 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 20
  %62 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 2
  %63 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 3
  %64 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 21
  %65 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 4
  %66 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 4
  %67 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 5
  %68 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 6
  %69 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 7
  %70 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 8
  %71 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 9
  %72 = getelementptr inbounds %struct.Search, ptr %7, i64 0, i32 10
  %73 = icmp ne ptr %51, null
  br label %74

74:                                               ; preds = %55, %156
  %75 = phi i64 [ %53, %55 ], [ %157, %156 ]
  %76 = phi i32 [ 0, %55 ], [ %158, %156 ]
  %77 = phi i64 [ 0, %55 ], [ %159, %156 ]
  %78 = load i64, ptr %56, align 8
  %79 = icmp sgt i64 %78, -1
  br i1 %79, label %80, label %161

80:                                               ; preds = %74
  %81 = load ptr, ptr %57, align 8
  %82 = mul nsw i64 %77, 3
  %83 = getelementptr inbounds i64, ptr %81, i64 %82
  %84 = load ptr, ptr %58, align 8
  %85 = shl nsw i64 %77, 2
  %86 = getelementptr inbounds double, ptr %84, i64 %85
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %5) #15
  %87 = getelementptr inbounds double, ptr %86, i64 3
  %88 = load double, ptr %87, align 8
  %89 = load ptr, ptr %59, align 8
  %90 = load i64, ptr %83, align 8
  %91 = mul nsw i64 %90, 12
  %92 = getelementptr inbounds double, ptr %89, i64 %91
  %93 = getelementptr inbounds double, ptr %86, i64 1
  %94 = getelementptr inbounds double, ptr %86, i64 2
  br label %95

95:                                               ; preds = %95, %80
  %96 = phi i64 [ 0, %80 ], [ %119, %95 ]
  %97 = mul nuw nsw i64 %96, 3
  %98 = getelementptr inbounds double, ptr %92, i64 %97
  %99 = load double, ptr %98, align 8
  %100 = load double, ptr %86, align 8
  %101 = fmul double %99, %100
  %102 = add nuw nsw i64 %97, 1
  %103 = getelementptr inbounds double, ptr %92, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = load double, ptr %93, align 8
  %106 = fmul double %104, %105
  %107 = fadd double %101, %106
  %108 = add nuw nsw i64 %97, 2
  %109 = getelementptr inbounds double, ptr %92, i64 %108
  %110 = load double, ptr %109, align 8
  %111 = load double, ptr %94, align 8
  %112 = fmul double %110, %111
  %113 = fadd double %107, %112
  %114 = add nuw nsw i64 %96, 9
  %115 = getelementptr inbounds double, ptr %92, i64 %114
  %116 = load double, ptr %115, align 8
  %117 = fadd double %116, %113
  %118 = getelementptr inbounds double, ptr %5, i64 %96
  store double %117, ptr %118, align 8
  %119 = add nuw nsw i64 %96, 1
  %120 = icmp eq i64 %119, 3
  br i1 %120, label %121, label %95

121:                                              ; preds = %95
  %122 = fadd double %88, %2
  %123 = fmul double %122, %122
  %124 = call fastcc i32 @is_near(ptr noundef nonnull %0, ptr noundef nonnull %5, double noundef %123, i64 noundef %78)
  %125 = icmp eq i32 %124, 0
  br i1 %125, label %156, label %126

126:                                              ; preds = %121
  %127 = getelementptr inbounds i64, ptr %83, i64 1
  %128 = getelementptr inbounds i64, ptr %83, i64 2
  %129 = load i64, ptr %128, align 8
  %130 = icmp sgt i64 %129, 0
  br i1 %130, label %131, label %156

131:                                              ; preds = %126
  %132 = load i64, ptr %127, align 8
  br label %139

133:                                              ; preds = %139
  %134 = add nsw i64 %141, 1
  %135 = load i64, ptr %127, align 8
  %136 = load i64, ptr %128, align 8
  %137 = add nsw i64 %136, %135
  %138 = icmp slt i64 %134, %137
  br i1 %138, label %139, label %154

139:                                              ; preds = %131, %133
  %140 = phi i32 [ %150, %133 ], [ %76, %131 ]
  %141 = phi i64 [ %134, %133 ], [ %132, %131 ]
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %6) #15
  call void @llvm.lifetime.start.p0(i64 112, ptr nonnull %7) #15
  store ptr %0, ptr %7, align 8
  %142 = load ptr, ptr %61, align 8
  %143 = getelementptr inbounds i64, ptr %142, i64 %141
  %144 = load i64, ptr %143, align 8
  store i64 %144, ptr %60, align 8
  store ptr %6, ptr %62, align 8
  %145 = load ptr, ptr %64, align 8
  %146 = load i64, ptr %65, align 8
  %147 = mul nsw i64 %146, %141
  %148 = getelementptr inbounds i64, ptr %145, i64 %147
  store ptr %148, ptr %63, align 8
  store i64 -1, ptr %66, align 8
  store double %2, ptr %67, align 8
  store ptr %51, ptr %68, align 8
  store ptr %3, ptr %69, align 8
  store i32 %140, ptr %70, align 8
  store i64 -1, ptr %71, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %72, i8 0, i64 32, i1 false)
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %144, ptr noundef nonnull %6)
  %149 = load i64, ptr %56, align 8
  call fastcc void @descend(ptr noundef nonnull %7, i64 noundef %149)
  %150 = load i32, ptr %70, align 8
  %151 = icmp ne i32 %150, 1
  %152 = select i1 %73, i1 true, i1 %151
  call void @llvm.lifetime.end.p0(i64 112, ptr nonnull %7) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %6) #15
  br i1 %152, label %133, label %153

153:                                              ; preds = %139
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5) #15
  br label %242

154:                                              ; preds = %133
  %155 = load i64, ptr %52, align 8
  br label %156

156:                                              ; preds = %154, %126, %121
  %157 = phi i64 [ %75, %121 ], [ %75, %126 ], [ %155, %154 ]
  %158 = phi i32 [ %76, %121 ], [ %76, %126 ], [ %150, %154 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5) #15
  %159 = add nuw nsw i64 %77, 1
  %160 = icmp slt i64 %159, %157
  br i1 %160, label %74, label %161

161:                                              ; preds = %156, %74, %50
  %162 = phi i32 [ 0, %50 ], [ %76, %74 ], [ %158, %156 ]
  %163 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 17
  %164 = load i64, ptr %163, align 8
  %165 = icmp sgt i64 %164, 0
  br i1 %165, label %166, label %242

166:                                              ; preds = %161
  %167 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 18
  %168 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 32
  %169 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 12
  %170 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 1
  %171 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 2
  %172 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 3
  %173 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 4
  %174 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 5
  %175 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 6
  %176 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 7
  %177 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 8
  %178 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 9
  %179 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 10
  %180 = icmp eq ptr %51, null
  br label %181

181:                                              ; preds = %166, %237
  %182 = phi i64 [ %164, %166 ], [ %238, %237 ]
  %183 = phi i32 [ %162, %166 ], [ %239, %237 ]
  %184 = phi i64 [ 0, %166 ], [ %240, %237 ]
  %185 = load ptr, ptr %167, align 8
  %186 = mul nuw nsw i64 %184, 3
  %187 = getelementptr inbounds i64, ptr %185, i64 %186
  %188 = load i64, ptr %187, align 8
  %189 = add nuw nsw i64 %186, 1
  %190 = getelementptr inbounds i64, ptr %185, i64 %189
  %191 = load i64, ptr %190, align 8
  %192 = load ptr, ptr %168, align 8
  %193 = mul nsw i64 %188, 3
  %194 = getelementptr inbounds double, ptr %192, i64 %193
  %195 = mul nsw i64 %191, 3
  %196 = getelementptr inbounds double, ptr %192, i64 %195
  %197 = load double, ptr %194, align 8
  %198 = load double, ptr %196, align 8
  %199 = fsub double %197, %198
  %200 = getelementptr inbounds double, ptr %194, i64 1
  %201 = load double, ptr %200, align 8
  %202 = getelementptr inbounds double, ptr %196, i64 1
  %203 = load double, ptr %202, align 8
  %204 = fsub double %201, %203
  %205 = getelementptr inbounds double, ptr %194, i64 2
  %206 = load double, ptr %205, align 8
  %207 = getelementptr inbounds double, ptr %196, i64 2
  %208 = load double, ptr %207, align 8
  %209 = fsub double %206, %208
  %210 = load ptr, ptr %169, align 8
  %211 = shl nsw i64 %188, 2
  %212 = or i64 %211, 3
  %213 = getelementptr inbounds double, ptr %210, i64 %212
  %214 = load double, ptr %213, align 8
  %215 = fadd double %214, %2
  %216 = shl nsw i64 %191, 2
  %217 = or i64 %216, 3
  %218 = getelementptr inbounds double, ptr %210, i64 %217
  %219 = load double, ptr %218, align 8
  %220 = fadd double %215, %219
  %221 = fmul double %199, %199
  %222 = fmul double %204, %204
  %223 = fadd double %221, %222
  %224 = fmul double %209, %209
  %225 = fadd double %223, %224
  %226 = fmul double %220, %220
  %227 = fcmp ogt double %225, %226
  br i1 %227, label %237, label %228

228:                                              ; preds = %181
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %8) #15
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %188, ptr noundef nonnull %8)
  call void @llvm.lifetime.start.p0(i64 112, ptr nonnull %9) #15
  store ptr %0, ptr %9, align 8
  store i64 %188, ptr %170, align 8
  store ptr %8, ptr %171, align 8
  store ptr null, ptr %172, align 8
  %229 = add nuw nsw i64 %186, 2
  %230 = getelementptr inbounds i64, ptr %185, i64 %229
  %231 = load i64, ptr %230, align 8
  store i64 %231, ptr %173, align 8
  store double %2, ptr %174, align 8
  store ptr %51, ptr %175, align 8
  store ptr %3, ptr %176, align 8
  store i32 %183, ptr %177, align 8
  store i64 -1, ptr %178, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %179, i8 0, i64 32, i1 false)
  call fastcc void @look_at(ptr noundef nonnull %9, i64 noundef %191, ptr noundef null)
  %232 = load i32, ptr %177, align 8
  %233 = icmp eq i32 %232, 1
  %234 = select i1 %180, i1 %233, i1 false
  call void @llvm.lifetime.end.p0(i64 112, ptr nonnull %9) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %8) #15
  br i1 %234, label %242, label %235

235:                                              ; preds = %228
  %236 = load i64, ptr %163, align 8
  br label %237

237:                                              ; preds = %235, %181
  %238 = phi i64 [ %182, %181 ], [ %236, %235 ]
  %239 = phi i32 [ %183, %181 ], [ %232, %235 ]
  %240 = add nuw nsw i64 %184, 1
  %241 = icmp slt i64 %240, %238
  br i1 %241, label %181, label %242

242:                                              ; preds = %228, %237, %36, %17, %161, %14, %153
  %243 = phi i32 [ 1, %153 ], [ 2, %14 ], [ %162, %161 ], [ 2, %17 ], [ 2, %36 ], [ 1, %228 ], [ %239, %237 ]
  ret i32 %243
}

define dso_local void @manipplan_check(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, double noundef %3, ptr nocapture noundef writeonly %4) local_unnamed_addr #0 {
  %6 = icmp sgt i64 %2, 0
  br i1 %6, label %8, label %7

7:                                                ; preds = %8, %5
  ret void

8:                                                ; preds = %5, %8
  %9 = phi i64 [ %16, %8 ], [ 0, %5 ]
  %10 = load i64, ptr %0, align 8
  %11 = mul nsw i64 %10, %9
  %12 = getelementptr inbounds double, ptr %1, i64 %11
  %13 = tail call fastcc i32 @examine(ptr noundef nonnull %0, ptr noundef %12, double noundef %3, ptr noundef null)
  %14 = trunc i32 %13 to i8
  %15 = getelementptr inbounds i8, ptr %4, i64 %9
  store i8 %14, ptr %15, align 1
  %16 = add nuw nsw i64 %9, 1
  %17 = icmp eq i64 %16, %2
  br i1 %17, label %7, label %8
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

define dso_local void @manipplan_distances(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef writeonly %4) local_unnamed_addr #0 {
  %6 = alloca i64, align 8
  %7 = icmp sgt i64 %2, 0
  br i1 %7, label %8, label %12

8:                                                ; preds = %5
  %9 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 25
  %10 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 33
  %11 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 34
  br label %13

12:                                               ; preds = %36, %5
  ret void

13:                                               ; preds = %8, %36
  %14 = phi i64 [ 0, %8 ], [ %37, %36 ]
  %15 = phi ptr [ %4, %8 ], [ %38, %36 ]
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %6) #15
  store i64 0, ptr %6, align 8
  %16 = load i64, ptr %0, align 8
  %17 = mul nsw i64 %16, %14
  %18 = getelementptr inbounds double, ptr %1, i64 %17
  %19 = getelementptr inbounds double, ptr %3, i64 %14
  %20 = load double, ptr %19, align 8
  %21 = call fastcc i32 @examine(ptr noundef nonnull %0, ptr noundef %18, double noundef %20, ptr noundef nonnull %6)
  %22 = load i64, ptr %9, align 8
  %23 = icmp sgt i64 %22, 0
  br i1 %23, label %30, label %24

24:                                               ; preds = %30, %13
  %25 = load i64, ptr %6, align 8
  %26 = icmp sgt i64 %25, 0
  br i1 %26, label %27, label %36

27:                                               ; preds = %24
  %28 = load ptr, ptr %10, align 8
  %29 = load ptr, ptr %11, align 8
  br label %40

30:                                               ; preds = %13, %30
  %31 = phi i64 [ %34, %30 ], [ 0, %13 ]
  %32 = load double, ptr %19, align 8
  %33 = getelementptr inbounds double, ptr %15, i64 %31
  store double %32, ptr %33, align 8
  %34 = add nuw nsw i64 %31, 1
  %35 = icmp eq i64 %34, %22
  br i1 %35, label %24, label %30

36:                                               ; preds = %40, %24
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %6) #15
  %37 = add nuw nsw i64 %14, 1
  %38 = getelementptr inbounds double, ptr %15, i64 %22
  %39 = icmp eq i64 %37, %2
  br i1 %39, label %12, label %13

40:                                               ; preds = %27, %40
  %41 = phi i64 [ 0, %27 ], [ %47, %40 ]
  %42 = getelementptr inbounds i64, ptr %29, i64 %41
  %43 = load i64, ptr %42, align 8
  %44 = getelementptr inbounds double, ptr %28, i64 %43
  %45 = load double, ptr %44, align 8
  %46 = getelementptr inbounds double, ptr %15, i64 %43
  store double %45, ptr %46, align 8
  store double 0x7FF0000000000000, ptr %44, align 8
  %47 = add nuw nsw i64 %41, 1
  %48 = icmp eq i64 %47, %25
  br i1 %48, label %36, label %40
}

define dso_local i64 @manipplan_near(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, ptr nocapture noundef readonly %3, i64 noundef %4, ptr nocapture noundef writeonly %5, ptr nocapture noundef writeonly %6) local_unnamed_addr #0 {
  %8 = alloca i64, align 8
  %9 = icmp sgt i64 %2, 0
  br i1 %9, label %10, label %14

10:                                               ; preds = %7
  %11 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 34
  %12 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 25
  %13 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 33
  br label %16

14:                                               ; preds = %30, %7
  %15 = phi i64 [ 0, %7 ], [ %31, %30 ]
  ret i64 %15

16:                                               ; preds = %10, %30
  %17 = phi i64 [ 0, %10 ], [ %31, %30 ]
  %18 = phi i64 [ 0, %10 ], [ %32, %30 ]
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %8) #15
  store i64 0, ptr %8, align 8
  %19 = load i64, ptr %0, align 8
  %20 = mul nsw i64 %19, %18
  %21 = getelementptr inbounds double, ptr %1, i64 %20
  %22 = getelementptr inbounds double, ptr %3, i64 %18
  %23 = load double, ptr %22, align 8
  %24 = call fastcc i32 @examine(ptr noundef nonnull %0, ptr noundef %21, double noundef %23, ptr noundef nonnull %8)
  %25 = load i64, ptr %8, align 8
  %26 = icmp sgt i64 %25, 0
  br i1 %26, label %27, label %30

27:                                               ; preds = %16
  %28 = load ptr, ptr %11, align 8
  %29 = load ptr, ptr %13, align 8
  br label %34

30:                                               ; preds = %48, %16
  %31 = phi i64 [ %17, %16 ], [ %51, %48 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #15
  %32 = add nuw nsw i64 %18, 1
  %33 = icmp eq i64 %32, %2
  br i1 %33, label %14, label %16

34:                                               ; preds = %27, %48
  %35 = phi i64 [ %17, %27 ], [ %51, %48 ]
  %36 = phi i64 [ 0, %27 ], [ %50, %48 ]
  %37 = getelementptr inbounds i64, ptr %28, i64 %36
  %38 = load i64, ptr %37, align 8
  %39 = icmp slt i64 %35, %4
  br i1 %39, label %40, label %48

40:                                               ; preds = %34
  %41 = load i64, ptr %12, align 8
  %42 = mul nsw i64 %41, %18
  %43 = add nsw i64 %42, %38
  %44 = getelementptr inbounds i64, ptr %5, i64 %35
  store i64 %43, ptr %44, align 8
  %45 = getelementptr inbounds double, ptr %29, i64 %38
  %46 = load double, ptr %45, align 8
  %47 = getelementptr inbounds double, ptr %6, i64 %35
  store double %46, ptr %47, align 8
  br label %48

48:                                               ; preds = %40, %34
  %49 = getelementptr inbounds double, ptr %29, i64 %38
  store double 0x7FF0000000000000, ptr %49, align 8
  %50 = add nuw nsw i64 %36, 1
  %51 = add nsw i64 %35, 1
  %52 = icmp eq i64 %50, %25
  br i1 %52, label %30, label %34
}

define dso_local void @manipplan_pairs(ptr noundef %0, ptr nocapture noundef readonly %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, ptr noundef %5, ptr nocapture noundef writeonly %6) local_unnamed_addr #0 {
  %8 = alloca %struct.Core, align 8
  %9 = alloca %struct.Search, align 8
  %10 = icmp sgt i64 %2, 0
  br i1 %10, label %11, label %21

11:                                               ; preds = %7
  %12 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 1
  %13 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 2
  %14 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 3
  %15 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 5
  %16 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 6
  %17 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 7
  %18 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 8
  %19 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 9
  %20 = getelementptr inbounds %struct.Search, ptr %9, i64 0, i32 10
  br label %22

21:                                               ; preds = %61, %7
  ret void

22:                                               ; preds = %11, %61
  %23 = phi i64 [ 0, %11 ], [ %62, %61 ]
  %24 = shl nuw nsw i64 %23, 1
  %25 = getelementptr inbounds i64, ptr %3, i64 %24
  %26 = load i64, ptr %25, align 8
  %27 = or i64 %24, 1
  %28 = getelementptr inbounds i64, ptr %3, i64 %27
  %29 = load i64, ptr %28, align 8
  %30 = load i64, ptr %0, align 8
  %31 = icmp sgt i64 %30, 0
  br i1 %31, label %32, label %51

32:                                               ; preds = %22
  %33 = mul nsw i64 %30, %23
  br label %39

34:                                               ; preds = %39
  %35 = icmp eq i32 %48, 0
  br i1 %35, label %36, label %51

36:                                               ; preds = %34
  %37 = getelementptr inbounds double, ptr %5, i64 %23
  store double 0x7FF8000000000000, ptr %37, align 8
  %38 = getelementptr inbounds i64, ptr %6, i64 %23
  store i64 -1, ptr %38, align 8
  br label %61

39:                                               ; preds = %32, %39
  %40 = phi i64 [ 0, %32 ], [ %49, %39 ]
  %41 = phi i32 [ 1, %32 ], [ %48, %39 ]
  %42 = add nsw i64 %33, %40
  %43 = getelementptr inbounds double, ptr %1, i64 %42
  %44 = load double, ptr %43, align 8
  %45 = call double @llvm.fabs.f64(double %44) #14
  %46 = fcmp one double %45, 0x7FF0000000000000
  %47 = zext i1 %46 to i32
  %48 = and i32 %41, %47
  %49 = add nuw nsw i64 %40, 1
  %50 = icmp eq i64 %49, %30
  br i1 %50, label %34, label %39

51:                                               ; preds = %22, %34
  %52 = getelementptr inbounds double, ptr %4, i64 %23
  %53 = load double, ptr %52, align 8
  %54 = getelementptr inbounds double, ptr %5, i64 %23
  store double %53, ptr %54, align 8
  %55 = getelementptr inbounds i64, ptr %6, i64 %23
  store i64 -1, ptr %55, align 8
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %8) #15
  %56 = load i64, ptr %0, align 8
  %57 = mul nsw i64 %56, %23
  %58 = getelementptr inbounds double, ptr %1, i64 %57
  call fastcc void @place(ptr noundef nonnull %0, ptr noundef %58)
  call fastcc void @core_of(ptr noundef nonnull %0, i64 noundef %26, ptr noundef nonnull %8)
  call void @llvm.lifetime.start.p0(i64 112, ptr nonnull %9) #15
  store ptr %0, ptr %9, align 8
  store i64 %26, ptr %12, align 8
  store ptr %8, ptr %13, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %14, i8 0, i64 16, i1 false)
  %59 = load double, ptr %52, align 8
  store double %59, ptr %15, align 8
  store ptr %54, ptr %16, align 8
  store ptr null, ptr %17, align 8
  store i32 0, ptr %18, align 8
  store i64 -1, ptr %19, align 8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %20, i8 0, i64 32, i1 false)
  call fastcc void @look_at(ptr noundef nonnull %9, i64 noundef %29, ptr noundef null)
  %60 = load i64, ptr %19, align 8
  store i64 %60, ptr %55, align 8
  call void @llvm.lifetime.end.p0(i64 112, ptr nonnull %9) #15
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %8) #15
  br label %61

61:                                               ; preds = %36, %51
  %62 = add nuw nsw i64 %23, 1
  %63 = icmp eq i64 %62, %2
  br i1 %63, label %21, label %22
}

declare double @llvm.fabs.f64(double) #2

define internal fastcc void @place(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1) unnamed_addr #3 {
  %3 = alloca [12 x double], align 16
  %4 = alloca [12 x double], align 16
  %5 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %6 = load ptr, ptr %5, align 8
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(96) %6, ptr noundef nonnull align 16 dereferenceable(96) @place.still, i64 96, i1 false)
  %7 = load i64, ptr %0, align 8
  %8 = icmp sgt i64 %7, 0
  br i1 %8, label %9, label %27

9:                                                ; preds = %2
  %10 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 2
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 3
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i8, ptr %3, i64 8
  %15 = getelementptr inbounds i8, ptr %3, i64 16
  %16 = getelementptr inbounds i8, ptr %3, i64 24
  %17 = getelementptr inbounds i8, ptr %3, i64 32
  %18 = getelementptr inbounds i8, ptr %3, i64 40
  %19 = getelementptr inbounds i8, ptr %3, i64 48
  %20 = getelementptr inbounds i8, ptr %3, i64 56
  %21 = getelementptr inbounds i8, ptr %3, i64 64
  %22 = getelementptr inbounds i8, ptr %3, i64 72
  %23 = getelementptr inbounds i8, ptr %3, i64 80
  %24 = getelementptr inbounds i8, ptr %3, i64 88
  %25 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 1
  %26 = load ptr, ptr %25, align 8
  br label %36

27:                                               ; preds = %193, %2
  %28 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 4
  %29 = load i64, ptr %28, align 8
  %30 = icmp sgt i64 %29, 0
  br i1 %30, label %31, label %195

31:                                               ; preds = %27
  %32 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 5
  %33 = load ptr, ptr %32, align 8
  %34 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 12
  %35 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 32
  br label %196

36:                                               ; preds = %9, %193
  %37 = phi i64 [ 0, %9 ], [ %144, %193 ]
  %38 = mul nsw i64 %37, 3
  %39 = getelementptr inbounds double, ptr %11, i64 %38
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %3) #15
  %40 = getelementptr inbounds i64, ptr %13, i64 %37
  %41 = load i64, ptr %40, align 8
  %42 = icmp eq i64 %41, 0
  br i1 %42, label %55, label %43

43:                                               ; preds = %36
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(96) %3, ptr noundef nonnull align 16 dereferenceable(96) @place.still, i64 96, i1 false)
  %44 = getelementptr inbounds double, ptr %1, i64 %37
  %45 = load double, ptr %44, align 8
  br label %46

46:                                               ; preds = %43, %46
  %47 = phi i64 [ 0, %43 ], [ %53, %46 ]
  %48 = getelementptr inbounds double, ptr %39, i64 %47
  %49 = load double, ptr %48, align 8
  %50 = fmul double %45, %49
  %51 = add nuw nsw i64 %47, 9
  %52 = getelementptr inbounds [12 x double], ptr %3, i64 0, i64 %51
  store double %50, ptr %52, align 8
  %53 = add nuw nsw i64 %47, 1
  %54 = icmp eq i64 %53, 3
  br i1 %54, label %90, label %46

55:                                               ; preds = %36
  %56 = getelementptr inbounds double, ptr %1, i64 %37
  %57 = load double, ptr %56, align 8
  %58 = tail call double @llvm.sin.f64(double %57)
  %59 = tail call double @llvm.cos.f64(double %57)
  %60 = fsub double 1.000000e+00, %59
  %61 = load double, ptr %39, align 8
  %62 = fmul double %61, %60
  %63 = fmul double %61, %62
  %64 = fadd double %59, %63
  %65 = getelementptr inbounds double, ptr %39, i64 1
  %66 = load double, ptr %65, align 8
  %67 = fmul double %66, %62
  %68 = getelementptr inbounds double, ptr %39, i64 2
  %69 = load double, ptr %68, align 8
  %70 = fmul double %58, %69
  %71 = fsub double %67, %70
  %72 = fmul double %62, %69
  %73 = fmul double %58, %66
  %74 = fadd double %73, %72
  %75 = fmul double %60, %66
  %76 = fmul double %61, %75
  %77 = fadd double %76, %70
  %78 = fmul double %66, %75
  %79 = fadd double %59, %78
  %80 = fmul double %75, %69
  %81 = fmul double %58, %61
  %82 = fsub double %80, %81
  %83 = fmul double %60, %69
  %84 = fmul double %61, %83
  %85 = fsub double %84, %73
  %86 = fmul double %66, %83
  %87 = fadd double %81, %86
  %88 = fmul double %69, %83
  %89 = fadd double %59, %88
  store double %64, ptr %3, align 16
  store double %71, ptr %14, align 8
  store double %74, ptr %15, align 16
  store double %77, ptr %16, align 8
  store double %79, ptr %17, align 16
  store double %82, ptr %18, align 8
  store double %85, ptr %19, align 16
  store double %87, ptr %20, align 8
  store double %89, ptr %21, align 16
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %22, i8 0, i64 24, i1 false)
  br label %90

90:                                               ; preds = %46, %55
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %4) #15
  %91 = mul nsw i64 %37, 12
  %92 = getelementptr inbounds double, ptr %6, i64 %91
  %93 = getelementptr inbounds double, ptr %26, i64 %91
  %94 = getelementptr inbounds double, ptr %93, i64 9
  %95 = getelementptr inbounds double, ptr %93, i64 10
  %96 = getelementptr inbounds double, ptr %93, i64 11
  %97 = load double, ptr %94, align 8
  %98 = load double, ptr %95, align 8
  %99 = load double, ptr %96, align 8
  br label %100

100:                                              ; preds = %111, %90
  %101 = phi i64 [ 0, %90 ], [ %122, %111 ]
  %102 = mul nuw nsw i64 %101, 3
  %103 = getelementptr inbounds double, ptr %92, i64 %102
  %104 = add nuw nsw i64 %102, 1
  %105 = getelementptr inbounds double, ptr %92, i64 %104
  %106 = add nuw nsw i64 %102, 2
  %107 = getelementptr inbounds double, ptr %92, i64 %106
  %108 = load double, ptr %103, align 8
  %109 = load double, ptr %105, align 8
  %110 = load double, ptr %107, align 8
  br label %124

111:                                              ; preds = %124
  %112 = fmul double %108, %97
  %113 = fmul double %109, %98
  %114 = fadd double %112, %113
  %115 = fmul double %110, %99
  %116 = fadd double %114, %115
  %117 = add nuw nsw i64 %101, 9
  %118 = getelementptr inbounds double, ptr %92, i64 %117
  %119 = load double, ptr %118, align 8
  %120 = fadd double %119, %116
  %121 = getelementptr inbounds double, ptr %4, i64 %117
  store double %120, ptr %121, align 8
  %122 = add nuw nsw i64 %101, 1
  %123 = icmp eq i64 %122, 3
  br i1 %123, label %143, label %100

124:                                              ; preds = %124, %100
  %125 = phi i64 [ 0, %100 ], [ %141, %124 ]
  %126 = getelementptr inbounds double, ptr %93, i64 %125
  %127 = load double, ptr %126, align 8
  %128 = fmul double %108, %127
  %129 = add nuw nsw i64 %125, 3
  %130 = getelementptr inbounds double, ptr %93, i64 %129
  %131 = load double, ptr %130, align 8
  %132 = fmul double %109, %131
  %133 = fadd double %128, %132
  %134 = add nuw nsw i64 %125, 6
  %135 = getelementptr inbounds double, ptr %93, i64 %134
  %136 = load double, ptr %135, align 8
  %137 = fmul double %110, %136
  %138 = fadd double %133, %137
  %139 = add nuw nsw i64 %125, %102
  %140 = getelementptr inbounds double, ptr %4, i64 %139
  store double %138, ptr %140, align 8
  %141 = add nuw nsw i64 %125, 1
  %142 = icmp eq i64 %141, 3
  br i1 %142, label %111, label %124

143:                                              ; preds = %111
  %144 = add nuw nsw i64 %37, 1
  %145 = mul nsw i64 %144, 12
  %146 = getelementptr inbounds double, ptr %6, i64 %145
  %147 = load double, ptr %22, align 8
  %148 = load double, ptr %23, align 16
  %149 = load double, ptr %24, align 8
  br label %150

150:                                              ; preds = %161, %143
  %151 = phi i64 [ 0, %143 ], [ %172, %161 ]
  %152 = mul nuw nsw i64 %151, 3
  %153 = getelementptr inbounds double, ptr %4, i64 %152
  %154 = add nuw nsw i64 %152, 1
  %155 = getelementptr inbounds double, ptr %4, i64 %154
  %156 = add nuw nsw i64 %152, 2
  %157 = getelementptr inbounds double, ptr %4, i64 %156
  %158 = load double, ptr %153, align 8
  %159 = load double, ptr %155, align 8
  %160 = load double, ptr %157, align 8
  br label %174

161:                                              ; preds = %174
  %162 = fmul double %158, %147
  %163 = fmul double %159, %148
  %164 = fadd double %162, %163
  %165 = fmul double %160, %149
  %166 = fadd double %164, %165
  %167 = add nuw nsw i64 %151, 9
  %168 = getelementptr inbounds double, ptr %4, i64 %167
  %169 = load double, ptr %168, align 8
  %170 = fadd double %169, %166
  %171 = getelementptr inbounds double, ptr %146, i64 %167
  store double %170, ptr %171, align 8
  %172 = add nuw nsw i64 %151, 1
  %173 = icmp eq i64 %172, 3
  br i1 %173, label %193, label %150

174:                                              ; preds = %174, %150
  %175 = phi i64 [ 0, %150 ], [ %191, %174 ]
  %176 = getelementptr inbounds double, ptr %3, i64 %175
  %177 = load double, ptr %176, align 8
  %178 = fmul double %158, %177
  %179 = add nuw nsw i64 %175, 3
  %180 = getelementptr inbounds double, ptr %3, i64 %179
  %181 = load double, ptr %180, align 8
  %182 = fmul double %159, %181
  %183 = fadd double %178, %182
  %184 = add nuw nsw i64 %175, 6
  %185 = getelementptr inbounds double, ptr %3, i64 %184
  %186 = load double, ptr %185, align 8
  %187 = fmul double %160, %186
  %188 = fadd double %183, %187
  %189 = add nuw nsw i64 %175, %152
  %190 = getelementptr inbounds double, ptr %146, i64 %189
  store double %188, ptr %190, align 8
  %191 = add nuw nsw i64 %175, 1
  %192 = icmp eq i64 %191, 3
  br i1 %192, label %161, label %174

193:                                              ; preds = %161
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %4) #15
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %3) #15
  %194 = icmp eq i64 %144, %7
  br i1 %194, label %27, label %36

195:                                              ; preds = %238, %27
  ret void

196:                                              ; preds = %31, %238
  %197 = phi i64 [ 0, %31 ], [ %239, %238 ]
  %198 = getelementptr inbounds i64, ptr %33, i64 %197
  %199 = load i64, ptr %198, align 8
  %200 = icmp sgt i64 %199, 0
  br i1 %200, label %201, label %238

201:                                              ; preds = %196
  %202 = mul nsw i64 %199, 12
  %203 = getelementptr inbounds double, ptr %6, i64 %202
  %204 = load ptr, ptr %34, align 8
  %205 = shl nsw i64 %197, 2
  %206 = getelementptr inbounds double, ptr %204, i64 %205
  %207 = load ptr, ptr %35, align 8
  %208 = mul nsw i64 %197, 3
  %209 = getelementptr inbounds double, ptr %207, i64 %208
  %210 = getelementptr inbounds double, ptr %206, i64 1
  %211 = getelementptr inbounds double, ptr %206, i64 2
  br label %212

212:                                              ; preds = %212, %201
  %213 = phi i64 [ 0, %201 ], [ %236, %212 ]
  %214 = mul nuw nsw i64 %213, 3
  %215 = getelementptr inbounds double, ptr %203, i64 %214
  %216 = load double, ptr %215, align 8
  %217 = load double, ptr %206, align 8
  %218 = fmul double %216, %217
  %219 = add nuw nsw i64 %214, 1
  %220 = getelementptr inbounds double, ptr %203, i64 %219
  %221 = load double, ptr %220, align 8
  %222 = load double, ptr %210, align 8
  %223 = fmul double %221, %222
  %224 = fadd double %218, %223
  %225 = add nuw nsw i64 %214, 2
  %226 = getelementptr inbounds double, ptr %203, i64 %225
  %227 = load double, ptr %226, align 8
  %228 = load double, ptr %211, align 8
  %229 = fmul double %227, %228
  %230 = fadd double %224, %229
  %231 = add nuw nsw i64 %213, 9
  %232 = getelementptr inbounds double, ptr %203, i64 %231
  %233 = load double, ptr %232, align 8
  %234 = fadd double %233, %230
  %235 = getelementptr inbounds double, ptr %209, i64 %213
  store double %234, ptr %235, align 8
  %236 = add nuw nsw i64 %213, 1
  %237 = icmp eq i64 %236, 3
  br i1 %237, label %238, label %212

238:                                              ; preds = %212, %196
  %239 = add nuw nsw i64 %197, 1
  %240 = icmp eq i64 %239, %29
  br i1 %240, label %195, label %196
}

define internal fastcc void @core_of(ptr nocapture noundef readonly %0, i64 noundef %1, ptr noundef %2) unnamed_addr #4 {
  %4 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 5
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds i64, ptr %7, i64 %1
  %9 = load i64, ptr %8, align 8
  %10 = mul nsw i64 %9, 12
  %11 = getelementptr inbounds double, ptr %5, i64 %10
  %12 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 6
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds i64, ptr %13, i64 %1
  %15 = load i64, ptr %14, align 8
  store i64 %15, ptr %2, align 8
  %16 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 11
  %17 = load ptr, ptr %16, align 8
  %18 = mul nsw i64 %1, 3
  %19 = getelementptr inbounds double, ptr %17, i64 %18
  %20 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 6
  store ptr %19, ptr %20, align 8
  %21 = icmp eq i64 %15, 0
  br i1 %21, label %22, label %44

22:                                               ; preds = %3
  %23 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 7
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr inbounds i64, ptr %24, i64 %1
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 8
  %28 = load ptr, ptr %27, align 8
  %29 = getelementptr inbounds i64, ptr %28, i64 %1
  %30 = load i64, ptr %29, align 8
  %31 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 1
  store i64 %30, ptr %31, align 8
  %32 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 14
  %33 = load ptr, ptr %32, align 8
  %34 = getelementptr inbounds double, ptr %33, i64 %26
  %35 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 2
  store ptr %34, ptr %35, align 8
  %36 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 15
  %37 = load ptr, ptr %36, align 8
  %38 = getelementptr inbounds double, ptr %37, i64 %26
  %39 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 3
  store ptr %38, ptr %39, align 8
  %40 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 16
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds double, ptr %41, i64 %26
  %43 = getelementptr inbounds %struct.Core, ptr %2, i64 0, i32 4
  store ptr %42, ptr %43, align 8
  br label %102

44:                                               ; preds = %3
  %45 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 10
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

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #5

define internal fastcc void @look_at(ptr noundef %0, i64 noundef %1, ptr noundef readonly %2) unnamed_addr #0 {
  %4 = alloca double, align 8
  %5 = alloca double, align 8
  %6 = alloca %struct.Plane, align 8
  %7 = alloca %struct.Plane, align 8
  %8 = alloca [3 x double], align 16
  %9 = alloca [3 x double], align 16
  %10 = alloca %struct.Core, align 8
  %11 = load ptr, ptr %0, align 8
  %12 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %13 = load ptr, ptr %12, align 8
  %14 = icmp eq ptr %13, null
  %15 = getelementptr inbounds i64, ptr %13, i64 %1
  %16 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %17 = select i1 %14, ptr %16, ptr %15
  %18 = load i64, ptr %17, align 8
  %19 = icmp slt i64 %18, 0
  br i1 %19, label %258, label %20

20:                                               ; preds = %3
  %21 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %22 = load ptr, ptr %21, align 8
  %23 = icmp eq ptr %22, null
  br i1 %23, label %28, label %24

24:                                               ; preds = %20
  %25 = getelementptr inbounds double, ptr %22, i64 %18
  %26 = load double, ptr %25, align 8
  %27 = fcmp uno double %26, 0.000000e+00
  br i1 %27, label %258, label %32

28:                                               ; preds = %20
  %29 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %30 = load i32, ptr %29, align 8
  %31 = icmp eq i32 %30, 1
  br i1 %31, label %258, label %32

32:                                               ; preds = %24, %28
  %33 = getelementptr inbounds %struct.World, ptr %11, i64 0, i32 6
  %34 = load ptr, ptr %33, align 8
  %35 = getelementptr inbounds i64, ptr %34, i64 %1
  %36 = load i64, ptr %35, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %4) #15
  store double 0xFFF0000000000000, ptr %4, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %5) #15
  store double 0x7FF0000000000000, ptr %5, align 8
  %37 = icmp eq i64 %36, 5
  br i1 %37, label %45, label %38

38:                                               ; preds = %32
  %39 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %40 = load i64, ptr %39, align 8
  %41 = getelementptr inbounds i64, ptr %34, i64 %40
  %42 = load i64, ptr %41, align 8
  %43 = add i64 %42, -3
  %44 = icmp ult i64 %43, 3
  br i1 %44, label %45, label %79

45:                                               ; preds = %38, %32
  br i1 %23, label %66, label %46

46:                                               ; preds = %45
  %47 = getelementptr inbounds double, ptr %22, i64 %18
  %48 = load double, ptr %47, align 8
  %49 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %50 = load double, ptr %49, align 8
  %51 = tail call double @llvm.minnum.f64(double %48, double %50)
  %52 = fcmp ugt double %51, 0xFFF0000000000000
  br i1 %52, label %53, label %257

53:                                               ; preds = %46
  %54 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %55 = load ptr, ptr %54, align 8
  %56 = icmp ne ptr %55, null
  %57 = fcmp oeq double %48, 0x7FF0000000000000
  %58 = select i1 %56, i1 %57, i1 false
  br i1 %58, label %59, label %65

59:                                               ; preds = %53
  %60 = getelementptr inbounds %struct.World, ptr %11, i64 0, i32 34
  %61 = load ptr, ptr %60, align 8
  %62 = load i64, ptr %55, align 8
  %63 = add nsw i64 %62, 1
  store i64 %63, ptr %55, align 8
  %64 = getelementptr inbounds i64, ptr %61, i64 %62
  store i64 %18, ptr %64, align 8
  br label %65

65:                                               ; preds = %59, %53
  store double 0x7FF8000000000000, ptr %47, align 8
  br label %257

66:                                               ; preds = %45
  %67 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %68 = load double, ptr %67, align 8
  %69 = fcmp ult double %68, 0x7FF0000000000000
  br i1 %69, label %72, label %70

70:                                               ; preds = %66
  %71 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  store i32 1, ptr %71, align 8
  br label %257

72:                                               ; preds = %66
  %73 = fcmp ult double %68, 0xFFF0000000000000
  br i1 %73, label %257, label %74

74:                                               ; preds = %72
  %75 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %76 = load i32, ptr %75, align 8
  %77 = icmp eq i32 %76, 0
  br i1 %77, label %78, label %257

78:                                               ; preds = %74
  store i32 2, ptr %75, align 8
  br label %257

79:                                               ; preds = %38
  switch i64 %36, label %140 [
    i64 3, label %80
    i64 4, label %97
  ]

80:                                               ; preds = %79
  %81 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %82 = load ptr, ptr %81, align 8
  %83 = tail call fastcc double @over_plane(ptr noundef nonnull %11, i64 noundef %40, ptr noundef %82, i64 noundef %1)
  br i1 %23, label %90, label %84

84:                                               ; preds = %80
  %85 = getelementptr inbounds double, ptr %22, i64 %18
  %86 = load double, ptr %85, align 8
  %87 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %88 = load double, ptr %87, align 8
  %89 = tail call double @llvm.minnum.f64(double %86, double %88)
  br label %93

90:                                               ; preds = %80
  %91 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %92 = load double, ptr %91, align 8
  br label %93

93:                                               ; preds = %84, %90
  %94 = phi double [ %89, %84 ], [ %92, %90 ]
  %95 = fcmp ugt double %83, %94
  br i1 %95, label %257, label %96

96:                                               ; preds = %93
  tail call fastcc void @tell(ptr noundef nonnull %0, i64 noundef %1, i32 noundef 1, double noundef %83, double noundef %83)
  br label %257

97:                                               ; preds = %79
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %6) #15
  %98 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %7) #15
  %99 = getelementptr inbounds %struct.World, ptr %11, i64 0, i32 27
  %100 = load ptr, ptr %99, align 8
  %101 = getelementptr inbounds %struct.World, ptr %11, i64 0, i32 29
  %102 = load ptr, ptr %101, align 8
  %103 = getelementptr inbounds i64, ptr %102, i64 %1
  %104 = load i64, ptr %103, align 8
  %105 = mul nsw i64 %104, 6
  %106 = getelementptr inbounds double, ptr %100, i64 %105
  call fastcc void @facing(ptr nonnull sret(%struct.Plane) align 8 %7, ptr noundef nonnull %11, i64 noundef %40, ptr noundef %106)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %98, ptr noundef nonnull align 8 dereferenceable(32) %7, i64 32, i1 false)
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %7) #15
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %6, ptr noundef nonnull align 8 dereferenceable(32) %98, i64 32, i1 false)
  %107 = load ptr, ptr %101, align 8
  %108 = getelementptr inbounds i64, ptr %107, i64 %1
  %109 = load i64, ptr %108, align 8
  call fastcc void @surface(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %109, ptr noundef nonnull %6)
  %110 = getelementptr inbounds %struct.World, ptr %11, i64 0, i32 11
  %111 = load ptr, ptr %110, align 8
  %112 = mul nsw i64 %1, 3
  %113 = getelementptr inbounds double, ptr %111, i64 %112
  %114 = load double, ptr %113, align 8
  %115 = fcmp ogt double %114, 0.000000e+00
  br i1 %115, label %116, label %139

116:                                              ; preds = %97
  %117 = load ptr, ptr %21, align 8
  %118 = icmp eq ptr %117, null
  br i1 %118, label %128, label %119

119:                                              ; preds = %116
  %120 = load ptr, ptr %12, align 8
  %121 = icmp eq ptr %120, null
  %122 = getelementptr inbounds i64, ptr %120, i64 %1
  %123 = select i1 %121, ptr %16, ptr %122
  %124 = load i64, ptr %123, align 8
  %125 = getelementptr inbounds double, ptr %117, i64 %124
  %126 = load double, ptr %125, align 8
  %127 = fcmp uno double %126, 0.000000e+00
  br i1 %127, label %139, label %132

128:                                              ; preds = %116
  %129 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %130 = load i32, ptr %129, align 8
  %131 = icmp eq i32 %130, 1
  br i1 %131, label %139, label %132

132:                                              ; preds = %119, %128
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #15
  %133 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %134 = load ptr, ptr %133, align 8
  call fastcc void @support(ptr noundef %134, ptr noundef nonnull @__const.look_at.v, ptr noundef nonnull %8)
  %135 = call fastcc i32 @within(ptr noundef nonnull %11, i64 noundef %1, ptr noundef nonnull %8)
  %136 = icmp eq i32 %135, 0
  br i1 %136, label %138, label %137

137:                                              ; preds = %132
  call fastcc void @tell(ptr noundef nonnull %0, i64 noundef %1, i32 noundef 0, double noundef 0xFFF0000000000000, double noundef 0x7FF0000000000000)
  br label %138

138:                                              ; preds = %137, %132
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #15
  br label %139

139:                                              ; preds = %119, %138, %128, %97
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %6) #15
  br label %257

140:                                              ; preds = %79
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #15
  br i1 %23, label %147, label %141

141:                                              ; preds = %140
  %142 = getelementptr inbounds double, ptr %22, i64 %18
  %143 = load double, ptr %142, align 8
  %144 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %145 = load double, ptr %144, align 8
  %146 = tail call double @llvm.minnum.f64(double %143, double %145)
  br label %150

147:                                              ; preds = %140
  %148 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %149 = load double, ptr %148, align 8
  br label %150

150:                                              ; preds = %141, %147
  %151 = phi double [ 0xFFF0000000000000, %141 ], [ %149, %147 ]
  %152 = phi double [ %146, %141 ], [ %149, %147 ]
  %153 = getelementptr inbounds %struct.World, ptr %11, i64 0, i32 32
  %154 = load ptr, ptr %153, align 8
  %155 = mul nsw i64 %40, 3
  %156 = getelementptr inbounds double, ptr %154, i64 %155
  %157 = mul nsw i64 %1, 3
  %158 = getelementptr inbounds double, ptr %154, i64 %157
  br label %184

159:                                              ; preds = %184
  %160 = getelementptr inbounds %struct.World, ptr %11, i64 0, i32 12
  %161 = load ptr, ptr %160, align 8
  %162 = shl nsw i64 %40, 2
  %163 = or i64 %162, 3
  %164 = getelementptr inbounds double, ptr %161, i64 %163
  %165 = load double, ptr %164, align 8
  %166 = fadd double %152, %165
  %167 = shl nsw i64 %1, 2
  %168 = or i64 %167, 3
  %169 = getelementptr inbounds double, ptr %161, i64 %168
  %170 = load double, ptr %169, align 8
  %171 = fadd double %166, %170
  %172 = load double, ptr %9, align 16
  %173 = fmul double %172, %172
  %174 = getelementptr inbounds double, ptr %9, i64 1
  %175 = load double, ptr %174, align 8
  %176 = fmul double %175, %175
  %177 = fadd double %173, %176
  %178 = getelementptr inbounds double, ptr %9, i64 2
  %179 = load double, ptr %178, align 16
  %180 = fmul double %179, %179
  %181 = fadd double %177, %180
  %182 = fmul double %171, %171
  %183 = fcmp ogt double %181, %182
  br i1 %183, label %256, label %194

184:                                              ; preds = %150, %184
  %185 = phi i64 [ 0, %150 ], [ %192, %184 ]
  %186 = getelementptr inbounds double, ptr %156, i64 %185
  %187 = load double, ptr %186, align 8
  %188 = getelementptr inbounds double, ptr %158, i64 %185
  %189 = load double, ptr %188, align 8
  %190 = fsub double %187, %189
  %191 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %185
  store double %190, ptr %191, align 8
  %192 = add nuw nsw i64 %185, 1
  %193 = icmp eq i64 %192, 3
  br i1 %193, label %159, label %184

194:                                              ; preds = %159
  %195 = tail call fastcc i32 @is_beside(ptr noundef nonnull %11, ptr noundef nonnull %158, double noundef %170, i64 noundef %40, double noundef %152)
  %196 = icmp eq i32 %195, 0
  br i1 %196, label %197, label %256

197:                                              ; preds = %194
  %198 = tail call fastcc i32 @is_beside(ptr noundef nonnull %11, ptr noundef nonnull %156, double noundef %165, i64 noundef %1, double noundef %152)
  %199 = icmp eq i32 %198, 0
  br i1 %199, label %200, label %256

200:                                              ; preds = %197
  %201 = icmp eq ptr %2, null
  br i1 %201, label %245, label %202

202:                                              ; preds = %200, %202
  %203 = phi i64 [ %220, %202 ], [ 0, %200 ]
  %204 = phi double [ %219, %202 ], [ 0.000000e+00, %200 ]
  %205 = getelementptr inbounds double, ptr %2, i64 %203
  %206 = load double, ptr %205, align 8
  %207 = getelementptr inbounds double, ptr %156, i64 %203
  %208 = load double, ptr %207, align 8
  %209 = fsub double %206, %208
  %210 = add nuw nsw i64 %203, 3
  %211 = getelementptr inbounds double, ptr %2, i64 %210
  %212 = load double, ptr %211, align 8
  %213 = fsub double %208, %212
  %214 = fcmp ogt double %209, %213
  %215 = select i1 %214, double %209, double %213
  %216 = fcmp ogt double %215, 0.000000e+00
  %217 = select i1 %216, double %215, double 0.000000e+00
  %218 = fmul double %217, %217
  %219 = fadd double %204, %218
  %220 = add nuw nsw i64 %203, 1
  %221 = icmp eq i64 %220, 3
  br i1 %221, label %222, label %202

222:                                              ; preds = %202
  %223 = fcmp ogt double %219, 0.000000e+00
  br i1 %223, label %224, label %245

224:                                              ; preds = %222, %240
  %225 = phi i64 [ %243, %240 ], [ 0, %222 ]
  %226 = getelementptr inbounds double, ptr %156, i64 %225
  %227 = load double, ptr %226, align 8
  %228 = getelementptr inbounds double, ptr %2, i64 %225
  %229 = load double, ptr %228, align 8
  %230 = fcmp olt double %227, %229
  br i1 %230, label %231, label %233

231:                                              ; preds = %224
  %232 = fsub double %227, %229
  br label %240

233:                                              ; preds = %224
  %234 = add nuw nsw i64 %225, 3
  %235 = getelementptr inbounds double, ptr %2, i64 %234
  %236 = load double, ptr %235, align 8
  %237 = fcmp ogt double %227, %236
  br i1 %237, label %238, label %240

238:                                              ; preds = %233
  %239 = fsub double %227, %236
  br label %240

240:                                              ; preds = %238, %233, %231
  %241 = phi double [ %232, %231 ], [ %239, %238 ], [ 0.000000e+00, %233 ]
  %242 = getelementptr inbounds [3 x double], ptr %9, i64 0, i64 %225
  store double %241, ptr %242, align 8
  %243 = add nuw nsw i64 %225, 1
  %244 = icmp eq i64 %243, 3
  br i1 %244, label %245, label %224

245:                                              ; preds = %240, %222, %200
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %10) #15
  call fastcc void @core_of(ptr noundef %11, i64 noundef %1, ptr noundef nonnull %10)
  %246 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %247 = load ptr, ptr %246, align 8
  %248 = call fastcc i32 @shape_bounds(ptr noundef %11, i64 noundef %40, ptr noundef %247, i64 noundef %1, ptr noundef nonnull %10, ptr noundef nonnull %9, double noundef %152, double noundef %151, ptr noundef nonnull %4, ptr noundef nonnull %5, ptr noundef null)
  %249 = icmp ne i32 %248, 0
  %250 = load double, ptr %4, align 8
  %251 = fcmp ugt double %250, %152
  %252 = select i1 %249, i1 %251, i1 false
  br i1 %252, label %255, label %253

253:                                              ; preds = %245
  %254 = load double, ptr %5, align 8
  call fastcc void @tell(ptr noundef nonnull %0, i64 noundef %1, i32 noundef %248, double noundef %250, double noundef %254)
  br label %255

255:                                              ; preds = %245, %253
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %10) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #15
  br label %257

256:                                              ; preds = %159, %194, %197
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #15
  br label %257

257:                                              ; preds = %78, %74, %72, %70, %65, %46, %139, %93, %96, %255, %256
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %5) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %4) #15
  br label %258

258:                                              ; preds = %24, %3, %28, %257
  ret void
}

define dso_local i64 @manipplan_tree(ptr noundef %0, ptr noundef %1, i64 noundef %2, ptr noundef %3, i64 noundef %4, ptr noundef %5, ptr noundef %6) local_unnamed_addr #6 {
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

declare void @llvm.memcpy.p0.p0.i64(ptr noalias nocapture writeonly, ptr noalias nocapture readonly, i64, i1 immarg) #7

define internal fastcc i32 @is_near(ptr noundef readonly %0, ptr noundef readonly %1, double noundef %2, i64 noundef %3) unnamed_addr #8 {
  %5 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 27
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
  %32 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 28
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
  %10 = getelementptr inbounds %struct.World, ptr %9, i64 0, i32 27
  %11 = load ptr, ptr %10, align 8
  %12 = mul nsw i64 %8, 6
  %13 = getelementptr inbounds double, ptr %11, i64 %12
  %14 = load double, ptr %3, align 8
  %15 = getelementptr inbounds %struct.World, ptr %9, i64 0, i32 12
  %16 = load ptr, ptr %15, align 8
  %17 = load i64, ptr %4, align 8
  %18 = shl nsw i64 %17, 2
  %19 = or i64 %18, 3
  %20 = getelementptr inbounds double, ptr %16, i64 %19
  %21 = load double, ptr %20, align 8
  %22 = getelementptr inbounds %struct.World, ptr %9, i64 0, i32 32
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
  %57 = getelementptr inbounds %struct.World, ptr %9, i64 0, i32 28
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

declare double @llvm.sin.f64(double) #2

declare double @llvm.cos.f64(double) #2

define internal fastcc void @tell(ptr nocapture noundef %0, i64 noundef %1, i32 noundef %2, double noundef %3, double noundef %4) unnamed_addr #9 {
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
  %38 = getelementptr inbounds %struct.World, ptr %37, i64 0, i32 34
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

define internal fastcc double @over_plane(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef readonly %2, i64 noundef %3) unnamed_addr #10 {
  %5 = alloca [12 x double], align 16
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %5) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #15
  %8 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 5
  %11 = load ptr, ptr %10, align 8
  %12 = getelementptr inbounds i64, ptr %11, i64 %3
  %13 = load i64, ptr %12, align 8
  %14 = mul nsw i64 %13, 12
  %15 = getelementptr inbounds double, ptr %9, i64 %14
  %16 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 10
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
  %81 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 9
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

define internal fastcc void @facing(ptr noalias nocapture sret(%struct.Plane) align 8 %0, ptr nocapture noundef readonly %1, i64 noundef %2, ptr nocapture noundef readonly %3) unnamed_addr #10 {
  %5 = getelementptr inbounds %struct.World, ptr %1, i64 0, i32 12
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds %struct.World, ptr %1, i64 0, i32 32
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
  %52 = getelementptr inbounds %struct.World, ptr %1, i64 0, i32 9
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
  %8 = alloca [3 x double], align 16
  %9 = alloca [3 x double], align 16
  %10 = alloca [3 x double], align 16
  %11 = alloca %struct.Core, align 8
  %12 = alloca %struct.Plane, align 8
  %13 = alloca %struct.Plane, align 8
  %14 = alloca [3 x double], align 16
  %15 = alloca %struct.Core, align 8
  %16 = alloca [3 x double], align 16
  %17 = load ptr, ptr %0, align 8
  %18 = getelementptr inbounds %struct.World, ptr %17, i64 0, i32 27
  %19 = load ptr, ptr %18, align 8
  %20 = mul nsw i64 %2, 6
  %21 = getelementptr inbounds double, ptr %19, i64 %20
  %22 = getelementptr inbounds %struct.World, ptr %17, i64 0, i32 32
  %23 = load ptr, ptr %22, align 8
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %25 = load i64, ptr %24, align 8
  %26 = mul nsw i64 %25, 3
  %27 = getelementptr inbounds double, ptr %23, i64 %26
  %28 = getelementptr inbounds %struct.World, ptr %17, i64 0, i32 9
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds double, ptr %29, i64 %1
  %31 = load double, ptr %30, align 8
  %32 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %33 = load ptr, ptr %32, align 8
  %34 = icmp eq ptr %33, null
  br i1 %34, label %48, label %35

35:                                               ; preds = %4
  %36 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %37 = load ptr, ptr %36, align 8
  %38 = icmp eq ptr %37, null
  %39 = getelementptr inbounds i64, ptr %37, i64 %1
  %40 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %41 = select i1 %38, ptr %40, ptr %39
  %42 = load i64, ptr %41, align 8
  %43 = getelementptr inbounds double, ptr %33, i64 %42
  %44 = load double, ptr %43, align 8
  %45 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %46 = load double, ptr %45, align 8
  %47 = tail call double @llvm.minnum.f64(double %44, double %46)
  br label %51

48:                                               ; preds = %4
  %49 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %50 = load double, ptr %49, align 8
  br label %51

51:                                               ; preds = %35, %48
  %52 = phi double [ 0xFFF0000000000000, %35 ], [ %50, %48 ]
  %53 = phi double [ %47, %35 ], [ %50, %48 ]
  %54 = getelementptr inbounds double, ptr %29, i64 %25
  %55 = load double, ptr %54, align 8
  br label %56

56:                                               ; preds = %56, %51
  %57 = phi i64 [ 0, %51 ], [ %74, %56 ]
  %58 = phi double [ 0.000000e+00, %51 ], [ %73, %56 ]
  %59 = getelementptr inbounds double, ptr %21, i64 %57
  %60 = load double, ptr %59, align 8
  %61 = getelementptr inbounds double, ptr %27, i64 %57
  %62 = load double, ptr %61, align 8
  %63 = fsub double %60, %62
  %64 = add nuw nsw i64 %57, 3
  %65 = getelementptr inbounds double, ptr %21, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = fsub double %62, %66
  %68 = fcmp ogt double %63, %67
  %69 = select i1 %68, double %63, double %67
  %70 = fcmp ogt double %69, 0.000000e+00
  %71 = select i1 %70, double %69, double 0.000000e+00
  %72 = fmul double %71, %71
  %73 = fadd double %58, %72
  %74 = add nuw nsw i64 %57, 1
  %75 = icmp eq i64 %74, 3
  br i1 %75, label %76, label %56

76:                                               ; preds = %56
  %77 = fneg double %31
  %78 = fsub double %77, %55
  %79 = tail call double @llvm.sqrt.f64(double %73)
  %80 = getelementptr inbounds %struct.World, ptr %17, i64 0, i32 12
  %81 = load ptr, ptr %80, align 8
  %82 = shl nsw i64 %25, 2
  %83 = or i64 %82, 3
  %84 = getelementptr inbounds double, ptr %81, i64 %83
  %85 = load double, ptr %84, align 8
  br i1 %34, label %97, label %86

86:                                               ; preds = %76
  %87 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %88 = load ptr, ptr %87, align 8
  %89 = icmp eq ptr %88, null
  %90 = getelementptr inbounds i64, ptr %88, i64 %1
  %91 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %92 = select i1 %89, ptr %91, ptr %90
  %93 = load i64, ptr %92, align 8
  %94 = getelementptr inbounds double, ptr %33, i64 %93
  %95 = load double, ptr %94, align 8
  %96 = fcmp uno double %95, 0.000000e+00
  br i1 %96, label %453, label %101

97:                                               ; preds = %76
  %98 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %99 = load i32, ptr %98, align 8
  %100 = icmp eq i32 %99, 1
  br i1 %100, label %453, label %101

101:                                              ; preds = %86, %97
  %102 = fsub double %79, %85
  %103 = fsub double %102, %31
  %104 = fcmp ogt double %103, %53
  br i1 %104, label %453, label %105

105:                                              ; preds = %101, %105
  %106 = phi i64 [ %118, %105 ], [ 0, %101 ]
  %107 = phi double [ %117, %105 ], [ 0.000000e+00, %101 ]
  %108 = getelementptr inbounds [3 x double], ptr %3, i64 0, i64 %106
  %109 = load double, ptr %108, align 8
  %110 = fcmp ogt double %109, 0.000000e+00
  %111 = add nuw nsw i64 %106, 3
  %112 = select i1 %110, i64 %111, i64 %106
  %113 = and i64 %112, 4294967295
  %114 = getelementptr inbounds double, ptr %21, i64 %113
  %115 = load double, ptr %114, align 8
  %116 = fmul double %109, %115
  %117 = fadd double %107, %116
  %118 = add nuw nsw i64 %106, 1
  %119 = icmp eq i64 %118, 3
  br i1 %119, label %120, label %105

120:                                              ; preds = %105
  %121 = getelementptr inbounds %struct.Plane, ptr %3, i64 0, i32 1
  %122 = load double, ptr %121, align 8
  %123 = fsub double %122, %117
  %124 = fadd double %78, %123
  %125 = fcmp ogt double %124, %53
  br i1 %125, label %453, label %126

126:                                              ; preds = %120
  %127 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10
  br label %128

128:                                              ; preds = %128, %126
  %129 = phi i64 [ 0, %126 ], [ %141, %128 ]
  %130 = phi double [ 0.000000e+00, %126 ], [ %140, %128 ]
  %131 = getelementptr inbounds [3 x double], ptr %127, i64 0, i64 %129
  %132 = load double, ptr %131, align 8
  %133 = fcmp ogt double %132, 0.000000e+00
  %134 = add nuw nsw i64 %129, 3
  %135 = select i1 %133, i64 %134, i64 %129
  %136 = and i64 %135, 4294967295
  %137 = getelementptr inbounds double, ptr %21, i64 %136
  %138 = load double, ptr %137, align 8
  %139 = fmul double %132, %138
  %140 = fadd double %130, %139
  %141 = add nuw nsw i64 %129, 1
  %142 = icmp eq i64 %141, 3
  br i1 %142, label %143, label %128

143:                                              ; preds = %128
  %144 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10, i32 1
  %145 = load double, ptr %144, align 8
  %146 = fsub double %145, %140
  %147 = fadd double %78, %146
  %148 = fcmp ogt double %147, %53
  br i1 %148, label %453, label %149

149:                                              ; preds = %143
  %150 = getelementptr inbounds %struct.World, ptr %17, i64 0, i32 28
  %151 = load ptr, ptr %150, align 8
  %152 = shl nsw i64 %2, 1
  %153 = getelementptr inbounds i64, ptr %151, i64 %152
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %6) #15
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %7) #15
  %154 = load i64, ptr %153, align 8
  %155 = icmp slt i64 %154, 0
  br i1 %155, label %156, label %260

156:                                              ; preds = %149
  %157 = getelementptr inbounds %struct.World, ptr %17, i64 0, i32 30
  %158 = load ptr, ptr %157, align 8
  %159 = getelementptr inbounds i64, ptr %153, i64 1
  %160 = load i64, ptr %159, align 8
  %161 = mul nsw i64 %160, 9
  %162 = getelementptr inbounds double, ptr %158, i64 %161
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8) #15
  %163 = load double, ptr %162, align 8
  store double %163, ptr %8, align 16
  %164 = getelementptr inbounds double, ptr %8, i64 1
  %165 = getelementptr inbounds double, ptr %162, i64 3
  %166 = load double, ptr %165, align 8
  store double %166, ptr %164, align 8
  %167 = getelementptr inbounds double, ptr %8, i64 2
  %168 = getelementptr inbounds double, ptr %162, i64 6
  %169 = load double, ptr %168, align 8
  store double %169, ptr %167, align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9) #15
  %170 = getelementptr inbounds double, ptr %162, i64 1
  %171 = load double, ptr %170, align 8
  store double %171, ptr %9, align 16
  %172 = getelementptr inbounds double, ptr %9, i64 1
  %173 = getelementptr inbounds double, ptr %162, i64 4
  %174 = load double, ptr %173, align 8
  store double %174, ptr %172, align 8
  %175 = getelementptr inbounds double, ptr %9, i64 2
  %176 = getelementptr inbounds double, ptr %162, i64 7
  %177 = load double, ptr %176, align 8
  store double %177, ptr %175, align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %10) #15
  %178 = getelementptr inbounds double, ptr %162, i64 2
  %179 = load double, ptr %178, align 8
  store double %179, ptr %10, align 16
  %180 = getelementptr inbounds double, ptr %10, i64 1
  %181 = getelementptr inbounds double, ptr %162, i64 5
  %182 = load double, ptr %181, align 8
  store double %182, ptr %180, align 8
  %183 = getelementptr inbounds double, ptr %10, i64 2
  %184 = getelementptr inbounds double, ptr %162, i64 8
  %185 = load double, ptr %184, align 8
  store double %185, ptr %183, align 16
  br label %200

186:                                              ; preds = %218
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %11) #15
  store i64 0, ptr %11, align 8
  %187 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 1
  %188 = icmp eq i32 %221, 0
  %189 = select i1 %188, i64 3, i64 1
  store i64 %189, ptr %187, align 8
  %190 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 2
  store ptr %8, ptr %190, align 8
  %191 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 3
  store ptr %9, ptr %191, align 8
  %192 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 4
  store ptr %10, ptr %192, align 8
  %193 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 5
  store ptr @place.still, ptr %193, align 8
  %194 = getelementptr inbounds %struct.Core, ptr %11, i64 0, i32 6
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(104) %194, i8 0, i64 104, i1 false)
  %195 = load double, ptr %127, align 8
  %196 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10, i32 0, i64 1
  %197 = load double, ptr %196, align 8
  %198 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10, i32 0, i64 2
  %199 = load double, ptr %198, align 8
  br label %228

200:                                              ; preds = %156, %218
  %201 = phi i64 [ 0, %156 ], [ %222, %218 ]
  %202 = phi i32 [ 1, %156 ], [ %221, %218 ]
  %203 = add nuw nsw i64 %201, 3
  %204 = getelementptr inbounds double, ptr %162, i64 %203
  %205 = load double, ptr %204, align 8
  %206 = getelementptr inbounds double, ptr %162, i64 %201
  %207 = load double, ptr %206, align 8
  %208 = fsub double %205, %207
  %209 = tail call double @llvm.fabs.f64(double %208)
  %210 = fcmp olt double %209, 3.000000e-07
  br i1 %210, label %211, label %218

211:                                              ; preds = %200
  %212 = add nuw nsw i64 %201, 6
  %213 = getelementptr inbounds double, ptr %162, i64 %212
  %214 = load double, ptr %213, align 8
  %215 = fsub double %214, %207
  %216 = tail call double @llvm.fabs.f64(double %215)
  %217 = fcmp olt double %216, 3.000000e-07
  br label %218

218:                                              ; preds = %211, %200
  %219 = phi i1 [ false, %200 ], [ %217, %211 ]
  %220 = zext i1 %219 to i32
  %221 = and i32 %202, %220
  %222 = add nuw nsw i64 %201, 1
  %223 = icmp eq i64 %222, 3
  br i1 %223, label %186, label %200

224:                                              ; preds = %228
  %225 = fsub double %145, %243
  %226 = fadd double %78, %225
  %227 = fcmp ogt double %226, %53
  br i1 %227, label %259, label %246

228:                                              ; preds = %186, %228
  %229 = phi i64 [ 0, %186 ], [ %244, %228 ]
  %230 = phi double [ 0xFFF0000000000000, %186 ], [ %243, %228 ]
  %231 = mul nuw nsw i64 %229, 3
  %232 = getelementptr inbounds double, ptr %162, i64 %231
  %233 = load double, ptr %232, align 8
  %234 = fmul double %195, %233
  %235 = getelementptr inbounds double, ptr %232, i64 1
  %236 = load double, ptr %235, align 8
  %237 = fmul double %197, %236
  %238 = fadd double %234, %237
  %239 = getelementptr inbounds double, ptr %232, i64 2
  %240 = load double, ptr %239, align 8
  %241 = fmul double %199, %240
  %242 = fadd double %238, %241
  %243 = call double @llvm.maxnum.f64(double %230, double %242)
  %244 = add nuw nsw i64 %229, 1
  %245 = icmp eq i64 %244, 3
  br i1 %245, label %224, label %228

246:                                              ; preds = %224
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %12) #15
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %12, ptr noundef nonnull align 8 dereferenceable(32) %127, i64 32, i1 false)
  %247 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %248 = load ptr, ptr %247, align 8
  %249 = call fastcc i32 @shape_bounds(ptr noundef %17, i64 noundef %25, ptr noundef %248, i64 noundef %1, ptr noundef nonnull %11, ptr noundef nonnull %127, double noundef %53, double noundef %52, ptr noundef nonnull %6, ptr noundef nonnull %7, ptr noundef nonnull %12)
  %250 = icmp ne i32 %249, 0
  %251 = load double, ptr %6, align 8
  %252 = fcmp ugt double %251, %53
  %253 = select i1 %250, i1 %252, i1 false
  br i1 %253, label %258, label %254

254:                                              ; preds = %246
  %255 = load double, ptr %7, align 8
  call fastcc void @tell(ptr noundef nonnull %0, i64 noundef %1, i32 noundef %249, double noundef %251, double noundef %255)
  %256 = load i64, ptr %159, align 8
  %257 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  store i64 %256, ptr %257, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %127, ptr noundef nonnull align 8 dereferenceable(32) %12, i64 32, i1 false)
  br label %258

258:                                              ; preds = %246, %254
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %12) #15
  br label %259

259:                                              ; preds = %224, %258
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %11) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %10) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8) #15
  br label %452

260:                                              ; preds = %149
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %13) #15
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %13, ptr noundef nonnull align 8 dereferenceable(32) %3, i64 32, i1 false)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %14) #15
  call void @llvm.lifetime.start.p0(i64 152, ptr nonnull %15) #15
  %261 = getelementptr inbounds %struct.Core, ptr %15, i64 0, i32 7
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(72) %261, ptr noundef nonnull align 16 dereferenceable(72) @box_core.straight, i64 72, i1 false)
  br label %262

262:                                              ; preds = %262, %260
  %263 = phi i64 [ 0, %260 ], [ %278, %262 ]
  %264 = getelementptr inbounds double, ptr %21, i64 %263
  %265 = load double, ptr %264, align 8
  %266 = add nuw nsw i64 %263, 3
  %267 = getelementptr inbounds double, ptr %21, i64 %266
  %268 = load double, ptr %267, align 8
  %269 = fadd double %265, %268
  %270 = fmul double %269, 5.000000e-01
  %271 = add nuw nsw i64 %263, 9
  %272 = getelementptr inbounds %struct.Core, ptr %15, i64 0, i32 7, i64 %271
  store double %270, ptr %272, align 8
  %273 = load double, ptr %267, align 8
  %274 = load double, ptr %264, align 8
  %275 = fsub double %273, %274
  %276 = fmul double %275, 5.000000e-01
  %277 = getelementptr inbounds double, ptr %14, i64 %263
  store double %276, ptr %277, align 8
  %278 = add nuw nsw i64 %263, 1
  %279 = icmp eq i64 %278, 3
  br i1 %279, label %280, label %262

280:                                              ; preds = %262
  store i64 1, ptr %15, align 8
  %281 = getelementptr inbounds %struct.Core, ptr %15, i64 0, i32 5
  store ptr %261, ptr %281, align 8
  %282 = getelementptr inbounds %struct.Core, ptr %15, i64 0, i32 6
  store ptr %14, ptr %282, align 8
  %283 = getelementptr inbounds %struct.Core, ptr %15, i64 0, i32 7, i64 9
  %284 = load double, ptr %14, align 16
  %285 = fmul double %284, %284
  %286 = getelementptr inbounds double, ptr %14, i64 1
  %287 = load double, ptr %286, align 8
  %288 = fmul double %287, %287
  %289 = fadd double %285, %288
  %290 = getelementptr inbounds double, ptr %14, i64 2
  %291 = load double, ptr %290, align 16
  %292 = fmul double %291, %291
  %293 = fadd double %289, %292
  %294 = call double @llvm.sqrt.f64(double %293)
  %295 = getelementptr inbounds %struct.World, ptr %17, i64 0, i32 31
  %296 = load ptr, ptr %295, align 8
  %297 = getelementptr inbounds %struct.World, ptr %17, i64 0, i32 5
  %298 = load ptr, ptr %297, align 8
  %299 = getelementptr inbounds i64, ptr %298, i64 %25
  %300 = load i64, ptr %299, align 8
  %301 = mul nsw i64 %300, 12
  %302 = getelementptr inbounds double, ptr %296, i64 %301
  %303 = load double, ptr %283, align 8
  %304 = getelementptr inbounds double, ptr %302, i64 9
  %305 = load double, ptr %304, align 8
  %306 = fsub double %303, %305
  %307 = getelementptr inbounds %struct.Core, ptr %15, i64 0, i32 7, i64 10
  %308 = load double, ptr %307, align 8
  %309 = getelementptr inbounds double, ptr %302, i64 10
  %310 = load double, ptr %309, align 8
  %311 = fsub double %308, %310
  %312 = getelementptr inbounds %struct.Core, ptr %15, i64 0, i32 7, i64 11
  %313 = load double, ptr %312, align 8
  %314 = getelementptr inbounds double, ptr %302, i64 11
  %315 = load double, ptr %314, align 8
  %316 = fsub double %313, %315
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %5) #15
  br label %317

317:                                              ; preds = %317, %280
  %318 = phi i64 [ 0, %280 ], [ %333, %317 ]
  %319 = getelementptr inbounds double, ptr %302, i64 %318
  %320 = load double, ptr %319, align 8
  %321 = fmul double %306, %320
  %322 = add nuw nsw i64 %318, 3
  %323 = getelementptr inbounds double, ptr %302, i64 %322
  %324 = load double, ptr %323, align 8
  %325 = fmul double %311, %324
  %326 = fadd double %321, %325
  %327 = add nuw nsw i64 %318, 6
  %328 = getelementptr inbounds double, ptr %302, i64 %327
  %329 = load double, ptr %328, align 8
  %330 = fmul double %316, %329
  %331 = fadd double %326, %330
  %332 = getelementptr inbounds double, ptr %5, i64 %318
  store double %331, ptr %332, align 8
  %333 = add nuw nsw i64 %318, 1
  %334 = icmp eq i64 %333, 3
  br i1 %334, label %335, label %317

335:                                              ; preds = %317
  %336 = getelementptr inbounds %struct.World, ptr %17, i64 0, i32 13
  %337 = load ptr, ptr %336, align 8
  %338 = mul nsw i64 %25, 6
  %339 = getelementptr inbounds double, ptr %337, i64 %338
  br label %340

340:                                              ; preds = %340, %335
  %341 = phi i64 [ 0, %335 ], [ %358, %340 ]
  %342 = phi double [ 0.000000e+00, %335 ], [ %357, %340 ]
  %343 = getelementptr inbounds double, ptr %339, i64 %341
  %344 = load double, ptr %343, align 8
  %345 = getelementptr inbounds double, ptr %5, i64 %341
  %346 = load double, ptr %345, align 8
  %347 = fsub double %344, %346
  %348 = add nuw nsw i64 %341, 3
  %349 = getelementptr inbounds double, ptr %339, i64 %348
  %350 = load double, ptr %349, align 8
  %351 = fsub double %346, %350
  %352 = fcmp ogt double %347, %351
  %353 = select i1 %352, double %347, double %351
  %354 = fcmp ogt double %353, 0.000000e+00
  %355 = select i1 %354, double %353, double 0.000000e+00
  %356 = fmul double %355, %355
  %357 = fadd double %342, %356
  %358 = add nuw nsw i64 %341, 1
  %359 = icmp eq i64 %358, 3
  br i1 %359, label %360, label %340

360:                                              ; preds = %340
  %361 = fadd double %31, %53
  %362 = fadd double %361, %294
  %363 = fmul double %362, %362
  %364 = fcmp ule double %357, %363
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5) #15
  br i1 %364, label %365, label %451

365:                                              ; preds = %360
  %366 = fadd double %284, %287
  %367 = fadd double %366, %291
  %368 = load ptr, ptr %80, align 8
  %369 = getelementptr inbounds double, ptr %368, i64 %83
  %370 = load double, ptr %369, align 8
  %371 = fmul double %370, 2.000000e+00
  %372 = fcmp olt double %367, %371
  br i1 %372, label %373, label %398

373:                                              ; preds = %365
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %16) #15
  br label %380

374:                                              ; preds = %380
  %375 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %376 = load ptr, ptr %375, align 8
  %377 = fsub double %53, %78
  %378 = call fastcc i32 @bounds(ptr noundef %376, ptr noundef nonnull %15, ptr noundef nonnull %16, double noundef %377, double noundef %377, ptr noundef nonnull %6, ptr noundef nonnull %7, ptr noundef nonnull %13)
  %379 = icmp eq i32 %378, 0
  br i1 %379, label %395, label %391

380:                                              ; preds = %373, %380
  %381 = phi i64 [ 0, %373 ], [ %389, %380 ]
  %382 = getelementptr inbounds double, ptr %27, i64 %381
  %383 = load double, ptr %382, align 8
  %384 = add nuw nsw i64 %381, 9
  %385 = getelementptr inbounds %struct.Core, ptr %15, i64 0, i32 7, i64 %384
  %386 = load double, ptr %385, align 8
  %387 = fsub double %383, %386
  %388 = getelementptr inbounds [3 x double], ptr %16, i64 0, i64 %381
  store double %387, ptr %388, align 8
  %389 = add nuw nsw i64 %381, 1
  %390 = icmp eq i64 %389, 3
  br i1 %390, label %374, label %380

391:                                              ; preds = %374
  %392 = load double, ptr %6, align 8
  %393 = fadd double %78, %392
  %394 = fcmp ogt double %393, %53
  br i1 %394, label %397, label %395

395:                                              ; preds = %391, %374
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %16) #15
  %396 = load ptr, ptr %18, align 8
  br label %398

397:                                              ; preds = %391
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %16) #15
  br label %451

398:                                              ; preds = %395, %365
  %399 = phi ptr [ %396, %395 ], [ %19, %365 ]
  %400 = load i64, ptr %153, align 8
  %401 = mul nsw i64 %400, 6
  %402 = getelementptr inbounds double, ptr %399, i64 %401
  br label %403

403:                                              ; preds = %403, %398
  %404 = phi i64 [ 0, %398 ], [ %416, %403 ]
  %405 = phi double [ 0.000000e+00, %398 ], [ %415, %403 ]
  %406 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %404
  %407 = load double, ptr %406, align 8
  %408 = fcmp ogt double %407, 0.000000e+00
  %409 = add nuw nsw i64 %404, 3
  %410 = select i1 %408, i64 %409, i64 %404
  %411 = and i64 %410, 4294967295
  %412 = getelementptr inbounds double, ptr %402, i64 %411
  %413 = load double, ptr %412, align 8
  %414 = fmul double %407, %413
  %415 = fadd double %405, %414
  %416 = add nuw nsw i64 %404, 1
  %417 = icmp eq i64 %416, 3
  br i1 %417, label %418, label %403

418:                                              ; preds = %403
  %419 = getelementptr inbounds %struct.Plane, ptr %13, i64 0, i32 1
  %420 = load double, ptr %419, align 8
  %421 = getelementptr inbounds i64, ptr %153, i64 1
  %422 = load i64, ptr %421, align 8
  %423 = mul nsw i64 %422, 6
  %424 = getelementptr inbounds double, ptr %399, i64 %423
  br label %425

425:                                              ; preds = %425, %418
  %426 = phi i64 [ 0, %418 ], [ %438, %425 ]
  %427 = phi double [ 0.000000e+00, %418 ], [ %437, %425 ]
  %428 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %426
  %429 = load double, ptr %428, align 8
  %430 = fcmp ogt double %429, 0.000000e+00
  %431 = add nuw nsw i64 %426, 3
  %432 = select i1 %430, i64 %431, i64 %426
  %433 = and i64 %432, 4294967295
  %434 = getelementptr inbounds double, ptr %424, i64 %433
  %435 = load double, ptr %434, align 8
  %436 = fmul double %429, %435
  %437 = fadd double %427, %436
  %438 = add nuw nsw i64 %426, 1
  %439 = icmp eq i64 %438, 3
  br i1 %439, label %440, label %425

440:                                              ; preds = %425
  %441 = fsub double %420, %415
  %442 = fsub double %420, %437
  %443 = fcmp olt double %442, %441
  %444 = zext i1 %443 to i64
  %445 = getelementptr inbounds i64, ptr %153, i64 %444
  %446 = load i64, ptr %445, align 8
  call fastcc void @surface(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %446, ptr noundef nonnull %13)
  %447 = xor i1 %443, true
  %448 = zext i1 %447 to i64
  %449 = getelementptr inbounds i64, ptr %153, i64 %448
  %450 = load i64, ptr %449, align 8
  call fastcc void @surface(ptr noundef nonnull %0, i64 noundef %1, i64 noundef %450, ptr noundef nonnull %13)
  br label %451

451:                                              ; preds = %397, %360, %440
  call void @llvm.lifetime.end.p0(i64 152, ptr nonnull %15) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %14) #15
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %13) #15
  br label %452

452:                                              ; preds = %451, %259
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %7) #15
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %6) #15
  br label %453

453:                                              ; preds = %86, %120, %143, %97, %101, %452
  ret void
}

define internal fastcc void @support(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef writeonly %2) unnamed_addr #10 {
  %4 = alloca [64 x double], align 16
  %5 = alloca [3 x double], align 16
  %6 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %5) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #15
  %7 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 5
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr inbounds double, ptr %1, i64 1
  %10 = getelementptr inbounds double, ptr %1, i64 2
  %11 = load double, ptr %1, align 8
  %12 = load double, ptr %9, align 8
  %13 = load double, ptr %10, align 8
  br label %14

14:                                               ; preds = %14, %3
  %15 = phi i64 [ 0, %3 ], [ %30, %14 ]
  %16 = getelementptr inbounds double, ptr %8, i64 %15
  %17 = load double, ptr %16, align 8
  %18 = fmul double %17, %11
  %19 = add nuw nsw i64 %15, 3
  %20 = getelementptr inbounds double, ptr %8, i64 %19
  %21 = load double, ptr %20, align 8
  %22 = fmul double %21, %12
  %23 = fadd double %18, %22
  %24 = add nuw nsw i64 %15, 6
  %25 = getelementptr inbounds double, ptr %8, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = fmul double %26, %13
  %28 = fadd double %23, %27
  %29 = getelementptr inbounds double, ptr %5, i64 %15
  store double %28, ptr %29, align 8
  %30 = add nuw nsw i64 %15, 1
  %31 = icmp eq i64 %30, 3
  br i1 %31, label %32, label %14

32:                                               ; preds = %14
  %33 = load i64, ptr %0, align 8
  switch i64 %33, label %127 [
    i64 0, label %37
    i64 1, label %34
  ]

34:                                               ; preds = %32
  %35 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 6
  %36 = load ptr, ptr %35, align 8
  br label %115

37:                                               ; preds = %32
  %38 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 2
  %39 = load ptr, ptr %38, align 8
  %40 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 3
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 4
  %43 = load ptr, ptr %42, align 8
  %44 = load double, ptr %5, align 16
  %45 = load double, ptr %39, align 8
  %46 = getelementptr inbounds double, ptr %5, i64 1
  %47 = load double, ptr %46, align 8
  %48 = load double, ptr %41, align 8
  %49 = getelementptr inbounds double, ptr %5, i64 2
  %50 = load double, ptr %49, align 16
  %51 = load double, ptr %43, align 8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %4) #15
  %52 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 1
  %53 = load i64, ptr %52, align 8
  %54 = icmp sgt i64 %53, 1
  br i1 %54, label %55, label %111

55:                                               ; preds = %37
  %56 = fmul double %44, %45
  %57 = fmul double %47, %48
  %58 = fadd double %56, %57
  %59 = fmul double %50, %51
  %60 = fadd double %58, %59
  br label %61

61:                                               ; preds = %87, %55
  %62 = phi double [ %89, %87 ], [ %60, %55 ]
  %63 = phi i64 [ %90, %87 ], [ 1, %55 ]
  %64 = phi i64 [ %88, %87 ], [ 0, %55 ]
  %65 = sub nsw i64 %53, %63
  %66 = tail call i64 @llvm.smin.i64(i64 %65, i64 64)
  %67 = icmp sgt i64 %65, 0
  br i1 %67, label %68, label %87

68:                                               ; preds = %61
  %69 = tail call i64 @llvm.smax.i64(i64 %66, i64 1)
  br label %70

70:                                               ; preds = %70, %68
  %71 = phi i64 [ %85, %70 ], [ 0, %68 ]
  %72 = add nsw i64 %71, %63
  %73 = getelementptr inbounds double, ptr %39, i64 %72
  %74 = load double, ptr %73, align 8
  %75 = fmul double %44, %74
  %76 = getelementptr inbounds double, ptr %41, i64 %72
  %77 = load double, ptr %76, align 8
  %78 = fmul double %47, %77
  %79 = fadd double %75, %78
  %80 = getelementptr inbounds double, ptr %43, i64 %72
  %81 = load double, ptr %80, align 8
  %82 = fmul double %50, %81
  %83 = fadd double %79, %82
  %84 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %71
  store double %83, ptr %84, align 8
  %85 = add nuw nsw i64 %71, 1
  %86 = icmp eq i64 %85, %69
  br i1 %86, label %92, label %70

87:                                               ; preds = %92, %61
  %88 = phi i64 [ %64, %61 ], [ %100, %92 ]
  %89 = phi double [ %62, %61 ], [ %101, %92 ]
  %90 = add nsw i64 %66, %63
  %91 = icmp sgt i64 %53, %90
  br i1 %91, label %61, label %104

92:                                               ; preds = %70, %92
  %93 = phi i64 [ %102, %92 ], [ 0, %70 ]
  %94 = phi double [ %101, %92 ], [ %62, %70 ]
  %95 = phi i64 [ %100, %92 ], [ %64, %70 ]
  %96 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %93
  %97 = load double, ptr %96, align 8
  %98 = fcmp ogt double %97, %94
  %99 = add nsw i64 %93, %63
  %100 = select i1 %98, i64 %99, i64 %95
  %101 = select i1 %98, double %97, double %94
  %102 = add nuw nsw i64 %93, 1
  %103 = icmp eq i64 %102, %69
  br i1 %103, label %87, label %92

104:                                              ; preds = %87
  %105 = getelementptr inbounds double, ptr %39, i64 %88
  %106 = load double, ptr %105, align 8
  %107 = getelementptr inbounds double, ptr %41, i64 %88
  %108 = load double, ptr %107, align 8
  %109 = getelementptr inbounds double, ptr %43, i64 %88
  %110 = load double, ptr %109, align 8
  br label %111

111:                                              ; preds = %104, %37
  %112 = phi double [ %51, %37 ], [ %110, %104 ]
  %113 = phi double [ %48, %37 ], [ %108, %104 ]
  %114 = phi double [ %45, %37 ], [ %106, %104 ]
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %4) #15
  br label %160

115:                                              ; preds = %34, %115
  %116 = phi i64 [ 0, %34 ], [ %125, %115 ]
  %117 = getelementptr inbounds [3 x double], ptr %5, i64 0, i64 %116
  %118 = load double, ptr %117, align 8
  %119 = fcmp ult double %118, 0.000000e+00
  %120 = getelementptr inbounds double, ptr %36, i64 %116
  %121 = load double, ptr %120, align 8
  %122 = fneg double %121
  %123 = select i1 %119, double %122, double %121
  %124 = getelementptr inbounds [3 x double], ptr %6, i64 0, i64 %116
  store double %123, ptr %124, align 8
  %125 = add nuw nsw i64 %116, 1
  %126 = icmp eq i64 %125, 3
  br i1 %126, label %154, label %115

127:                                              ; preds = %32
  %128 = load double, ptr %5, align 16
  %129 = fmul double %128, %128
  %130 = getelementptr inbounds [3 x double], ptr %5, i64 0, i64 1
  %131 = load double, ptr %130, align 8
  %132 = fmul double %131, %131
  %133 = fadd double %129, %132
  %134 = tail call double @llvm.sqrt.f64(double %133)
  %135 = fcmp ogt double %134, 0.000000e+00
  br i1 %135, label %136, label %141

136:                                              ; preds = %127
  %137 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 6
  %138 = load ptr, ptr %137, align 8
  %139 = load double, ptr %138, align 8
  %140 = fdiv double %139, %134
  br label %141

141:                                              ; preds = %127, %136
  %142 = phi double [ %140, %136 ], [ 0.000000e+00, %127 ]
  %143 = fmul double %128, %142
  %144 = fmul double %131, %142
  %145 = getelementptr inbounds [3 x double], ptr %5, i64 0, i64 2
  %146 = load double, ptr %145, align 16
  %147 = fcmp ult double %146, 0.000000e+00
  %148 = getelementptr inbounds %struct.Core, ptr %0, i64 0, i32 6
  %149 = load ptr, ptr %148, align 8
  %150 = getelementptr inbounds double, ptr %149, i64 1
  %151 = load double, ptr %150, align 8
  %152 = fneg double %151
  %153 = select i1 %147, double %152, double %151
  br label %160

154:                                              ; preds = %115
  %155 = load double, ptr %6, align 16
  %156 = getelementptr inbounds double, ptr %6, i64 1
  %157 = load double, ptr %156, align 8
  %158 = getelementptr inbounds double, ptr %6, i64 2
  %159 = load double, ptr %158, align 16
  br label %160

160:                                              ; preds = %154, %141, %111
  %161 = phi double [ %159, %154 ], [ %153, %141 ], [ %112, %111 ]
  %162 = phi double [ %157, %154 ], [ %144, %141 ], [ %113, %111 ]
  %163 = phi double [ %155, %154 ], [ %143, %141 ], [ %114, %111 ]
  br label %164

164:                                              ; preds = %164, %160
  %165 = phi i64 [ 0, %160 ], [ %185, %164 ]
  %166 = mul nuw nsw i64 %165, 3
  %167 = getelementptr inbounds double, ptr %8, i64 %166
  %168 = load double, ptr %167, align 8
  %169 = fmul double %168, %163
  %170 = add nuw nsw i64 %166, 1
  %171 = getelementptr inbounds double, ptr %8, i64 %170
  %172 = load double, ptr %171, align 8
  %173 = fmul double %172, %162
  %174 = fadd double %169, %173
  %175 = add nuw nsw i64 %166, 2
  %176 = getelementptr inbounds double, ptr %8, i64 %175
  %177 = load double, ptr %176, align 8
  %178 = fmul double %177, %161
  %179 = fadd double %174, %178
  %180 = add nuw nsw i64 %165, 9
  %181 = getelementptr inbounds double, ptr %8, i64 %180
  %182 = load double, ptr %181, align 8
  %183 = fadd double %182, %179
  %184 = getelementptr inbounds double, ptr %2, i64 %165
  store double %183, ptr %184, align 8
  %185 = add nuw nsw i64 %165, 1
  %186 = icmp eq i64 %185, 3
  br i1 %186, label %187, label %164

187:                                              ; preds = %164
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %6) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %5) #15
  ret void
}

define internal fastcc i32 @within(ptr noundef readonly %0, i64 noundef %1, ptr noundef readonly %2) unnamed_addr #8 {
  %4 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 27
  %5 = load ptr, ptr %4, align 8
  %6 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 29
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

define internal fastcc i32 @is_beside(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, double noundef %2, i64 noundef %3, double noundef %4) unnamed_addr #8 {
  %6 = alloca [3 x double], align 16
  %7 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 31
  %8 = load ptr, ptr %7, align 8
  %9 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 5
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
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %6) #15
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
  %48 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 13
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

define internal fastcc i32 @shape_bounds(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef readonly %2, i64 noundef %3, ptr nocapture noundef readonly %4, ptr nocapture noundef readonly %5, double noundef %6, double noundef %7, ptr nocapture noundef %8, ptr nocapture noundef %9, ptr noundef %10) unnamed_addr #11 {
  %12 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 9
  %13 = load ptr, ptr %12, align 8
  %14 = getelementptr inbounds double, ptr %13, i64 %1
  %15 = load double, ptr %14, align 8
  %16 = getelementptr inbounds double, ptr %13, i64 %3
  %17 = load double, ptr %16, align 8
  %18 = fadd double %15, %17
  %19 = fadd double %18, %6
  %20 = fadd double %18, %7
  %21 = tail call fastcc i32 @bounds(ptr noundef %2, ptr noundef %4, ptr noundef %5, double noundef %19, double noundef %20, ptr noundef %8, ptr noundef %9, ptr noundef %10)
  %22 = load double, ptr %8, align 8
  %23 = fsub double %22, %18
  store double %23, ptr %8, align 8
  %24 = load double, ptr %9, align 8
  %25 = fsub double %24, %18
  store double %25, ptr %9, align 8
  ret i32 %21
}

declare double @llvm.minnum.f64(double, double) #2

declare double @llvm.sqrt.f64(double) #2

declare double @llvm.maxnum.f64(double, double) #2

define internal fastcc i32 @bounds(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, double noundef %3, double noundef %4, ptr nocapture noundef %5, ptr nocapture noundef %6, ptr noundef %7) unnamed_addr #11 {
  %9 = alloca [4 x [3 x double]], align 16
  %10 = alloca [3 x double], align 16
  %11 = alloca [3 x double], align 16
  %12 = alloca [4 x [3 x double]], align 16
  %13 = alloca [4 x [3 x double]], align 16
  %14 = alloca [3 x double], align 16
  %15 = alloca [3 x double], align 16
  %16 = alloca [3 x i32], align 4
  %17 = alloca [3 x double], align 16
  %18 = alloca [3 x double], align 16
  %19 = alloca [3 x double], align 16
  %20 = alloca [3 x double], align 16
  %21 = alloca [3 x i32], align 4
  %22 = alloca %struct.Simplex, align 8
  %23 = alloca [3 x double], align 16
  %24 = alloca [3 x double], align 16
  %25 = alloca [3 x double], align 16
  %26 = alloca [3 x double], align 16
  %27 = alloca [3 x double], align 16
  call void @llvm.lifetime.start.p0(i64 128, ptr nonnull %22) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %23) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %24) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %25) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %26) #15
  %28 = load double, ptr %2, align 8
  %29 = fmul double %28, %28
  %30 = getelementptr inbounds double, ptr %2, i64 1
  %31 = load double, ptr %30, align 8
  %32 = fmul double %31, %31
  %33 = fadd double %29, %32
  %34 = getelementptr inbounds double, ptr %2, i64 2
  %35 = load double, ptr %34, align 8
  %36 = fmul double %35, %35
  %37 = fadd double %33, %36
  %38 = tail call double @llvm.sqrt.f64(double %37)
  %39 = fcmp ogt double %38, 0.000000e+00
  br label %74

40:                                               ; preds = %83
  store double 0xFFF0000000000000, ptr %5, align 8
  store double 0x7FF0000000000000, ptr %6, align 8
  %41 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 1
  store i32 0, ptr %41, align 8
  %42 = getelementptr inbounds double, ptr %27, i64 1
  %43 = getelementptr inbounds [3 x double], ptr %24, i64 0, i64 1
  %44 = getelementptr inbounds [3 x double], ptr %25, i64 0, i64 1
  %45 = getelementptr inbounds double, ptr %27, i64 2
  %46 = getelementptr inbounds [3 x double], ptr %24, i64 0, i64 2
  %47 = getelementptr inbounds [3 x double], ptr %25, i64 0, i64 2
  %48 = getelementptr inbounds double, ptr %23, i64 1
  %49 = getelementptr inbounds double, ptr %23, i64 2
  %50 = icmp eq ptr %7, null
  %51 = getelementptr inbounds double, ptr %7, i64 1
  %52 = getelementptr inbounds double, ptr %7, i64 2
  %53 = getelementptr inbounds %struct.Plane, ptr %7, i64 0, i32 1
  %54 = getelementptr inbounds double, ptr %14, i64 1
  %55 = getelementptr inbounds double, ptr %14, i64 2
  %56 = getelementptr inbounds double, ptr %22, i64 1
  %57 = getelementptr inbounds double, ptr %22, i64 2
  %58 = getelementptr inbounds [4 x [3 x double]], ptr %22, i64 0, i64 1
  %59 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 2
  %60 = getelementptr inbounds [3 x double], ptr %17, i64 0, i64 1
  %61 = getelementptr inbounds [3 x double], ptr %18, i64 0, i64 2
  %62 = getelementptr inbounds [3 x double], ptr %17, i64 0, i64 2
  %63 = getelementptr inbounds [3 x double], ptr %18, i64 0, i64 1
  %64 = getelementptr inbounds double, ptr %19, i64 1
  %65 = getelementptr inbounds double, ptr %19, i64 2
  %66 = getelementptr inbounds double, ptr %10, i64 1
  %67 = getelementptr inbounds double, ptr %10, i64 2
  %68 = getelementptr inbounds double, ptr %11, i64 1
  %69 = getelementptr inbounds double, ptr %11, i64 2
  %70 = getelementptr inbounds double, ptr %20, i64 1
  %71 = getelementptr inbounds double, ptr %20, i64 2
  %72 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 2, i64 1
  %73 = getelementptr inbounds %struct.Simplex, ptr %22, i64 0, i32 2, i64 2
  br label %88

74:                                               ; preds = %8, %83
  %75 = phi i64 [ 0, %8 ], [ %86, %83 ]
  br i1 %39, label %76, label %80

76:                                               ; preds = %74
  %77 = getelementptr inbounds double, ptr %2, i64 %75
  %78 = load double, ptr %77, align 8
  %79 = fdiv double %78, %38
  br label %83

80:                                               ; preds = %74
  %81 = icmp eq i64 %75, 0
  %82 = uitofp i1 %81 to double
  br label %83

83:                                               ; preds = %80, %76
  %84 = phi double [ %79, %76 ], [ %82, %80 ]
  %85 = getelementptr inbounds [3 x double], ptr %23, i64 0, i64 %75
  store double %84, ptr %85, align 8
  %86 = add nuw nsw i64 %75, 1
  %87 = icmp eq i64 %86, 3
  br i1 %87, label %40, label %74

88:                                               ; preds = %40, %577
  %89 = phi i32 [ 0, %40 ], [ %552, %577 ]
  %90 = phi i32 [ 0, %40 ], [ %578, %577 ]
  br label %118

91:                                               ; preds = %118
  call fastcc void @support(ptr noundef %0, ptr noundef nonnull %26, ptr noundef nonnull %24)
  call fastcc void @support(ptr noundef %1, ptr noundef nonnull %23, ptr noundef nonnull %25)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %27) #15
  %92 = load double, ptr %24, align 16
  %93 = load double, ptr %25, align 16
  %94 = fsub double %92, %93
  store double %94, ptr %27, align 16
  %95 = load double, ptr %43, align 8
  %96 = load double, ptr %44, align 8
  %97 = fsub double %95, %96
  store double %97, ptr %42, align 8
  %98 = load double, ptr %46, align 16
  %99 = load double, ptr %47, align 16
  %100 = fsub double %98, %99
  store double %100, ptr %45, align 16
  %101 = load double, ptr %23, align 16
  %102 = fmul double %101, %101
  %103 = load double, ptr %48, align 8
  %104 = fmul double %103, %103
  %105 = fadd double %102, %104
  %106 = load double, ptr %49, align 16
  %107 = fmul double %106, %106
  %108 = fadd double %105, %107
  %109 = tail call double @llvm.sqrt.f64(double %108)
  %110 = fmul double %94, %101
  %111 = fmul double %97, %103
  %112 = fadd double %110, %111
  %113 = fmul double %100, %106
  %114 = fadd double %112, %113
  %115 = fdiv double %114, %109
  %116 = load double, ptr %5, align 8
  %117 = fcmp ogt double %115, %116
  br i1 %117, label %126, label %145

118:                                              ; preds = %88, %118
  %119 = phi i64 [ 0, %88 ], [ %124, %118 ]
  %120 = getelementptr inbounds [3 x double], ptr %23, i64 0, i64 %119
  %121 = load double, ptr %120, align 8
  %122 = fneg double %121
  %123 = getelementptr inbounds [3 x double], ptr %26, i64 0, i64 %119
  store double %122, ptr %123, align 8
  %124 = add nuw nsw i64 %119, 1
  %125 = icmp eq i64 %124, 3
  br i1 %125, label %91, label %118

126:                                              ; preds = %91
  store double %115, ptr %5, align 8
  br i1 %50, label %145, label %137

127:                                              ; preds = %137
  %128 = load double, ptr %7, align 8
  %129 = fmul double %92, %128
  %130 = load double, ptr %51, align 8
  %131 = fmul double %130, %95
  %132 = fadd double %129, %131
  %133 = load double, ptr %52, align 8
  %134 = fmul double %133, %98
  %135 = fadd double %132, %134
  store double %135, ptr %53, align 8
  %136 = load double, ptr %5, align 8
  br label %145

137:                                              ; preds = %126, %137
  %138 = phi i64 [ %143, %137 ], [ 0, %126 ]
  %139 = getelementptr inbounds [3 x double], ptr %23, i64 0, i64 %138
  %140 = load double, ptr %139, align 8
  %141 = fdiv double %140, %109
  %142 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %138
  store double %141, ptr %142, align 8
  %143 = add nuw nsw i64 %138, 1
  %144 = icmp eq i64 %143, 3
  br i1 %144, label %127, label %137

145:                                              ; preds = %126, %127, %91
  %146 = phi double [ %115, %126 ], [ %136, %127 ], [ %116, %91 ]
  %147 = fcmp ogt double %146, %3
  br i1 %147, label %575, label %148

148:                                              ; preds = %145
  %149 = load double, ptr %6, align 8
  %150 = fsub double %149, %146
  %151 = fcmp ugt double %150, 0x3DA5FD7FE1796495
  br i1 %151, label %152, label %575

152:                                              ; preds = %148
  %153 = icmp sgt i32 %89, 0
  br i1 %153, label %154, label %164

154:                                              ; preds = %152
  %155 = zext i32 %89 to i64
  br label %159

156:                                              ; preds = %159
  %157 = add nuw nsw i64 %160, 1
  %158 = icmp eq i64 %157, %155
  br i1 %158, label %164, label %159

159:                                              ; preds = %154, %156
  %160 = phi i64 [ 0, %154 ], [ %157, %156 ]
  %161 = getelementptr inbounds [4 x [3 x double]], ptr %22, i64 0, i64 %160
  %162 = call i32 @bcmp(ptr noundef nonnull dereferenceable(24) %161, ptr noundef nonnull dereferenceable(24) %27, i64 24)
  %163 = icmp eq i32 %162, 0
  br i1 %163, label %575, label %156

164:                                              ; preds = %156, %152
  %165 = add nsw i32 %89, 1
  store i32 %165, ptr %41, align 8
  %166 = sext i32 %89 to i64
  %167 = getelementptr inbounds [4 x [3 x double]], ptr %22, i64 0, i64 %166
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %167, ptr noundef nonnull align 16 dereferenceable(24) %27, i64 24, i1 false)
  %168 = load i32, ptr %41, align 8
  switch i32 %168, label %222 [
    i32 1, label %169
    i32 2, label %170
  ]

169:                                              ; preds = %164
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %59, ptr noundef nonnull align 8 dereferenceable(24) %22, i64 24, i1 false)
  br label %551

170:                                              ; preds = %164
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %14) #15
  br label %181

171:                                              ; preds = %181
  %172 = load double, ptr %14, align 16
  %173 = fmul double %172, %172
  %174 = load double, ptr %54, align 8
  %175 = fmul double %174, %174
  %176 = fadd double %173, %175
  %177 = load double, ptr %55, align 16
  %178 = fmul double %177, %177
  %179 = fadd double %176, %178
  %180 = fcmp ogt double %179, 0.000000e+00
  br i1 %180, label %191, label %203

181:                                              ; preds = %181, %170
  %182 = phi i64 [ 0, %170 ], [ %189, %181 ]
  %183 = getelementptr inbounds [4 x [3 x double]], ptr %22, i64 0, i64 1, i64 %182
  %184 = load double, ptr %183, align 8
  %185 = getelementptr inbounds [3 x double], ptr %22, i64 0, i64 %182
  %186 = load double, ptr %185, align 8
  %187 = fsub double %184, %186
  %188 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %182
  store double %187, ptr %188, align 8
  %189 = add nuw nsw i64 %182, 1
  %190 = icmp eq i64 %189, 3
  br i1 %190, label %171, label %181

191:                                              ; preds = %171
  %192 = load double, ptr %22, align 8
  %193 = fmul double %172, %192
  %194 = load double, ptr %56, align 8
  %195 = fmul double %174, %194
  %196 = fadd double %193, %195
  %197 = load double, ptr %57, align 8
  %198 = fmul double %177, %197
  %199 = fadd double %196, %198
  %200 = fneg double %199
  %201 = fdiv double %200, %179
  %202 = fcmp ugt double %201, 0.000000e+00
  br i1 %202, label %204, label %203

203:                                              ; preds = %191, %171
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %13)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %13, ptr noundef nonnull align 8 dereferenceable(24) %22, i64 24, i1 false)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(96) %22, ptr noundef nonnull align 16 dereferenceable(96) %13, i64 96, i1 false)
  store i32 1, ptr %41, align 8
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %13)
  br label %219

204:                                              ; preds = %191
  %205 = fcmp ult double %201, 1.000000e+00
  br i1 %205, label %207, label %206

206:                                              ; preds = %204
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %12)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %12, ptr noundef nonnull align 8 dereferenceable(24) %58, i64 24, i1 false)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(96) %22, ptr noundef nonnull align 16 dereferenceable(96) %12, i64 96, i1 false)
  store i32 1, ptr %41, align 8
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %12)
  br label %219

207:                                              ; preds = %204, %207
  %208 = phi i64 [ %217, %207 ], [ 0, %204 ]
  %209 = getelementptr inbounds double, ptr %22, i64 %208
  %210 = load double, ptr %209, align 8
  %211 = getelementptr inbounds double, ptr %58, i64 %208
  %212 = load double, ptr %211, align 8
  %213 = fsub double %212, %210
  %214 = fmul double %201, %213
  %215 = fadd double %210, %214
  %216 = getelementptr inbounds double, ptr %59, i64 %208
  store double %215, ptr %216, align 8
  %217 = add nuw nsw i64 %208, 1
  %218 = icmp eq i64 %217, 3
  br i1 %218, label %220, label %207

219:                                              ; preds = %206, %203
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %59, ptr noundef nonnull align 8 dereferenceable(24) %22, i64 24, i1 false)
  br label %220

220:                                              ; preds = %207, %219
  %221 = phi i32 [ 1, %219 ], [ 2, %207 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %14) #15
  br label %551

222:                                              ; preds = %164
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %15)
  call void @llvm.lifetime.start.p0(i64 12, ptr nonnull %16) #15
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 4 dereferenceable(12) %16, ptr noundef nonnull align 4 dereferenceable(12) @__const.reduce.chosen, i64 12, i1 false)
  %223 = icmp eq i32 %168, 4
  %224 = zext i1 %223 to i32
  %225 = icmp ne i32 %168, 3
  br label %229

226:                                              ; preds = %505
  %227 = icmp ne i32 %506, 0
  %228 = select i1 %223, i1 %227, i1 false
  br i1 %228, label %548, label %512

229:                                              ; preds = %505, %222
  %230 = phi i64 [ 0, %222 ], [ %509, %505 ]
  %231 = phi double [ 0x7FF0000000000000, %222 ], [ %508, %505 ]
  %232 = phi i32 [ 7, %222 ], [ %507, %505 ]
  %233 = phi i32 [ %224, %222 ], [ %506, %505 ]
  %234 = getelementptr inbounds [4 x [3 x i32]], ptr @reduce.face, i64 0, i64 %230
  %235 = load i32, ptr %234, align 4
  %236 = sext i32 %235 to i64
  %237 = getelementptr inbounds [4 x [3 x double]], ptr %22, i64 0, i64 %236
  %238 = getelementptr inbounds [4 x [3 x i32]], ptr @reduce.face, i64 0, i64 %230, i64 1
  %239 = load i32, ptr %238, align 4
  %240 = sext i32 %239 to i64
  %241 = getelementptr inbounds [4 x [3 x double]], ptr %22, i64 0, i64 %240
  %242 = getelementptr inbounds [4 x [3 x i32]], ptr @reduce.face, i64 0, i64 %230, i64 2
  %243 = load i32, ptr %242, align 4
  %244 = sext i32 %243 to i64
  %245 = getelementptr inbounds [4 x [3 x double]], ptr %22, i64 0, i64 %244
  br i1 %223, label %246, label %311

246:                                              ; preds = %229
  %247 = add i32 %235, %239
  %248 = add i32 %247, %243
  %249 = sub i32 6, %248
  %250 = sext i32 %249 to i64
  %251 = getelementptr inbounds [4 x [3 x double]], ptr %22, i64 0, i64 %250
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %17) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %18) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %19) #15
  br label %277

252:                                              ; preds = %277
  %253 = load double, ptr %60, align 8
  %254 = load double, ptr %61, align 16
  %255 = fmul double %253, %254
  %256 = load double, ptr %62, align 16
  %257 = load double, ptr %63, align 8
  %258 = fmul double %256, %257
  %259 = fsub double %255, %258
  %260 = load double, ptr %18, align 16
  %261 = fmul double %256, %260
  %262 = load double, ptr %17, align 16
  %263 = fmul double %254, %262
  %264 = fsub double %261, %263
  %265 = fmul double %257, %262
  %266 = fmul double %253, %260
  %267 = fsub double %265, %266
  %268 = load double, ptr %19, align 16
  %269 = fmul double %259, %268
  %270 = load double, ptr %64, align 8
  %271 = fmul double %264, %270
  %272 = fadd double %269, %271
  %273 = load double, ptr %65, align 16
  %274 = fmul double %267, %273
  %275 = fadd double %272, %274
  %276 = fcmp oeq double %275, 0.000000e+00
  br i1 %276, label %309, label %295

277:                                              ; preds = %277, %246
  %278 = phi i64 [ 0, %246 ], [ %293, %277 ]
  %279 = getelementptr inbounds double, ptr %241, i64 %278
  %280 = load double, ptr %279, align 8
  %281 = getelementptr inbounds double, ptr %237, i64 %278
  %282 = load double, ptr %281, align 8
  %283 = fsub double %280, %282
  %284 = getelementptr inbounds [3 x double], ptr %17, i64 0, i64 %278
  store double %283, ptr %284, align 8
  %285 = getelementptr inbounds double, ptr %245, i64 %278
  %286 = load double, ptr %285, align 8
  %287 = fsub double %286, %282
  %288 = getelementptr inbounds [3 x double], ptr %18, i64 0, i64 %278
  store double %287, ptr %288, align 8
  %289 = getelementptr inbounds double, ptr %251, i64 %278
  %290 = load double, ptr %289, align 8
  %291 = fsub double %290, %282
  %292 = getelementptr inbounds [3 x double], ptr %19, i64 0, i64 %278
  store double %291, ptr %292, align 8
  %293 = add nuw nsw i64 %278, 1
  %294 = icmp eq i64 %293, 3
  br i1 %294, label %252, label %277

295:                                              ; preds = %252
  %296 = load double, ptr %237, align 8
  %297 = fmul double %259, %296
  %298 = getelementptr inbounds double, ptr %237, i64 1
  %299 = load double, ptr %298, align 8
  %300 = fmul double %264, %299
  %301 = fadd double %297, %300
  %302 = getelementptr inbounds double, ptr %237, i64 2
  %303 = load double, ptr %302, align 8
  %304 = fmul double %267, %303
  %305 = fadd double %301, %304
  %306 = fneg double %305
  %307 = fmul double %275, %306
  %308 = fcmp ult double %307, 0.000000e+00
  br i1 %308, label %309, label %310

309:                                              ; preds = %295, %252
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %19) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %18) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %17) #15
  br label %311

310:                                              ; preds = %295
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %19) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %18) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %17) #15
  br label %505

311:                                              ; preds = %309, %229
  %312 = phi i32 [ %233, %229 ], [ 0, %309 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %20) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %10) #15
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %11) #15
  br label %370

313:                                              ; preds = %370
  %314 = load double, ptr %10, align 16
  %315 = load double, ptr %237, align 8
  %316 = fmul double %314, %315
  %317 = load double, ptr %66, align 8
  %318 = getelementptr inbounds double, ptr %237, i64 1
  %319 = load double, ptr %318, align 8
  %320 = fmul double %317, %319
  %321 = fadd double %316, %320
  %322 = load double, ptr %67, align 16
  %323 = getelementptr inbounds double, ptr %237, i64 2
  %324 = load double, ptr %323, align 8
  %325 = fmul double %322, %324
  %326 = fadd double %321, %325
  %327 = fneg double %326
  %328 = load double, ptr %11, align 16
  %329 = fmul double %315, %328
  %330 = load double, ptr %68, align 8
  %331 = fmul double %319, %330
  %332 = fadd double %329, %331
  %333 = load double, ptr %69, align 16
  %334 = fmul double %324, %333
  %335 = fadd double %332, %334
  %336 = fneg double %335
  %337 = load double, ptr %241, align 8
  %338 = fmul double %314, %337
  %339 = getelementptr inbounds double, ptr %241, i64 1
  %340 = load double, ptr %339, align 8
  %341 = fmul double %317, %340
  %342 = fadd double %338, %341
  %343 = getelementptr inbounds double, ptr %241, i64 2
  %344 = load double, ptr %343, align 8
  %345 = fmul double %322, %344
  %346 = fadd double %342, %345
  %347 = fmul double %328, %337
  %348 = fmul double %330, %340
  %349 = fadd double %347, %348
  %350 = fmul double %333, %344
  %351 = fadd double %349, %350
  %352 = load double, ptr %245, align 8
  %353 = fmul double %314, %352
  %354 = getelementptr inbounds double, ptr %245, i64 1
  %355 = load double, ptr %354, align 8
  %356 = fmul double %317, %355
  %357 = fadd double %353, %356
  %358 = getelementptr inbounds double, ptr %245, i64 2
  %359 = load double, ptr %358, align 8
  %360 = fmul double %322, %359
  %361 = fadd double %357, %360
  %362 = fmul double %328, %352
  %363 = fmul double %330, %355
  %364 = fadd double %362, %363
  %365 = fmul double %333, %359
  %366 = fadd double %364, %365
  %367 = fcmp oge double %326, 0.000000e+00
  %368 = fcmp oge double %335, 0.000000e+00
  %369 = select i1 %367, i1 %368, i1 false
  br i1 %369, label %487, label %384

370:                                              ; preds = %370, %311
  %371 = phi i64 [ 0, %311 ], [ %382, %370 ]
  %372 = getelementptr inbounds double, ptr %241, i64 %371
  %373 = load double, ptr %372, align 8
  %374 = getelementptr inbounds double, ptr %237, i64 %371
  %375 = load double, ptr %374, align 8
  %376 = fsub double %373, %375
  %377 = getelementptr inbounds [3 x double], ptr %10, i64 0, i64 %371
  store double %376, ptr %377, align 8
  %378 = getelementptr inbounds double, ptr %245, i64 %371
  %379 = load double, ptr %378, align 8
  %380 = fsub double %379, %375
  %381 = getelementptr inbounds [3 x double], ptr %11, i64 0, i64 %371
  store double %380, ptr %381, align 8
  %382 = add nuw nsw i64 %371, 1
  %383 = icmp eq i64 %382, 3
  br i1 %383, label %313, label %370

384:                                              ; preds = %313
  %385 = fcmp ugt double %346, 0.000000e+00
  %386 = fcmp ult double %351, %346
  %387 = select i1 %385, i1 true, i1 %386
  br i1 %387, label %388, label %487

388:                                              ; preds = %384
  %389 = fcmp ugt double %366, 0.000000e+00
  %390 = fcmp ult double %361, %366
  %391 = select i1 %389, i1 true, i1 %390
  br i1 %391, label %392, label %487

392:                                              ; preds = %388
  %393 = fmul double %326, %351
  %394 = fmul double %335, %346
  %395 = fsub double %393, %394
  %396 = fcmp ole double %395, 0.000000e+00
  %397 = fcmp ole double %326, 0.000000e+00
  %398 = select i1 %396, i1 %397, i1 false
  %399 = fcmp oge double %346, 0.000000e+00
  %400 = select i1 %398, i1 %399, i1 false
  br i1 %400, label %401, label %416

401:                                              ; preds = %392
  %402 = fsub double %346, %326
  %403 = fdiv double %327, %402
  br label %404

404:                                              ; preds = %404, %401
  %405 = phi i64 [ 0, %401 ], [ %414, %404 ]
  %406 = getelementptr inbounds double, ptr %237, i64 %405
  %407 = load double, ptr %406, align 8
  %408 = getelementptr inbounds double, ptr %241, i64 %405
  %409 = load double, ptr %408, align 8
  %410 = fsub double %409, %407
  %411 = fmul double %403, %410
  %412 = fadd double %407, %411
  %413 = getelementptr inbounds double, ptr %20, i64 %405
  store double %412, ptr %413, align 8
  %414 = add nuw nsw i64 %405, 1
  %415 = icmp eq i64 %414, 3
  br i1 %415, label %490, label %404

416:                                              ; preds = %392
  %417 = fmul double %335, %361
  %418 = fmul double %326, %366
  %419 = fsub double %417, %418
  %420 = fcmp ole double %419, 0.000000e+00
  %421 = fcmp ole double %335, 0.000000e+00
  %422 = select i1 %420, i1 %421, i1 false
  %423 = fcmp oge double %366, 0.000000e+00
  %424 = select i1 %422, i1 %423, i1 false
  br i1 %424, label %425, label %440

425:                                              ; preds = %416
  %426 = fsub double %366, %335
  %427 = fdiv double %336, %426
  br label %428

428:                                              ; preds = %428, %425
  %429 = phi i64 [ 0, %425 ], [ %438, %428 ]
  %430 = getelementptr inbounds double, ptr %237, i64 %429
  %431 = load double, ptr %430, align 8
  %432 = getelementptr inbounds double, ptr %245, i64 %429
  %433 = load double, ptr %432, align 8
  %434 = fsub double %433, %431
  %435 = fmul double %427, %434
  %436 = fadd double %431, %435
  %437 = getelementptr inbounds double, ptr %20, i64 %429
  store double %436, ptr %437, align 8
  %438 = add nuw nsw i64 %429, 1
  %439 = icmp eq i64 %438, 3
  br i1 %439, label %490, label %428

440:                                              ; preds = %416
  %441 = fmul double %346, %366
  %442 = fmul double %351, %361
  %443 = fsub double %441, %442
  %444 = fcmp ugt double %443, 0.000000e+00
  br i1 %444, label %467, label %445

445:                                              ; preds = %440
  %446 = fsub double %346, %351
  %447 = fcmp ult double %446, 0.000000e+00
  %448 = fsub double %366, %361
  %449 = fcmp ult double %448, 0.000000e+00
  %450 = select i1 %447, i1 true, i1 %449
  br i1 %450, label %467, label %451

451:                                              ; preds = %445
  %452 = fsub double %446, %361
  %453 = fadd double %366, %452
  %454 = fdiv double %446, %453
  br label %455

455:                                              ; preds = %455, %451
  %456 = phi i64 [ 0, %451 ], [ %465, %455 ]
  %457 = getelementptr inbounds double, ptr %241, i64 %456
  %458 = load double, ptr %457, align 8
  %459 = getelementptr inbounds double, ptr %245, i64 %456
  %460 = load double, ptr %459, align 8
  %461 = fsub double %460, %458
  %462 = fmul double %454, %461
  %463 = fadd double %458, %462
  %464 = getelementptr inbounds double, ptr %20, i64 %456
  store double %463, ptr %464, align 8
  %465 = add nuw nsw i64 %456, 1
  %466 = icmp eq i64 %465, 3
  br i1 %466, label %490, label %455

467:                                              ; preds = %445, %440
  %468 = fadd double %443, %419
  %469 = fadd double %395, %468
  %470 = fdiv double %419, %469
  %471 = fdiv double %395, %469
  br label %472

472:                                              ; preds = %472, %467
  %473 = phi i64 [ 0, %467 ], [ %485, %472 ]
  %474 = getelementptr inbounds double, ptr %237, i64 %473
  %475 = load double, ptr %474, align 8
  %476 = getelementptr inbounds [3 x double], ptr %10, i64 0, i64 %473
  %477 = load double, ptr %476, align 8
  %478 = fmul double %470, %477
  %479 = fadd double %475, %478
  %480 = getelementptr inbounds [3 x double], ptr %11, i64 0, i64 %473
  %481 = load double, ptr %480, align 8
  %482 = fmul double %471, %481
  %483 = fadd double %479, %482
  %484 = getelementptr inbounds double, ptr %20, i64 %473
  store double %483, ptr %484, align 8
  %485 = add nuw nsw i64 %473, 1
  %486 = icmp eq i64 %485, 3
  br i1 %486, label %490, label %472

487:                                              ; preds = %388, %384, %313
  %488 = phi ptr [ %237, %313 ], [ %241, %384 ], [ %245, %388 ]
  %489 = phi i32 [ 1, %313 ], [ 2, %384 ], [ 4, %388 ]
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %20, ptr noundef nonnull align 8 dereferenceable(24) %488, i64 24, i1 false)
  br label %490

490:                                              ; preds = %455, %472, %428, %404, %487
  %491 = phi i32 [ %489, %487 ], [ 3, %404 ], [ 5, %428 ], [ 7, %472 ], [ 6, %455 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %11) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %10) #15
  %492 = load double, ptr %20, align 16
  %493 = fmul double %492, %492
  %494 = load double, ptr %70, align 8
  %495 = fmul double %494, %494
  %496 = fadd double %493, %495
  %497 = load double, ptr %71, align 16
  %498 = fmul double %497, %497
  %499 = fadd double %496, %498
  %500 = fcmp olt double %499, %231
  br i1 %500, label %501, label %502

501:                                              ; preds = %490
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %15, ptr noundef nonnull align 16 dereferenceable(24) %20, i64 24, i1 false)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 4 dereferenceable(12) %16, ptr noundef nonnull align 4 dereferenceable(12) %234, i64 12, i1 false)
  br label %502

502:                                              ; preds = %501, %490
  %503 = phi i32 [ %491, %501 ], [ %232, %490 ]
  %504 = phi double [ %499, %501 ], [ %231, %490 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %20) #15
  br label %505

505:                                              ; preds = %502, %310
  %506 = phi i32 [ %312, %502 ], [ %233, %310 ]
  %507 = phi i32 [ %503, %502 ], [ %232, %310 ]
  %508 = phi double [ %504, %502 ], [ %231, %310 ]
  %509 = add nuw nsw i64 %230, 1
  %510 = icmp ult i64 %230, 3
  %511 = select i1 %225, i1 %510, i1 false
  br i1 %511, label %229, label %226

512:                                              ; preds = %226
  %513 = fcmp oeq double %508, 0x7FF0000000000000
  br i1 %513, label %546, label %514

514:                                              ; preds = %512
  call void @llvm.lifetime.start.p0(i64 12, ptr nonnull %21) #15
  br label %529

515:                                              ; preds = %542
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %9) #15
  %516 = icmp sgt i32 %543, 0
  br i1 %516, label %517, label %528

517:                                              ; preds = %515
  %518 = zext i32 %543 to i64
  br label %519

519:                                              ; preds = %519, %517
  %520 = phi i64 [ 0, %517 ], [ %526, %519 ]
  %521 = getelementptr inbounds [4 x [3 x double]], ptr %9, i64 0, i64 %520
  %522 = getelementptr inbounds i32, ptr %21, i64 %520
  %523 = load i32, ptr %522, align 4
  %524 = sext i32 %523 to i64
  %525 = getelementptr inbounds [4 x [3 x double]], ptr %22, i64 0, i64 %524
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %521, ptr noundef nonnull align 8 dereferenceable(24) %525, i64 24, i1 false)
  %526 = add nuw nsw i64 %520, 1
  %527 = icmp eq i64 %526, %518
  br i1 %527, label %528, label %519

528:                                              ; preds = %519, %515
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(96) %22, ptr noundef nonnull align 16 dereferenceable(96) %9, i64 96, i1 false)
  store i32 %543, ptr %41, align 8
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %9) #15
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %59, ptr noundef nonnull align 16 dereferenceable(24) %15, i64 24, i1 false)
  call void @llvm.lifetime.end.p0(i64 12, ptr nonnull %21) #15
  br label %546

529:                                              ; preds = %542, %514
  %530 = phi i64 [ 0, %514 ], [ %544, %542 ]
  %531 = phi i32 [ 0, %514 ], [ %543, %542 ]
  %532 = trunc i64 %530 to i32
  %533 = shl nuw nsw i32 1, %532
  %534 = and i32 %533, %507
  %535 = icmp eq i32 %534, 0
  br i1 %535, label %542, label %536

536:                                              ; preds = %529
  %537 = getelementptr inbounds [3 x i32], ptr %16, i64 0, i64 %530
  %538 = load i32, ptr %537, align 4
  %539 = add nsw i32 %531, 1
  %540 = sext i32 %531 to i64
  %541 = getelementptr inbounds [3 x i32], ptr %21, i64 0, i64 %540
  store i32 %538, ptr %541, align 4
  br label %542

542:                                              ; preds = %536, %529
  %543 = phi i32 [ %539, %536 ], [ %531, %529 ]
  %544 = add nuw nsw i64 %530, 1
  %545 = icmp eq i64 %544, 3
  br i1 %545, label %515, label %529

546:                                              ; preds = %528, %512
  %547 = phi i32 [ %543, %528 ], [ %168, %512 ]
  call void @llvm.lifetime.end.p0(i64 12, ptr nonnull %16) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %15)
  br label %551

548:                                              ; preds = %226
  call void @llvm.lifetime.end.p0(i64 12, ptr nonnull %16) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %15)
  %549 = fcmp ogt double %146, 1.000000e-10
  %550 = zext i1 %549 to i32
  br label %575

551:                                              ; preds = %220, %169, %546
  %552 = phi i32 [ %221, %220 ], [ 1, %169 ], [ %547, %546 ]
  %553 = load double, ptr %59, align 8
  %554 = fmul double %553, %553
  %555 = load double, ptr %72, align 8
  %556 = fmul double %555, %555
  %557 = fadd double %554, %556
  %558 = load double, ptr %73, align 8
  %559 = fmul double %558, %558
  %560 = fadd double %557, %559
  %561 = tail call double @llvm.sqrt.f64(double %560)
  %562 = fcmp oge double %561, %149
  %563 = icmp ne i32 %90, 0
  %564 = select i1 %562, i1 %563, i1 false
  br i1 %564, label %575, label %565

565:                                              ; preds = %551
  store double %561, ptr %6, align 8
  %566 = fcmp ugt double %561, 1.000000e-10
  br i1 %566, label %567, label %575

567:                                              ; preds = %565
  %568 = fcmp ugt double %561, %4
  br i1 %568, label %569, label %575

569:                                              ; preds = %567
  %570 = load double, ptr %5, align 8
  %571 = fsub double %561, %570
  %572 = fcmp ugt double %571, 0x3DA5FD7FE1796495
  br i1 %572, label %573, label %575

573:                                              ; preds = %569
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(24) %23, ptr noundef nonnull align 8 dereferenceable(24) %59, i64 24, i1 false)
  %574 = icmp eq i32 %552, 4
  br i1 %574, label %575, label %577

575:                                              ; preds = %148, %145, %551, %565, %569, %567, %573, %159, %548
  %576 = phi i32 [ %550, %548 ], [ 1, %159 ], [ 1, %573 ], [ 1, %148 ], [ 1, %145 ], [ 1, %551 ], [ 0, %565 ], [ 1, %569 ], [ 1, %567 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %27) #15
  br label %580

577:                                              ; preds = %573
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %27) #15
  %578 = add nuw nsw i32 %90, 1
  %579 = icmp eq i32 %578, 300
  br i1 %579, label %580, label %88

580:                                              ; preds = %577, %575
  %581 = phi i32 [ %576, %575 ], [ 1, %577 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %26) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %25) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %24) #15
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %23) #15
  call void @llvm.lifetime.end.p0(i64 128, ptr nonnull %22) #15
  ret i32 %581
}

define internal fastcc i32 @leaves(ptr noundef %0, i64 noundef %1, ptr noundef %2, ptr noundef %3) unnamed_addr #8 {
  %5 = alloca [3 x double], align 16
  %6 = alloca [3 x double], align 16
  %7 = alloca [3 x double], align 16
  %8 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 27
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 28
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
  %56 = getelementptr inbounds %struct.World, ptr %0, i64 0, i32 30
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

declare i32 @bcmp(ptr nocapture, ptr nocapture, i64) local_unnamed_addr #12

declare i64 @llvm.smin.i64(i64, i64) #13

declare i64 @llvm.smax.i64(i64, i64) #13

attributes #0 = { nofree nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { nofree norecurse nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #5 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #6 = { nofree nosync nounwind memory(argmem: readwrite) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #7 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #8 = { nofree nosync nounwind memory(read, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #9 = { mustprogress nofree nosync nounwind willreturn memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #10 = { nofree nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #11 = { nofree nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #12 = { nofree nounwind willreturn memory(argmem: read) }
attributes #13 = { nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #14 = { memory(none) }
attributes #15 = { nounwind }


