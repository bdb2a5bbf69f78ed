; steps.c 27b551f15c29b28e9f93e6e98a82850f9f205ac4c83acfb8221c8e8627229763: written by make kernel

define dso_local void @manipplan_points(i64 noundef %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, ptr nocapture noundef readonly %5, ptr nocapture noundef %6) local_unnamed_addr #0 {
  %8 = shl i64 %0, 3
  %9 = mul i64 %8, %1
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %6, ptr align 8 %3, i64 %9, i1 false)
  %10 = icmp sgt i64 %0, 0
  br i1 %10, label %11, label %18

11:                                               ; preds = %7
  %12 = icmp sgt i64 %2, 0
  %13 = icmp sgt i64 %1, 0
  br label %14

14:                                               ; preds = %11, %24
  %15 = phi i64 [ 0, %11 ], [ %25, %24 ]
  %16 = phi ptr [ %6, %11 ], [ %26, %24 ]
  %17 = phi ptr [ %4, %11 ], [ %27, %24 ]
  br i1 %12, label %19, label %24

18:                                               ; preds = %24, %7
  ret void

19:                                               ; preds = %14, %29
  %20 = phi i64 [ %30, %29 ], [ 0, %14 ]
  br i1 %13, label %21, label %29

21:                                               ; preds = %19
  %22 = getelementptr inbounds double, ptr %17, i64 %20
  %23 = mul nsw i64 %20, %1
  br label %32

24:                                               ; preds = %29, %14
  %25 = add nuw nsw i64 %15, 1
  %26 = getelementptr inbounds double, ptr %16, i64 %1
  %27 = getelementptr inbounds double, ptr %17, i64 %2
  %28 = icmp eq i64 %25, %0
  br i1 %28, label %18, label %14

29:                                               ; preds = %32, %19
  %30 = add nuw nsw i64 %20, 1
  %31 = icmp eq i64 %30, %2
  br i1 %31, label %24, label %19

32:                                               ; preds = %21, %32
  %33 = phi i64 [ 0, %21 ], [ %42, %32 ]
  %34 = load double, ptr %22, align 8
  %35 = add nsw i64 %33, %23
  %36 = getelementptr inbounds double, ptr %5, i64 %35
  %37 = load double, ptr %36, align 8
  %38 = fmul double %34, %37
  %39 = getelementptr inbounds double, ptr %16, i64 %33
  %40 = load double, ptr %39, align 8
  %41 = fadd double %40, %38
  store double %41, ptr %39, align 8
  %42 = add nuw nsw i64 %33, 1
  %43 = icmp eq i64 %42, %1
  br i1 %43, label %29, label %32
}

declare void @llvm.memcpy.p0.p0.i64(ptr noalias nocapture writeonly, ptr noalias nocapture readonly, i64, i1 immarg) #1

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #2

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #2

define dso_local void @manipplan_gradient(i64 noundef %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, ptr nocapture noundef readonly %5, ptr nocapture noundef readonly %6, ptr nocapture noundef %7) local_unnamed_addr #0 {
  %9 = shl i64 %1, 3
  %10 = mul i64 %9, %2
  tail call void @llvm.memset.p0.i64(ptr align 8 %7, i8 0, i64 %10, i1 false)
  %11 = icmp sgt i64 %0, 0
  br i1 %11, label %12, label %16

12:                                               ; preds = %8
  %13 = shl i64 %1, 1
  %14 = icmp sgt i64 %2, 0
  %15 = icmp sgt i64 %1, 0
  br label %17

16:                                               ; preds = %54, %8
  ret void

17:                                               ; preds = %12, %54
  %18 = phi i64 [ 0, %12 ], [ %55, %54 ]
  %19 = getelementptr inbounds double, ptr %3, i64 %18
  %20 = load double, ptr %19, align 8
  %21 = mul nsw i64 %18, %2
  %22 = getelementptr inbounds double, ptr %4, i64 %21
  %23 = getelementptr inbounds double, ptr %5, i64 %21
  %24 = mul i64 %13, %18
  %25 = getelementptr inbounds double, ptr %6, i64 %24
  br i1 %14, label %26, label %54

26:                                               ; preds = %17, %35
  %27 = phi ptr [ %37, %35 ], [ %7, %17 ]
  %28 = phi i64 [ %36, %35 ], [ 0, %17 ]
  %29 = getelementptr inbounds double, ptr %22, i64 %28
  %30 = load double, ptr %29, align 8
  %31 = fmul double %20, %30
  %32 = getelementptr inbounds double, ptr %23, i64 %28
  %33 = load double, ptr %32, align 8
  %34 = fmul double %20, %33
  br i1 %15, label %39, label %35

35:                                               ; preds = %39, %26
  %36 = add nuw nsw i64 %28, 1
  %37 = getelementptr inbounds double, ptr %27, i64 %1
  %38 = icmp eq i64 %36, %2
  br i1 %38, label %54, label %26

39:                                               ; preds = %26, %39
  %40 = phi i64 [ %52, %39 ], [ 0, %26 ]
  %41 = getelementptr inbounds double, ptr %25, i64 %40
  %42 = load double, ptr %41, align 8
  %43 = fmul double %31, %42
  %44 = add nsw i64 %40, %1
  %45 = getelementptr inbounds double, ptr %25, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = fmul double %34, %46
  %48 = fadd double %43, %47
  %49 = getelementptr inbounds double, ptr %27, i64 %40
  %50 = load double, ptr %49, align 8
  %51 = fadd double %50, %48
  store double %51, ptr %49, align 8
  %52 = add nuw nsw i64 %40, 1
  %53 = icmp eq i64 %52, %1
  br i1 %53, label %35, label %39

