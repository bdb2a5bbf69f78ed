; panels.c 277dc496bb3ed2f5031c8aa026bd65eed100be6c796df38e8b64c15225058ac8: written by make kernel

%struct.Integral = type { ptr, ptr, ptr, ptr, i64, i64, ptr, ptr, double, double }

define dso_local i32 @manipplan_panels(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, i64 noundef %3, ptr nocapture noundef writeonly %4) local_unnamed_addr #0 {
  %6 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 4
  %7 = load i64, ptr %6, align 8
  %8 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 5
  %9 = load i64, ptr %8, align 8
  %10 = tail call i64 @llvm.smin.i64(i64 %3, i64 32)
  %11 = mul nsw i64 %9, %10
  %12 = shl nsw i64 %7, 1
  %13 = add nsw i64 %12, 2
  %14 = mul nsw i64 %11, %13
  %15 = add nsw i64 %14, %7
  %16 = shl i64 %15, 3
  %17 = tail call noalias ptr @malloc(i64 noundef %16) #9
  %18 = icmp eq ptr %17, null
  br i1 %18, label %151, label %19

19:                                               ; preds = %5
  %20 = getelementptr inbounds double, ptr %17, i64 %11
  %21 = getelementptr inbounds double, ptr %20, i64 %11
  %22 = mul nsw i64 %11, %7
  %23 = getelementptr inbounds double, ptr %21, i64 %22
  %24 = getelementptr inbounds double, ptr %23, i64 %22
  %25 = icmp sgt i64 %3, 0
  br i1 %25, label %26, label %38

26:                                               ; preds = %19
  %27 = icmp sgt i64 %9, 0
  %28 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 6
  %29 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 2
  %30 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 1
  %31 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 3
  %32 = icmp sgt i64 %7, 0
  %33 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 8
  %34 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 9
  %35 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 7
  br label %40

36:                                               ; preds = %95
  %37 = zext i1 %92 to i32
  br label %38

38:                                               ; preds = %49, %84, %36, %19
  %39 = phi i32 [ 0, %19 ], [ %37, %36 ], [ 1, %84 ], [ 1, %49 ]
  tail call void @free(ptr noundef %17) #10
  br label %151

40:                                               ; preds = %26, %95
  %41 = phi i64 [ %3, %26 ], [ %99, %95 ]
  %42 = phi i64 [ 0, %26 ], [ %96, %95 ]
  %43 = tail call i64 @llvm.smin.i64(i64 %41, i64 32)
  %44 = tail call i64 @llvm.smax.i64(i64 %43, i64 1)
  %45 = sub nsw i64 %3, %42
  %46 = tail call i64 @llvm.smin.i64(i64 %45, i64 32)
  %47 = mul nsw i64 %46, %9
  %48 = icmp sgt i64 %45, 0
  br i1 %48, label %54, label %49

49:                                               ; preds = %66, %40
  %50 = load ptr, ptr %29, align 8
  %51 = load ptr, ptr %0, align 8
  %52 = tail call i64 %50(ptr noundef %51, ptr noundef nonnull %17, i64 noundef %47, double noundef 0.000000e+00, ptr noundef nonnull %21) #10
  %53 = icmp eq i64 %52, 0
  br i1 %53, label %84, label %38

54:                                               ; preds = %40, %66
  %55 = phi i64 [ %67, %66 ], [ 0, %40 ]
  %56 = add nuw nsw i64 %55, %42
  %57 = getelementptr inbounds double, ptr %2, i64 %56
  %58 = load double, ptr %57, align 8
  %59 = getelementptr inbounds double, ptr %1, i64 %56
  %60 = load double, ptr %59, align 8
  %61 = fsub double %58, %60
  %62 = fmul double %61, 5.000000e-01
  br i1 %27, label %63, label %66

63:                                               ; preds = %54
  %64 = load ptr, ptr %28, align 8
  %65 = mul nsw i64 %55, %9
  br label %69