54:                                               ; preds = %35, %17
  %55 = add nuw nsw i64 %18, 1
  %56 = icmp eq i64 %55, %0
  br i1 %56, label %16, label %17
}

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #3

define dso_local void @manipplan_derivatives(i64 noundef %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, ptr nocapture noundef readonly %5, ptr nocapture noundef readonly %6, ptr nocapture noundef %7, ptr nocapture noundef %8, ptr nocapture noundef writeonly %9) local_unnamed_addr #0 {
  %11 = mul i64 %1, %1
  %12 = mul i64 %2, %1
  %13 = mul nsw i64 %2, %2
  %14 = mul nsw i64 %13, %11
  %15 = getelementptr inbounds double, ptr %7, i64 %14
  %16 = getelementptr inbounds double, ptr %15, i64 %11
  %17 = getelementptr inbounds double, ptr %16, i64 %11
  %18 = getelementptr inbounds double, ptr %17, i64 %11
  %19 = getelementptr inbounds double, ptr %18, i64 %11
  %20 = getelementptr inbounds double, ptr %19, i64 %11
  %21 = shl i64 %12, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %8, i8 0, i64 %21, i1 false)
  %22 = shl i64 %14, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %7, i8 0, i64 %22, i1 false)
  %23 = icmp sgt i64 %0, 0
  br i1 %23, label %24, label %31

24:                                               ; preds = %10
  %25 = icmp sgt i64 %2, 0
  %26 = icmp sgt i64 %1, 0
  %27 = shl nsw i64 %1, 1
  %28 = icmp eq i64 %1, 0
  %29 = shl nsw i64 %11, 2
  %30 = tail call i64 @llvm.umax.i64(i64 %11, i64 1)
  br label %35

31:                                               ; preds = %113, %10
  %32 = icmp sgt i64 %2, 0
  br i1 %32, label %33, label %180

33:                                               ; preds = %31
  %34 = icmp sgt i64 %1, 0
  br label %176

35:                                               ; preds = %24, %113
  %36 = phi ptr [ %4, %24 ], [ %116, %113 ]
  %37 = phi ptr [ %5, %24 ], [ %117, %113 ]
  %38 = phi ptr [ %6, %24 ], [ %115, %113 ]
  %39 = phi i64 [ 0, %24 ], [ %114, %113 ]
  %40 = getelementptr inbounds double, ptr %3, i64 %39
  %41 = load double, ptr %40, align 8
  br i1 %25, label %42, label %70

42:                                               ; preds = %35, %51
  %43 = phi ptr [ %53, %51 ], [ %8, %35 ]
  %44 = phi i64 [ %52, %51 ], [ 0, %35 ]
  %45 = getelementptr inbounds double, ptr %36, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = fmul double %41, %46
  %48 = getelementptr inbounds double, ptr %37, i64 %44
  %49 = load double, ptr %48, align 8
  %50 = fmul double %41, %49
  br i1 %26, label %55, label %51

51:                                               ; preds = %55, %42
  %52 = add nuw nsw i64 %44, 1
  %53 = getelementptr inbounds double, ptr %43, i64 %1
  %54 = icmp eq i64 %52, %2
  br i1 %54, label %70, label %42

55:                                               ; preds = %42, %55
  %56 = phi i64 [ %68, %55 ], [ 0, %42 ]
  %57 = getelementptr inbounds double, ptr %38, i64 %56
  %58 = load double, ptr %57, align 8
  %59 = fmul double %47, %58
  %60 = add nsw i64 %56, %1
  %61 = getelementptr inbounds double, ptr %38, i64 %60
  %62 = load double, ptr %61, align 8
  %63 = fmul double %50, %62
  %64 = fadd double %59, %63
  %65 = getelementptr inbounds double, ptr %43, i64 %56
  %66 = load double, ptr %65, align 8
  %67 = fadd double %66, %64
  store double %67, ptr %65, align 8
  %68 = add nuw nsw i64 %56, 1
  %69 = icmp eq i64 %68, %1
  br i1 %69, label %51, label %55

70:                                               ; preds = %51, %35
  %71 = getelementptr inbounds double, ptr %38, i64 %27
  br i1 %26, label %73, label %72

72:                                               ; preds = %81, %70
  br i1 %25, label %119, label %113

73:                                               ; preds = %70, %81
  %74 = phi i64 [ %82, %81 ], [ 0, %70 ]
  %75 = shl nuw nsw i64 %74, 1
  %76 = mul nsw i64 %75, %1
  %77 = mul nsw i64 %74, %1
  %78 = add nsw i64 %74, %1
  %79 = shl nsw i64 %78, 1
  %80 = mul nsw i64 %79, %1
  br label %84

81:                                               ; preds = %84
  %82 = add nuw nsw i64 %74, 1
  %83 = icmp eq i64 %82, %1
  br i1 %83, label %72, label %73

84:                                               ; preds = %73, %84
  %85 = phi i64 [ 0, %73 ], [ %111, %84 ]
  %86 = load double, ptr %40, align 8
  %87 = add i64 %85, %76
  %88 = getelementptr inbounds double, ptr %71, i64 %87
  %89 = load double, ptr %88, align 8
  %90 = fmul double %86, %89
  %91 = add nsw i64 %85, %77
  %92 = getelementptr inbounds double, ptr %15, i64 %91
  store double %90, ptr %92, align 8
  %93 = load double, ptr %40, align 8
  %94 = add i64 %87, %1
  %95 = getelementptr inbounds double, ptr %71, i64 %94
  %96 = load double, ptr %95, align 8
  %97 = fmul double %93, %96
  %98 = getelementptr inbounds double, ptr %16, i64 %91
  store double %97, ptr %98, align 8
  %99 = load double, ptr %40, align 8
  %100 = add i64 %85, %80
  %101 = getelementptr inbounds double, ptr %71, i64 %100
  %102 = load double, ptr %101, align 8
  %103 = fmul double %99, %102
  %104 = getelementptr inbounds double, ptr %17, i64 %91
  store double %103, ptr %104, align 8
  %105 = load double, ptr %40, align 8
  %106 = add i64 %100, %1
  %107 = getelementptr inbounds double, ptr %71, i64 %106
  %108 = load double, ptr %107, align 8
  %109 = fmul double %105, %108
  %110 = getelementptr inbounds double, ptr %18, i64 %91
  store double %109, ptr %110, align 8
  %111 = add nuw nsw i64 %85, 1
  %112 = icmp eq i64 %111, %1
  br i1 %112, label %81, label %84

113:                                              ; preds = %147, %72
  %114 = add nuw nsw i64 %39, 1
  %115 = getelementptr inbounds double, ptr %71, i64 %29
  %116 = getelementptr inbounds double, ptr %36, i64 %2
  %117 = getelementptr inbounds double, ptr %37, i64 %2
  %118 = icmp eq i64 %114, %0
  br i1 %118, label %31, label %35

119:                                              ; preds = %72, %147
  %120 = phi i64 [ %148, %147 ], [ 0, %72 ]
  %121 = getelementptr inbounds double, ptr %36, i64 %120
  %122 = load double, ptr %121, align 8
  %123 = getelementptr inbounds double, ptr %37, i64 %120
  %124 = load double, ptr %123, align 8
  br i1 %28, label %125, label %127

125:                                              ; preds = %127, %119
  %126 = mul nsw i64 %120, %2
  br label %150

127:                                              ; preds = %119, %127
  %128 = phi i64 [ %145, %127 ], [ 0, %119 ]
  %129 = getelementptr inbounds double, ptr %15, i64 %128
  %130 = load double, ptr %129, align 8
  %131 = fmul double %122, %130
  %132 = getelementptr inbounds double, ptr %17, i64 %128
  %133 = load double, ptr %132, align 8
  %134 = fmul double %124, %133
  %135 = fadd double %131, %134
  %136 = getelementptr inbounds double, ptr %19, i64 %128
  store double %135, ptr %136, align 8
  %137 = getelementptr inbounds double, ptr %16, i64 %128
  %138 = load double, ptr %137, align 8
  %139 = fmul double %122, %138
  %140 = getelementptr inbounds double, ptr %18, i64 %128
  %141 = load double, ptr %140, align 8
  %142 = fmul double %124, %141
  %143 = fadd double %139, %142
  %144 = getelementptr inbounds double, ptr %20, i64 %128
  store double %143, ptr %144, align 8
  %145 = add nuw nsw i64 %128, 1
  %146 = icmp eq i64 %145, %30
  br i1 %146, label %125, label %127

147:                                              ; preds = %159
  %148 = add nuw nsw i64 %120, 1
  %149 = icmp eq i64 %148, %2
  br i1 %149, label %113, label %119

150:                                              ; preds = %125, %159
  %151 = phi i64 [ %120, %125 ], [ %160, %159 ]
  %152 = add nsw i64 %151, %126
  %153 = mul nsw i64 %152, %11
  %154 = getelementptr inbounds double, ptr %7, i64 %153
  %155 = getelementptr inbounds double, ptr %36, i64 %151
  %156 = load double, ptr %155, align 8
  %157 = getelementptr inbounds double, ptr %37, i64 %151
  %158 = load double, ptr %157, align 8
  br i1 %28, label %159, label %162

159:                                              ; preds = %162, %150
  %160 = add nuw nsw i64 %151, 1
  %161 = icmp slt i64 %160, %2
  br i1 %161, label %150, label %147

162:                                              ; preds = %150, %162
  %163 = phi i64 [ %174, %162 ], [ 0, %150 ]
  %164 = getelementptr inbounds double, ptr %19, i64 %163
  %165 = load double, ptr %164, align 8
  %166 = fmul double %156, %165
  %167 = getelementptr inbounds double, ptr %20, i64 %163
  %168 = load double, ptr %167, align 8
  %169 = fmul double %158, %168
  %170 = fadd double %166, %169
  %171 = getelementptr inbounds double, ptr %154, i64 %163
  %172 = load double, ptr %171, align 8
  %173 = fadd double %172, %170
  store double %173, ptr %171, align 8
  %174 = add nuw nsw i64 %163, 1
  %175 = icmp eq i64 %174, %30
  br i1 %175, label %159, label %162

176:                                              ; preds = %187, %33
  %177 = phi i64 [ 0, %33 ], [ %188, %187 ]
  %178 = mul nsw i64 %177, %2
  %179 = mul nsw i64 %177, %1
  br label %181

180:                                              ; preds = %187, %31
  ret void

181:                                              ; preds = %176, %196
  %182 = phi i64 [ %177, %176 ], [ %197, %196 ]
  br i1 %34, label %183, label %196

183:                                              ; preds = %181
  %184 = add nsw i64 %182, %178
  %185 = mul nsw i64 %184, %11
  %186 = mul nsw i64 %182, %1
  br label %190

187:                                              ; preds = %196
  %188 = add nuw nsw i64 %177, 1
  %189 = icmp eq i64 %188, %2
  br i1 %189, label %180, label %176

190:                                              ; preds = %199, %183
  %191 = phi i64 [ 0, %183 ], [ %200, %199 ]
  %192 = mul nsw i64 %191, %1
  %193 = add nsw i64 %192, %185
  %194 = add i64 %191, %179
  %195 = mul nsw i64 %194, %12
  br label %202