66:                                               ; preds = %69, %54
  %67 = add nuw nsw i64 %55, 1
  %68 = icmp eq i64 %67, %44
  br i1 %68, label %49, label %54

69:                                               ; preds = %63, %69
  %70 = phi i64 [ 0, %63 ], [ %82, %69 ]
  %71 = getelementptr inbounds double, ptr %64, i64 %70
  %72 = load double, ptr %71, align 8
  %73 = fadd double %72, 1.000000e+00
  %74 = fmul double %62, %73
  %75 = fadd double %60, %74
  %76 = fcmp olt double %75, 0.000000e+00
  %77 = fcmp ogt double %75, 1.000000e+00
  %78 = select i1 %77, double 1.000000e+00, double %75
  %79 = select i1 %76, double 0.000000e+00, double %78
  %80 = add nsw i64 %70, %65
  %81 = getelementptr inbounds double, ptr %17, i64 %80
  store double %79, ptr %81, align 8
  %82 = add nuw nsw i64 %70, 1
  %83 = icmp eq i64 %82, %9
  br i1 %83, label %66, label %69

84:                                               ; preds = %49
  %85 = load ptr, ptr %29, align 8
  %86 = load ptr, ptr %30, align 8
  %87 = tail call i64 %85(ptr noundef %86, ptr noundef nonnull %17, i64 noundef %47, double noundef 0.000000e+00, ptr noundef nonnull %23) #10
  %88 = icmp eq i64 %87, 0
  br i1 %88, label %89, label %38

89:                                               ; preds = %84
  %90 = load ptr, ptr %31, align 8
  %91 = tail call i32 %90(ptr noundef nonnull %21, ptr noundef nonnull %20, i64 noundef %47) #10
  %92 = icmp ne i32 %91, 0
  %93 = icmp slt i64 %46, 1
  %94 = select i1 %93, i1 true, i1 %92
  br i1 %94, label %95, label %100

95:                                               ; preds = %115, %89
  %96 = add nuw nsw i64 %42, 32
  %97 = icmp sge i64 %96, %3
  %98 = select i1 %97, i1 true, i1 %92
  %99 = add i64 %41, -32
  br i1 %98, label %36, label %40

100:                                              ; preds = %89, %115
  %101 = phi i64 [ %119, %115 ], [ 0, %89 ]
  %102 = add nuw nsw i64 %101, %42
  %103 = getelementptr inbounds double, ptr %2, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = getelementptr inbounds double, ptr %1, i64 %102
  %106 = load double, ptr %105, align 8
  %107 = fsub double %104, %106
  %108 = fmul double %107, 5.000000e-01
  %109 = mul nsw i64 %101, %9
  br i1 %27, label %110, label %115

110:                                              ; preds = %100
  %111 = load double, ptr %33, align 8
  %112 = load double, ptr %34, align 8
  %113 = fcmp oeq double %112, 2.000000e+00
  %114 = load ptr, ptr %35, align 8
  br label %121

115:                                              ; preds = %126, %100
  %116 = getelementptr inbounds double, ptr %17, i64 %109
  %117 = tail call fastcc double @sum(ptr noundef nonnull %116, i64 noundef %9)
  %118 = getelementptr inbounds double, ptr %4, i64 %102
  store double %117, ptr %118, align 8
  %119 = add nuw nsw i64 %101, 1
  %120 = icmp slt i64 %119, %46
  br i1 %120, label %100, label %95

121:                                              ; preds = %110, %126
  %122 = phi i64 [ 0, %110 ], [ %140, %126 ]
  %123 = add nsw i64 %122, %109
  br i1 %32, label %124, label %126

124:                                              ; preds = %121
  %125 = mul nsw i64 %123, %7
  br label %142