196:                                              ; preds = %199, %181
  %197 = add nuw nsw i64 %182, 1
  %198 = icmp slt i64 %197, %2
  br i1 %198, label %181, label %187

199:                                              ; preds = %202
  %200 = add nuw nsw i64 %191, 1
  %201 = icmp eq i64 %200, %1
  br i1 %201, label %196, label %190

202:                                              ; preds = %190, %202
  %203 = phi i64 [ 0, %190 ], [ %213, %202 ]
  %204 = add nsw i64 %193, %203
  %205 = getelementptr inbounds double, ptr %7, i64 %204
  %206 = load double, ptr %205, align 8
  %207 = add nsw i64 %203, %186
  %208 = mul nsw i64 %207, %12
  %209 = add i64 %194, %208
  %210 = getelementptr inbounds double, ptr %9, i64 %209
  store double %206, ptr %210, align 8
  %211 = add i64 %207, %195
  %212 = getelementptr inbounds double, ptr %9, i64 %211
  store double %206, ptr %212, align 8
  %213 = add nuw nsw i64 %203, 1
  %214 = icmp eq i64 %213, %1
  br i1 %214, label %199, label %202
}

define dso_local double @manipplan_violation(i64 noundef %0, i64 noundef %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4) local_unnamed_addr #4 {
  %6 = icmp sgt i64 %0, 0
  br i1 %6, label %7, label %13

7:                                                ; preds = %5
  %8 = icmp sgt i64 %1, 0
  br label %9

9:                                                ; preds = %7, %15
  %10 = phi ptr [ %2, %7 ], [ %18, %15 ]
  %11 = phi double [ 0.000000e+00, %7 ], [ %16, %15 ]
  %12 = phi i64 [ 0, %7 ], [ %17, %15 ]
  br i1 %8, label %20, label %15

13:                                               ; preds = %15, %5
  %14 = phi double [ 0.000000e+00, %5 ], [ %16, %15 ]
  ret double %14

15:                                               ; preds = %20, %9
  %16 = phi double [ %11, %9 ], [ %34, %20 ]
  %17 = add nuw nsw i64 %12, 1
  %18 = getelementptr inbounds double, ptr %10, i64 %1
  %19 = icmp eq i64 %17, %0
  br i1 %19, label %13, label %9

20:                                               ; preds = %9, %20
  %21 = phi double [ %34, %20 ], [ %11, %9 ]
  %22 = phi i64 [ %35, %20 ], [ 0, %9 ]
  %23 = getelementptr inbounds double, ptr %3, i64 %22
  %24 = load double, ptr %23, align 8
  %25 = getelementptr inbounds double, ptr %10, i64 %22
  %26 = load double, ptr %25, align 8
  %27 = fsub double %24, %26
  %28 = getelementptr inbounds double, ptr %4, i64 %22
  %29 = load double, ptr %28, align 8
  %30 = fsub double %26, %29
  %31 = fcmp ogt double %27, %21
  %32 = select i1 %31, double %27, double %21
  %33 = fcmp ogt double %30, %32
  %34 = select i1 %33, double %30, double %32
  %35 = add nuw nsw i64 %22, 1
  %36 = icmp eq i64 %35, %1
  br i1 %36, label %15, label %20
}

define dso_local i64 @manipplan_limits(i64 noundef %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, ptr nocapture noundef readonly %5, ptr nocapture noundef readonly %6, ptr nocapture noundef readonly %7, ptr nocapture noundef writeonly %8, ptr nocapture noundef writeonly %9) local_unnamed_addr #5 {
  %11 = icmp sgt i64 %0, 0
  %12 = icmp sgt i64 %1, 0
  %13 = mul i64 %2, %1
  %14 = shl i64 %13, 3
  %15 = icmp sgt i64 %2, 0
  br label %16

16:                                               ; preds = %10, %30
  %17 = phi i64 [ 0, %10 ], [ %31, %30 ]
  %18 = phi i32 [ 1, %10 ], [ %32, %30 ]
  br i1 %11, label %19, label %30

19:                                               ; preds = %16
  %20 = icmp sgt i32 %18, 0
  %21 = sitofp i32 %18 to double
  br label %23

22:                                               ; preds = %30
  ret i64 %31

23:                                               ; preds = %19, %34
  %24 = phi i64 [ %17, %19 ], [ %35, %34 ]
  %25 = phi i64 [ 0, %19 ], [ %36, %34 ]
  br i1 %12, label %26, label %34

26:                                               ; preds = %23
  %27 = mul nsw i64 %25, %1
  %28 = getelementptr inbounds double, ptr %7, i64 %25
  %29 = mul nsw i64 %25, %2
  br label %38

30:                                               ; preds = %34, %16
  %31 = phi i64 [ %17, %16 ], [ %35, %34 ]
  %32 = add nsw i32 %18, -2
  %33 = icmp sgt i32 %18, 0
  br i1 %33, label %16, label %22

34:                                               ; preds = %71, %23
  %35 = phi i64 [ %24, %23 ], [ %72, %71 ]
  %36 = add nuw nsw i64 %25, 1
  %37 = icmp eq i64 %36, %0
  br i1 %37, label %30, label %23