126:                                              ; preds = %142, %121
  %127 = getelementptr inbounds double, ptr %20, i64 %123
  %128 = load double, ptr %127, align 8
  %129 = tail call double @hypot(double noundef %128, double noundef %111) #11
  %130 = select i1 %113, double %129, double 1.000000e+00
  %131 = fmul double %129, %130
  %132 = getelementptr inbounds double, ptr %114, i64 %122
  %133 = load double, ptr %132, align 8
  %134 = fmul double %108, %133
  %135 = tail call fastcc double @sum(ptr noundef nonnull %24, i64 noundef %7)
  %136 = tail call double @llvm.sqrt.f64(double %135)
  %137 = fdiv double %136, %131
  %138 = fmul double %134, %137
  %139 = getelementptr inbounds double, ptr %17, i64 %123
  store double %138, ptr %139, align 8
  %140 = add nuw nsw i64 %122, 1
  %141 = icmp eq i64 %140, %9
  br i1 %141, label %115, label %121

142:                                              ; preds = %124, %142
  %143 = phi i64 [ 0, %124 ], [ %149, %142 ]
  %144 = add nsw i64 %143, %125
  %145 = getelementptr inbounds double, ptr %23, i64 %144
  %146 = load double, ptr %145, align 8
  %147 = fmul double %146, %146
  %148 = getelementptr inbounds double, ptr %24, i64 %143
  store double %147, ptr %148, align 8
  %149 = add nuw nsw i64 %143, 1
  %150 = icmp eq i64 %149, %7
  br i1 %150, label %126, label %142

151:                                              ; preds = %5, %38
  %152 = phi i32 [ %39, %38 ], [ 1, %5 ]
  ret i32 %152
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare noalias noundef ptr @malloc(i64 noundef) local_unnamed_addr #2

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

declare double @hypot(double noundef, double noundef) local_unnamed_addr #3

define internal fastcc double @sum(ptr noundef %0, i64 noundef %1) unnamed_addr #4 {
  %3 = alloca [8 x double], align 16
  %4 = icmp slt i64 %1, 8
  br i1 %4, label %5, label %15

5:                                                ; preds = %2
  %6 = icmp sgt i64 %1, 0
  br i1 %6, label %7, label %17

7:                                                ; preds = %5, %7
  %8 = phi i64 [ %13, %7 ], [ 0, %5 ]
  %9 = phi double [ %12, %7 ], [ 0.000000e+00, %5 ]
  %10 = getelementptr inbounds double, ptr %0, i64 %8
  %11 = load double, ptr %10, align 8
  %12 = fadd double %9, %11
  %13 = add nuw nsw i64 %8, 1
  %14 = icmp eq i64 %13, %1
  br i1 %14, label %17, label %7

15:                                               ; preds = %2
  %16 = icmp ugt i64 %1, 128
  br i1 %16, label %19, label %27

17:                                               ; preds = %78, %5, %7, %19
  %18 = phi double [ %26, %19 ], [ %79, %78 ], [ 0.000000e+00, %5 ], [ %12, %7 ]
  ret double %18

19:                                               ; preds = %15
  %20 = lshr i64 %1, 1
  %21 = and i64 %20, 9223372036854775800
  %22 = tail call fastcc double @sum(ptr noundef %0, i64 noundef %21)
  %23 = getelementptr inbounds double, ptr %0, i64 %21
  %24 = sub nsw i64 %1, %21
  %25 = tail call fastcc double @sum(ptr noundef %23, i64 noundef %24)
  %26 = fadd double %22, %25
  br label %17

27:                                               ; preds = %15
  call void @llvm.lifetime.start.p0(i64 64, ptr nonnull %3) #10
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(64) %3, ptr noundef nonnull align 8 dereferenceable(64) %0, i64 64, i1 false)
  %28 = and i64 %1, -8
  %29 = icmp ugt i64 %28, 8
  br i1 %29, label %30, label %45

30:                                               ; preds = %27, %32
  %31 = phi i64 [ %33, %32 ], [ 8, %27 ]
  br label %35

32:                                               ; preds = %35
  %33 = add nuw nsw i64 %31, 8
  %34 = icmp slt i64 %33, %28
  br i1 %34, label %30, label %45