38:                                               ; preds = %26, %71
  %39 = phi i64 [ %24, %26 ], [ %72, %71 ]
  %40 = phi i64 [ 0, %26 ], [ %73, %71 ]
  %41 = getelementptr inbounds double, ptr %6, i64 %40
  %42 = add nsw i64 %40, %27
  %43 = getelementptr inbounds double, ptr %3, i64 %42
  %44 = add nsw i64 %40, %27
  %45 = getelementptr inbounds double, ptr %3, i64 %44
  %46 = getelementptr inbounds double, ptr %5, i64 %40
  %47 = select i1 %20, ptr %46, ptr %43
  %48 = select i1 %20, ptr %45, ptr %41
  %49 = load double, ptr %48, align 8
  %50 = load double, ptr %47, align 8
  %51 = fsub double %49, %50
  %52 = load double, ptr %28, align 8
  %53 = fcmp olt double %51, %52
  br i1 %53, label %54, label %71

54:                                               ; preds = %38
  %55 = mul i64 %13, %39
  %56 = getelementptr inbounds double, ptr %9, i64 %55
  tail call void @llvm.memset.p0.i64(ptr align 8 %56, i8 0, i64 %14, i1 false)
  br i1 %15, label %60, label %57

57:                                               ; preds = %60, %54
  %58 = add nsw i64 %39, 1
  %59 = getelementptr inbounds double, ptr %8, i64 %39
  store double %51, ptr %59, align 8
  br label %71

60:                                               ; preds = %54, %60
  %61 = phi i64 [ %69, %60 ], [ 0, %54 ]
  %62 = add nsw i64 %61, %29
  %63 = getelementptr inbounds double, ptr %4, i64 %62
  %64 = load double, ptr %63, align 8
  %65 = fmul double %64, %21
  %66 = mul nsw i64 %61, %1
  %67 = add nsw i64 %66, %40
  %68 = getelementptr inbounds double, ptr %56, i64 %67
  store double %65, ptr %68, align 8
  %69 = add nuw nsw i64 %61, 1
  %70 = icmp eq i64 %69, %2
  br i1 %70, label %57, label %60

71:                                               ; preds = %38, %57
  %72 = phi i64 [ %58, %57 ], [ %39, %38 ]
  %73 = add nuw nsw i64 %40, 1
  %74 = icmp eq i64 %73, %1
  br i1 %74, label %34, label %38
}

define dso_local void @manipplan_curvature(i64 noundef %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, ptr nocapture noundef readonly %5, ptr nocapture noundef readonly %6, ptr nocapture noundef readonly %7, ptr nocapture noundef readonly %8, ptr nocapture noundef readonly %9, ptr nocapture noundef readonly %10, double noundef %11, ptr nocapture noundef %12, ptr nocapture noundef %13) local_unnamed_addr #6 {
  %15 = mul i64 %2, %1
  %16 = icmp sgt i64 %0, 0
  br i1 %16, label %17, label %32

17:                                               ; preds = %14
  %18 = icmp sgt i64 %2, 0
  %19 = icmp sgt i64 %1, 0
  %20 = icmp sgt i64 %15, 0
  %21 = mul nsw i64 %1, %1
  br label %22

22:                                               ; preds = %17, %151
  %23 = phi ptr [ %4, %17 ], [ %153, %151 ]
  %24 = phi ptr [ %5, %17 ], [ %154, %151 ]
  %25 = phi ptr [ %6, %17 ], [ %155, %151 ]
  %26 = phi i64 [ 0, %17 ], [ %152, %151 ]
  %27 = phi ptr [ %7, %17 ], [ %156, %151 ]
  %28 = phi ptr [ %8, %17 ], [ %157, %151 ]
  %29 = phi ptr [ %9, %17 ], [ %158, %151 ]
  br i1 %18, label %30, label %38

30:                                               ; preds = %22
  %31 = getelementptr inbounds double, ptr %3, i64 %26
  br label %33

32:                                               ; preds = %151, %14
  ret void

33:                                               ; preds = %30, %49
  %34 = phi i64 [ 0, %30 ], [ %50, %49 ]
  br i1 %19, label %35, label %49

35:                                               ; preds = %33
  %36 = getelementptr inbounds double, ptr %23, i64 %34
  %37 = mul nsw i64 %34, %1
  br label %43

38:                                               ; preds = %49, %22
  %39 = getelementptr inbounds i8, ptr %10, i64 %26
  %40 = load i8, ptr %39, align 1
  %41 = icmp eq i8 %40, 0
  br i1 %41, label %151, label %42

42:                                               ; preds = %38
  br i1 %19, label %79, label %83

43:                                               ; preds = %52, %35
  %44 = phi i64 [ 0, %35 ], [ %53, %52 ]
  %45 = add nsw i64 %44, %37
  %46 = mul nsw i64 %45, %15
  %47 = getelementptr inbounds double, ptr %13, i64 %46
  %48 = mul nsw i64 %44, %1
  br label %55

49:                                               ; preds = %52, %33
  %50 = add nuw nsw i64 %34, 1
  %51 = icmp eq i64 %50, %2
  br i1 %51, label %38, label %33

52:                                               ; preds = %65
  %53 = add nuw nsw i64 %44, 1
  %54 = icmp eq i64 %53, %1
  br i1 %54, label %49, label %43

55:                                               ; preds = %65, %43
  %56 = phi i64 [ 0, %43 ], [ %66, %65 ]
  %57 = load double, ptr %31, align 8
  %58 = load double, ptr %36, align 8
  %59 = fmul double %57, %58
  %60 = getelementptr inbounds double, ptr %23, i64 %56
  %61 = load double, ptr %60, align 8
  %62 = fmul double %59, %61
  %63 = mul nsw i64 %56, %1
  %64 = getelementptr inbounds double, ptr %47, i64 %63
  br label %68

65:                                               ; preds = %68
  %66 = add nuw nsw i64 %56, 1
  %67 = icmp eq i64 %66, %2
  br i1 %67, label %52, label %55

68:                                               ; preds = %55, %68
  %69 = phi i64 [ %77, %68 ], [ 0, %55 ]
  %70 = add nsw i64 %69, %48
  %71 = getelementptr inbounds double, ptr %29, i64 %70
  %72 = load double, ptr %71, align 8
  %73 = fmul double %62, %72
  %74 = getelementptr inbounds double, ptr %64, i64 %69
  %75 = load double, ptr %74, align 8
  %76 = fadd double %75, %73
  store double %76, ptr %74, align 8
  %77 = add nuw nsw i64 %69, 1
  %78 = icmp eq i64 %77, %1
  br i1 %78, label %65, label %68

79:                                               ; preds = %42, %109
  %80 = phi i64 [ %110, %109 ], [ 0, %42 ]
  %81 = phi double [ %96, %109 ], [ 0.000000e+00, %42 ]
  %82 = mul nsw i64 %80, %1
  br label %97

83:                                               ; preds = %109, %42
  %84 = phi double [ 0.000000e+00, %42 ], [ %96, %109 ]
  %85 = fcmp ogt double %84, %11
  br i1 %85, label %127, label %151

86:                                               ; preds = %97
  %87 = getelementptr inbounds double, ptr %25, i64 %80
  %88 = load double, ptr %87, align 8
  %89 = fmul double %106, %88
  %90 = getelementptr inbounds double, ptr %28, i64 %80
  %91 = load double, ptr %90, align 8
  %92 = getelementptr inbounds double, ptr %27, i64 %80
  %93 = load double, ptr %92, align 8
  %94 = fmul double %91, %93
  %95 = fadd double %89, %94
  %96 = fadd double %81, %95
  br i1 %18, label %112, label %109

97:                                               ; preds = %79, %97
  %98 = phi i64 [ 0, %79 ], [ %107, %97 ]
  %99 = phi double [ 0.000000e+00, %79 ], [ %106, %97 ]
  %100 = add nsw i64 %98, %82
  %101 = getelementptr inbounds double, ptr %29, i64 %100
  %102 = load double, ptr %101, align 8
  %103 = getelementptr inbounds double, ptr %25, i64 %98
  %104 = load double, ptr %103, align 8
  %105 = fmul double %102, %104
  %106 = fadd double %99, %105
  %107 = add nuw nsw i64 %98, 1
  %108 = icmp eq i64 %107, %1
  br i1 %108, label %86, label %97

109:                                              ; preds = %112, %86
  %110 = add nuw nsw i64 %80, 1
  %111 = icmp eq i64 %110, %1
  br i1 %111, label %83, label %79

112:                                              ; preds = %86, %112
  %113 = phi i64 [ %125, %112 ], [ 0, %86 ]
  %114 = getelementptr inbounds double, ptr %24, i64 %113
  %115 = load double, ptr %114, align 8
  %116 = load double, ptr %90, align 8
  %117 = fmul double %115, %116
  %118 = getelementptr inbounds double, ptr %23, i64 %113
  %119 = load double, ptr %118, align 8
  %120 = fmul double %106, %119
  %121 = fadd double %117, %120
  %122 = mul nsw i64 %113, %1
  %123 = add nsw i64 %122, %80
  %124 = getelementptr inbounds double, ptr %12, i64 %123
  store double %121, ptr %124, align 8
  %125 = add nuw nsw i64 %113, 1
  %126 = icmp eq i64 %125, %2
  br i1 %126, label %109, label %112

127:                                              ; preds = %83
  %128 = getelementptr inbounds double, ptr %3, i64 %26
  %129 = load double, ptr %128, align 8
  %130 = fdiv double %129, %84
  br i1 %20, label %131, label %151

131:                                              ; preds = %127, %135
  %132 = phi i64 [ %136, %135 ], [ 0, %127 ]
  %133 = getelementptr inbounds double, ptr %12, i64 %132
  %134 = mul nsw i64 %132, %15
  br label %138

135:                                              ; preds = %138
  %136 = add nuw nsw i64 %132, 1
  %137 = icmp eq i64 %136, %15
  br i1 %137, label %151, label %131

138:                                              ; preds = %131, %138
  %139 = phi i64 [ 0, %131 ], [ %149, %138 ]
  %140 = load double, ptr %133, align 8
  %141 = fmul double %130, %140
  %142 = getelementptr inbounds double, ptr %12, i64 %139
  %143 = load double, ptr %142, align 8
  %144 = fmul double %141, %143
  %145 = add nsw i64 %139, %134
  %146 = getelementptr inbounds double, ptr %13, i64 %145
  %147 = load double, ptr %146, align 8
  %148 = fsub double %147, %144
  store double %148, ptr %146, align 8
  %149 = add nuw nsw i64 %139, 1
  %150 = icmp eq i64 %149, %15
  br i1 %150, label %135, label %138

151:                                              ; preds = %135, %127, %83, %38
  %152 = add nuw nsw i64 %26, 1
  %153 = getelementptr inbounds double, ptr %23, i64 %2
  %154 = getelementptr inbounds double, ptr %24, i64 %2
  %155 = getelementptr inbounds double, ptr %25, i64 %1
  %156 = getelementptr inbounds double, ptr %27, i64 %1
  %157 = getelementptr inbounds double, ptr %28, i64 %1
  %158 = getelementptr inbounds double, ptr %29, i64 %21
  %159 = icmp eq i64 %152, %0
  br i1 %159, label %32, label %22
}

define dso_local i64 @manipplan_within(i64 noundef %0, i64 noundef %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, double noundef %4, double noundef %5, i64 noundef %6, ptr nocapture noundef writeonly %7, ptr nocapture noundef writeonly %8, ptr nocapture noundef %9) local_unnamed_addr #7 {
  %11 = alloca i32, align 4
  %12 = icmp sgt i64 %0, 0
  br i1 %12, label %13, label %20