35:                                               ; preds = %30, %35
  %36 = phi i64 [ 0, %30 ], [ %43, %35 ]
  %37 = add nuw nsw i64 %31, %36
  %38 = getelementptr inbounds double, ptr %0, i64 %37
  %39 = load double, ptr %38, align 8
  %40 = getelementptr inbounds [8 x double], ptr %3, i64 0, i64 %36
  %41 = load double, ptr %40, align 8
  %42 = fadd double %39, %41
  store double %42, ptr %40, align 8
  %43 = add nuw nsw i64 %36, 1
  %44 = icmp eq i64 %43, 8
  br i1 %44, label %32, label %35

45:                                               ; preds = %32, %27
  %46 = phi i64 [ 8, %27 ], [ %33, %32 ]
  %47 = load double, ptr %3, align 16
  %48 = getelementptr inbounds [8 x double], ptr %3, i64 0, i64 1
  %49 = load double, ptr %48, align 8
  %50 = fadd double %47, %49
  %51 = getelementptr inbounds [8 x double], ptr %3, i64 0, i64 2
  %52 = load double, ptr %51, align 16
  %53 = getelementptr inbounds [8 x double], ptr %3, i64 0, i64 3
  %54 = load double, ptr %53, align 8
  %55 = fadd double %52, %54
  %56 = fadd double %50, %55
  %57 = getelementptr inbounds [8 x double], ptr %3, i64 0, i64 4
  %58 = load double, ptr %57, align 16
  %59 = getelementptr inbounds [8 x double], ptr %3, i64 0, i64 5
  %60 = load double, ptr %59, align 8
  %61 = fadd double %58, %60
  %62 = getelementptr inbounds [8 x double], ptr %3, i64 0, i64 6
  %63 = load double, ptr %62, align 16
  %64 = getelementptr inbounds [8 x double], ptr %3, i64 0, i64 7
  %65 = load double, ptr %64, align 8
  %66 = fadd double %63, %65
  %67 = fadd double %61, %66
  %68 = fadd double %56, %67
  %69 = icmp slt i64 %46, %1
  br i1 %69, label %70, label %78

70:                                               ; preds = %45, %70
  %71 = phi double [ %75, %70 ], [ %68, %45 ]
  %72 = phi i64 [ %76, %70 ], [ %46, %45 ]
  %73 = getelementptr inbounds double, ptr %0, i64 %72
  %74 = load double, ptr %73, align 8
  %75 = fadd double %71, %74
  %76 = add nuw nsw i64 %72, 1
  %77 = icmp eq i64 %76, %1
  br i1 %77, label %78, label %70

78:                                               ; preds = %70, %45
  %79 = phi double [ %68, %45 ], [ %75, %70 ]
  call void @llvm.lifetime.end.p0(i64 64, ptr nonnull %3) #10
  br label %17
}

declare double @llvm.sqrt.f64(double) #5

declare void @free(ptr allocptr nocapture noundef) local_unnamed_addr #6

define dso_local i64 @manipplan_fine_panels(ptr nocapture noundef readonly %0, ptr nocapture noundef %1, i64 noundef %2, i64 noundef %3, i64 noundef %4, double noundef %5) local_unnamed_addr #0 {
  %7 = add nsw i64 %2, 1
  %8 = mul i64 %2, 72
  %9 = tail call noalias ptr @malloc(i64 noundef %8) #9
  %10 = icmp eq ptr %9, null
  br i1 %10, label %170, label %11

11:                                               ; preds = %6
  %12 = getelementptr double, ptr %9, i64 %2
  %13 = getelementptr inbounds double, ptr %12, i64 %2
  %14 = icmp sgt i64 %2, 0
  br i1 %14, label %15, label %17

15:                                               ; preds = %11
  %16 = load double, ptr %1, align 8
  br label %22

17:                                               ; preds = %22, %11
  %18 = tail call i32 @manipplan_panels(ptr noundef %0, ptr noundef nonnull %9, ptr noundef nonnull %12, i64 noundef %2, ptr noundef nonnull %13)
  %19 = icmp eq i32 %18, 0
  br i1 %19, label %20, label %167

20:                                               ; preds = %17
  %21 = icmp sgt i64 %4, 0
  br i1 %21, label %31, label %167

22:                                               ; preds = %15, %22
  %23 = phi double [ %28, %22 ], [ %16, %15 ]
  %24 = phi i64 [ %26, %22 ], [ 0, %15 ]
  %25 = getelementptr inbounds double, ptr %9, i64 %24
  store double %23, ptr %25, align 8
  %26 = add nuw nsw i64 %24, 1
  %27 = getelementptr inbounds double, ptr %1, i64 %26
  %28 = load double, ptr %27, align 8
  %29 = getelementptr inbounds double, ptr %12, i64 %24
  store double %28, ptr %29, align 8
  %30 = icmp eq i64 %26, %2
  br i1 %30, label %17, label %22

31:                                               ; preds = %20, %160
  %32 = phi i64 [ %162, %160 ], [ %2, %20 ]
  %33 = phi i64 [ %161, %160 ], [ %7, %20 ]
  %34 = phi ptr [ %118, %160 ], [ %9, %20 ]
  %35 = phi ptr [ %163, %160 ], [ %12, %20 ]
  %36 = phi ptr [ %164, %160 ], [ %13, %20 ]
  %37 = phi double [ %91, %160 ], [ 0.000000e+00, %20 ]
  %38 = phi i64 [ %165, %160 ], [ 0, %20 ]
  %39 = mul nsw i64 %32, 3
  %40 = getelementptr inbounds double, ptr %34, i64 %39
  %41 = shl nsw i64 %32, 1
  %42 = getelementptr inbounds double, ptr %40, i64 %41
  %43 = getelementptr inbounds double, ptr %42, i64 %41
  %44 = icmp sgt i64 %32, 0
  br i1 %44, label %52, label %48

45:                                               ; preds = %52
  %46 = tail call i32 @manipplan_panels(ptr noundef %0, ptr noundef nonnull %40, ptr noundef nonnull %42, i64 noundef %41, ptr noundef nonnull %43)
  %47 = icmp eq i32 %46, 0
  br i1 %47, label %51, label %167

48:                                               ; preds = %31
  %49 = tail call i32 @manipplan_panels(ptr noundef %0, ptr noundef nonnull %40, ptr noundef nonnull %42, i64 noundef %41, ptr noundef nonnull %43)
  %50 = icmp eq i32 %49, 0
  br i1 %50, label %69, label %167

51:                                               ; preds = %45
  br i1 %44, label %75, label %69

52:                                               ; preds = %31, %52
  %53 = phi i64 [ %67, %52 ], [ 0, %31 ]
  %54 = getelementptr inbounds double, ptr %34, i64 %53
  %55 = load double, ptr %54, align 8
  %56 = getelementptr inbounds double, ptr %35, i64 %53
  %57 = load double, ptr %56, align 8
  %58 = fadd double %55, %57
  %59 = fmul double %58, 5.000000e-01
  %60 = shl nuw nsw i64 %53, 1
  %61 = getelementptr inbounds double, ptr %40, i64 %60
  store double %55, ptr %61, align 8
  %62 = or i64 %60, 1
  %63 = getelementptr inbounds double, ptr %40, i64 %62
  store double %59, ptr %63, align 8
  %64 = getelementptr inbounds double, ptr %42, i64 %60
  store double %59, ptr %64, align 8
  %65 = load double, ptr %56, align 8
  %66 = getelementptr inbounds double, ptr %42, i64 %62
  store double %65, ptr %66, align 8
  %67 = add nuw nsw i64 %53, 1
  %68 = icmp eq i64 %67, %32
  br i1 %68, label %45, label %52

69:                                               ; preds = %51, %48
  %70 = tail call fastcc double @sum(ptr noundef nonnull %34, i64 noundef %32)
  br label %87