13:                                               ; preds = %10
  %14 = icmp sgt i64 %1, 0
  %15 = shl i64 %1, 3
  br label %16

16:                                               ; preds = %13, %84
  %17 = phi i64 [ 0, %13 ], [ %86, %84 ]
  %18 = phi i64 [ 0, %13 ], [ %85, %84 ]
  %19 = phi ptr [ %3, %13 ], [ %87, %84 ]
  br i1 %14, label %64, label %57

20:                                               ; preds = %84, %10
  %21 = phi i64 [ 0, %10 ], [ %85, %84 ]
  %22 = mul nsw i64 %21, %1
  call void @llvm.lifetime.start.p0(i64 4, ptr nonnull %11) #12
  %23 = icmp sgt i64 %22, 0
  br i1 %23, label %37, label %24

24:                                               ; preds = %37, %20
  %25 = phi double [ 0.000000e+00, %20 ], [ %44, %37 ]
  %26 = call double @frexp(double noundef %25, ptr noundef nonnull %11) #12
  %27 = load i32, ptr %11, align 4
  %28 = trunc i64 %6 to i32
  %29 = sub nsw i32 %27, %28
  %30 = tail call double @ldexp(double noundef 1.000000e+00, i32 noundef %29) #13
  %31 = fdiv double 1.000000e+00, %30
  %32 = fcmp ogt double %25, 0.000000e+00
  %33 = tail call double @llvm.fabs.f64(double %31) #14
  %34 = fcmp one double %33, 0x7FF0000000000000
  %35 = select i1 %32, i1 %34, i1 false
  %36 = and i1 %23, %35
  br i1 %36, label %47, label %56

37:                                               ; preds = %20, %37
  %38 = phi double [ %44, %37 ], [ 0.000000e+00, %20 ]
  %39 = phi i64 [ %45, %37 ], [ 0, %20 ]
  %40 = getelementptr inbounds double, ptr %9, i64 %39
  %41 = load double, ptr %40, align 8
  %42 = tail call double @llvm.fabs.f64(double %41)
  %43 = fcmp ogt double %42, %38
  %44 = select i1 %43, double %42, double %38
  %45 = add nuw nsw i64 %39, 1
  %46 = icmp eq i64 %45, %22
  br i1 %46, label %24, label %37

47:                                               ; preds = %24, %47
  %48 = phi i64 [ %54, %47 ], [ 0, %24 ]
  %49 = getelementptr inbounds double, ptr %9, i64 %48
  %50 = load double, ptr %49, align 8
  %51 = fmul double %31, %50
  %52 = tail call double @llvm.rint.f64(double %51)
  %53 = fmul double %30, %52
  store double %53, ptr %49, align 8
  %54 = add nuw nsw i64 %48, 1
  %55 = icmp eq i64 %54, %22
  br i1 %55, label %56, label %47

56:                                               ; preds = %47, %24
  call void @llvm.lifetime.end.p0(i64 4, ptr nonnull %11) #12
  ret i64 %21

57:                                               ; preds = %64, %16
  %58 = phi double [ 0.000000e+00, %16 ], [ %70, %64 ]
  %59 = getelementptr inbounds double, ptr %2, i64 %17
  %60 = load double, ptr %59, align 8
  %61 = fmul double %58, %4
  %62 = fadd double %61, %5
  %63 = fcmp olt double %60, %62
  br i1 %63, label %73, label %84

64:                                               ; preds = %16, %64
  %65 = phi i64 [ %71, %64 ], [ 0, %16 ]
  %66 = phi double [ %70, %64 ], [ 0.000000e+00, %16 ]
  %67 = getelementptr inbounds double, ptr %19, i64 %65
  %68 = load double, ptr %67, align 8
  %69 = tail call double @llvm.fabs.f64(double %68)
  %70 = fadd double %66, %69
  %71 = add nuw nsw i64 %65, 1
  %72 = icmp eq i64 %71, %1
  br i1 %72, label %57, label %64

73:                                               ; preds = %57
  %74 = mul nsw i64 %18, %1
  %75 = getelementptr inbounds double, ptr %9, i64 %74
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %75, ptr align 8 %19, i64 %15, i1 false)
  %76 = load double, ptr %59, align 8
  %77 = fdiv double %76, %5
  %78 = tail call double @llvm.rint.f64(double %77)
  %79 = fneg double %78
  %80 = fmul double %79, %5
  %81 = getelementptr inbounds double, ptr %8, i64 %18
  store double %80, ptr %81, align 8
  %82 = add nsw i64 %18, 1
  %83 = getelementptr inbounds i64, ptr %7, i64 %18
  store i64 %17, ptr %83, align 8
  br label %84

84:                                               ; preds = %57, %73
  %85 = phi i64 [ %82, %73 ], [ %18, %57 ]
  %86 = add nuw nsw i64 %17, 1
  %87 = getelementptr inbounds double, ptr %19, i64 %1
  %88 = icmp eq i64 %86, %0
  br i1 %88, label %20, label %16
}

declare double @llvm.fabs.f64(double) #8

declare double @llvm.rint.f64(double) #8

define dso_local i32 @manipplan_is_convex(i64 noundef %0, ptr nocapture noundef readonly %1, double noundef %2, ptr nocapture noundef %3, ptr nocapture noundef %4) local_unnamed_addr #5 {
  %6 = icmp sgt i64 %0, 0
  br i1 %6, label %7, label %89

7:                                                ; preds = %5, %17
  %8 = phi double [ %34, %17 ], [ 0.000000e+00, %5 ]
  %9 = phi i64 [ %18, %17 ], [ 0, %5 ]
  %10 = mul nsw i64 %9, %0
  br label %20