71:                                               ; preds = %75
  %72 = tail call fastcc double @sum(ptr noundef nonnull %34, i64 noundef %32)
  %73 = fadd double %37, %72
  %74 = fmul double %73, %5
  br i1 %44, label %93, label %87

75:                                               ; preds = %51, %75
  %76 = phi i64 [ %85, %75 ], [ 0, %51 ]
  %77 = shl nuw nsw i64 %76, 1
  %78 = getelementptr inbounds double, ptr %43, i64 %77
  %79 = load double, ptr %78, align 8
  %80 = or i64 %77, 1
  %81 = getelementptr inbounds double, ptr %43, i64 %80
  %82 = load double, ptr %81, align 8
  %83 = fadd double %79, %82
  %84 = getelementptr inbounds double, ptr %34, i64 %76
  store double %83, ptr %84, align 8
  %85 = add nuw nsw i64 %76, 1
  %86 = icmp eq i64 %85, %32
  br i1 %86, label %71, label %75

87:                                               ; preds = %71, %69
  %88 = tail call fastcc double @sum(ptr noundef %35, i64 noundef 0)
  br label %167

89:                                               ; preds = %111
  %90 = tail call fastcc double @sum(ptr noundef %35, i64 noundef %113)
  %91 = fadd double %37, %90
  %92 = icmp eq i64 %112, 0
  br i1 %92, label %167, label %116

93:                                               ; preds = %71, %111
  %94 = phi i64 [ %114, %111 ], [ 0, %71 ]
  %95 = phi i64 [ %113, %111 ], [ 0, %71 ]
  %96 = phi i64 [ %112, %111 ], [ 0, %71 ]
  %97 = getelementptr inbounds double, ptr %36, i64 %94
  %98 = load double, ptr %97, align 8
  %99 = getelementptr inbounds double, ptr %34, i64 %94
  %100 = load double, ptr %99, align 8
  %101 = fsub double %98, %100
  %102 = tail call double @llvm.fabs.f64(double %101)
  %103 = fcmp ogt double %102, %74
  br i1 %103, label %104, label %108

104:                                              ; preds = %93
  %105 = sitofp i64 %94 to double
  %106 = add nsw i64 %96, 1
  %107 = getelementptr inbounds double, ptr %36, i64 %96
  store double %105, ptr %107, align 8
  br label %111

108:                                              ; preds = %93
  %109 = add nsw i64 %95, 1
  %110 = getelementptr inbounds double, ptr %35, i64 %95
  store double %100, ptr %110, align 8
  br label %111

111:                                              ; preds = %104, %108
  %112 = phi i64 [ %106, %104 ], [ %96, %108 ]
  %113 = phi i64 [ %95, %104 ], [ %109, %108 ]
  %114 = add nuw nsw i64 %94, 1
  %115 = icmp eq i64 %114, %32
  br i1 %115, label %89, label %93

116:                                              ; preds = %89
  %117 = mul i64 %112, 144
  %118 = tail call noalias ptr @malloc(i64 noundef %117) #9
  %119 = icmp eq ptr %118, null
  br i1 %119, label %167, label %120

120:                                              ; preds = %116
  %121 = icmp sgt i64 %112, 0
  br i1 %121, label %122, label %160

122:                                              ; preds = %120
  %123 = shl nsw i64 %112, 2
  br label %124

124:                                              ; preds = %122, %140
  %125 = phi i64 [ 0, %122 ], [ %142, %140 ]
  %126 = phi i64 [ %33, %122 ], [ %141, %140 ]
  %127 = getelementptr inbounds double, ptr %36, i64 %125
  %128 = load double, ptr %127, align 8
  %129 = fptosi double %128 to i64
  %130 = icmp slt i64 %126, %3
  %131 = shl nsw i64 %129, 1
  br i1 %130, label %132, label %136