11:                                               ; preds = %17
  %12 = tail call double @llvm.sqrt.f64(double %34)
  %13 = fmul double %12, %2
  %14 = icmp slt i64 %0, 1
  br i1 %14, label %89, label %15

15:                                               ; preds = %11
  %16 = add nuw i64 %0, 1
  br label %37

17:                                               ; preds = %20
  %18 = add nuw nsw i64 %9, 1
  %19 = icmp eq i64 %18, %0
  br i1 %19, label %11, label %7

20:                                               ; preds = %7, %20
  %21 = phi double [ %8, %7 ], [ %34, %20 ]
  %22 = phi i64 [ 0, %7 ], [ %35, %20 ]
  %23 = add nsw i64 %22, %10
  %24 = getelementptr inbounds double, ptr %1, i64 %23
  %25 = load double, ptr %24, align 8
  %26 = mul nsw i64 %22, %0
  %27 = add nsw i64 %26, %9
  %28 = getelementptr inbounds double, ptr %1, i64 %27
  %29 = load double, ptr %28, align 8
  %30 = fadd double %25, %29
  %31 = fmul double %30, 5.000000e-01
  %32 = getelementptr inbounds double, ptr %4, i64 %23
  store double %31, ptr %32, align 8
  %33 = fmul double %31, %31
  %34 = fadd double %21, %33
  %35 = add nuw nsw i64 %22, 1
  %36 = icmp eq i64 %35, %0
  br i1 %36, label %17, label %20

37:                                               ; preds = %15, %84
  %38 = phi i64 [ 1, %15 ], [ %87, %84 ]
  %39 = phi i1 [ false, %15 ], [ %86, %84 ]
  %40 = phi i64 [ 0, %15 ], [ %85, %84 ]
  %41 = mul nsw i64 %40, %0
  br label %42

42:                                               ; preds = %37, %79
  %43 = phi i64 [ 0, %37 ], [ %82, %79 ]
  %44 = add nsw i64 %43, %41
  %45 = getelementptr inbounds double, ptr %4, i64 %44
  %46 = load double, ptr %45, align 8
  %47 = icmp eq i64 %40, %43
  %48 = select i1 %47, double %13, double 0.000000e+00
  %49 = fsub double %46, %48
  %50 = icmp eq i64 %43, 0
  br i1 %50, label %53, label %51

51:                                               ; preds = %42
  %52 = mul nsw i64 %43, %0
  br label %58

53:                                               ; preds = %58, %42
  %54 = phi double [ %49, %42 ], [ %68, %58 ]
  %55 = icmp ne i64 %40, %43
  %56 = fcmp ogt double %54, 0.000000e+00
  %57 = select i1 %55, i1 true, i1 %56
  br i1 %57, label %71, label %89

58:                                               ; preds = %51, %58
  %59 = phi i64 [ 0, %51 ], [ %69, %58 ]
  %60 = phi double [ %49, %51 ], [ %68, %58 ]
  %61 = add nsw i64 %59, %41
  %62 = getelementptr inbounds double, ptr %3, i64 %61
  %63 = load double, ptr %62, align 8
  %64 = add nsw i64 %59, %52
  %65 = getelementptr inbounds double, ptr %3, i64 %64
  %66 = load double, ptr %65, align 8
  %67 = fmul double %63, %66
  %68 = fsub double %60, %67
  %69 = add nuw nsw i64 %59, 1
  %70 = icmp eq i64 %69, %43
  br i1 %70, label %53, label %58

71:                                               ; preds = %53
  br i1 %47, label %72, label %74

72:                                               ; preds = %71
  %73 = tail call double @llvm.sqrt.f64(double %54)
  br label %79

74:                                               ; preds = %71
  %75 = mul i64 %43, %16
  %76 = getelementptr inbounds double, ptr %3, i64 %75
  %77 = load double, ptr %76, align 8
  %78 = fdiv double %54, %77
  br label %79

79:                                               ; preds = %72, %74
  %80 = phi double [ %73, %72 ], [ %78, %74 ]
  %81 = getelementptr inbounds double, ptr %3, i64 %44
  store double %80, ptr %81, align 8
  %82 = add nuw nsw i64 %43, 1
  %83 = icmp eq i64 %82, %38
  br i1 %83, label %84, label %42

84:                                               ; preds = %79
  %85 = add nuw nsw i64 %40, 1
  %86 = icmp sge i64 %85, %0
  %87 = add nuw i64 %38, 1
  %88 = icmp eq i64 %85, %0
  br i1 %88, label %89, label %37

89:                                               ; preds = %84, %53, %5, %11
  %90 = phi i1 [ true, %11 ], [ true, %5 ], [ %39, %53 ], [ %86, %84 ]
  %91 = zext i1 %90 to i32
  ret i32 %91
}

declare double @llvm.sqrt.f64(double) #8

declare double @frexp(double noundef, ptr nocapture noundef) local_unnamed_addr #9

declare double @ldexp(double noundef, i32 noundef) local_unnamed_addr #10

declare i64 @llvm.umax.i64(i64, i64) #11

attributes #0 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #3 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #4 = { nofree norecurse nosync nounwind memory(read, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #5 = { nofree nosync nounwind memory(argmem: readwrite) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #6 = { nofree norecurse nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #7 = { nofree nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #8 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #9 = { mustprogress nofree nounwind willreturn "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #10 = { mustprogress nofree nosync nounwind willreturn memory(none) "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #11 = { nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #12 = { nounwind }
attributes #13 = { nounwind willreturn memory(none) }
attributes #14 = { memory(none) }