132:                                              ; preds = %124
  %133 = getelementptr inbounds double, ptr %42, i64 %131
  %134 = load double, ptr %133, align 8
  %135 = getelementptr inbounds double, ptr %1, i64 %126
  store double %134, ptr %135, align 8
  br label %136

136:                                              ; preds = %124, %132
  %137 = shl nuw nsw i64 %125, 1
  %138 = add i64 %125, %112
  %139 = shl i64 %138, 1
  br label %144

140:                                              ; preds = %144
  %141 = add nsw i64 %126, 1
  %142 = add nuw nsw i64 %125, 1
  %143 = icmp eq i64 %142, %112
  br i1 %143, label %160, label %124

144:                                              ; preds = %136, %144
  %145 = phi i1 [ true, %136 ], [ false, %144 ]
  %146 = phi i64 [ 0, %136 ], [ 1, %144 ]
  %147 = or i64 %131, %146
  %148 = getelementptr inbounds double, ptr %40, i64 %147
  %149 = load double, ptr %148, align 8
  %150 = or i64 %137, %146
  %151 = getelementptr inbounds double, ptr %118, i64 %150
  store double %149, ptr %151, align 8
  %152 = getelementptr inbounds double, ptr %42, i64 %147
  %153 = load double, ptr %152, align 8
  %154 = or i64 %139, %146
  %155 = getelementptr inbounds double, ptr %118, i64 %154
  store double %153, ptr %155, align 8
  %156 = getelementptr inbounds double, ptr %43, i64 %147
  %157 = load double, ptr %156, align 8
  %158 = add i64 %150, %123
  %159 = getelementptr inbounds double, ptr %118, i64 %158
  store double %157, ptr %159, align 8
  br i1 %145, label %144, label %140

160:                                              ; preds = %140, %120
  %161 = phi i64 [ %33, %120 ], [ %141, %140 ]
  tail call void @free(ptr noundef nonnull %34) #10
  %162 = shl nsw i64 %112, 1
  %163 = getelementptr inbounds double, ptr %118, i64 %162
  %164 = getelementptr inbounds double, ptr %163, i64 %162
  %165 = add nuw nsw i64 %38, 1
  %166 = icmp eq i64 %165, %4
  br i1 %166, label %167, label %31

167:                                              ; preds = %160, %89, %116, %45, %20, %87, %48, %17
  %168 = phi ptr [ %9, %17 ], [ %34, %48 ], [ %9, %20 ], [ %34, %87 ], [ %34, %45 ], [ %34, %116 ], [ %118, %160 ], [ %34, %89 ]
  %169 = phi i64 [ -1, %17 ], [ -1, %48 ], [ %7, %20 ], [ %33, %87 ], [ -1, %45 ], [ -1, %116 ], [ %161, %160 ], [ %33, %89 ]
  tail call void @free(ptr noundef nonnull %168) #10
  br label %170

170:                                              ; preds = %167, %6
  %171 = phi i64 [ -1, %6 ], [ %169, %167 ]
  ret i64 %171
}

declare double @llvm.fabs.f64(double) #5

declare i64 @llvm.smin.i64(i64, i64) #7

declare void @llvm.memcpy.p0.p0.i64(ptr noalias nocapture writeonly, ptr noalias nocapture readonly, i64, i1 immarg) #8

declare i64 @llvm.smax.i64(i64, i64) #7

attributes #0 = { nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nofree nounwind willreturn allockind("alloc,uninitialized") allocsize(0) memory(inaccessiblemem: readwrite) "alloc-family"="malloc" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #3 = { mustprogress nofree nosync nounwind willreturn memory(none) "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { nofree nosync nounwind memory(argmem: read) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #5 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #6 = { mustprogress nounwind willreturn allockind("free") memory(argmem: readwrite, inaccessiblemem: readwrite) "alloc-family"="malloc" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #7 = { nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #8 = { nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #9 = { nounwind allocsize(0) }
attributes #10 = { nounwind }
attributes #11 = { nounwind willreturn memory(none) }


