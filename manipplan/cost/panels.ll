; panels.c edbe7c47aa8400cc1a8e6a432327a58857e3a3e6bc1789e3870112cf67d9b5c7: written by make kernel

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

define dso_local i32 @manipplan_integral(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, i64 noundef %2, i64 noundef %3, i64 noundef %4, double noundef %5, ptr nocapture noundef writeonly %6) local_unnamed_addr #0 {
  %8 = mul i64 %2, 24
  %9 = tail call noalias ptr @malloc(i64 noundef %8) #9
  %10 = icmp eq ptr %9, null
  br i1 %10, label %198, label %11

11:                                               ; preds = %7
  %12 = getelementptr double, ptr %9, i64 %2
  %13 = getelementptr inbounds double, ptr %12, i64 %2
  %14 = icmp sgt i64 %2, 0
  br i1 %14, label %15, label %17

15:                                               ; preds = %11
  %16 = load double, ptr %1, align 8
  br label %24

17:                                               ; preds = %24, %11
  %18 = tail call i32 @manipplan_panels(ptr noundef %0, ptr noundef nonnull %9, ptr noundef nonnull %12, i64 noundef %2, ptr noundef nonnull %13)
  %19 = icmp sgt i64 %4, 0
  %20 = icmp ne i64 %2, 0
  %21 = and i1 %19, %20
  %22 = icmp eq i32 %18, 0
  %23 = select i1 %21, i1 %22, i1 false
  br i1 %23, label %33, label %185

24:                                               ; preds = %15, %24
  %25 = phi double [ %30, %24 ], [ %16, %15 ]
  %26 = phi i64 [ %28, %24 ], [ 0, %15 ]
  %27 = getelementptr inbounds double, ptr %9, i64 %26
  store double %25, ptr %27, align 8
  %28 = add nuw nsw i64 %26, 1
  %29 = getelementptr inbounds double, ptr %1, i64 %28
  %30 = load double, ptr %29, align 8
  %31 = getelementptr inbounds double, ptr %12, i64 %26
  store double %30, ptr %31, align 8
  %32 = icmp eq i64 %28, %2
  br i1 %32, label %17, label %24

33:                                               ; preds = %17, %173
  %34 = phi i64 [ %114, %173 ], [ %2, %17 ]
  %35 = phi ptr [ %110, %173 ], [ %9, %17 ]
  %36 = phi double [ %177, %173 ], [ 0.000000e+00, %17 ]
  %37 = phi ptr [ %174, %173 ], [ %12, %17 ]
  %38 = phi ptr [ %175, %173 ], [ %13, %17 ]
  %39 = phi i64 [ %179, %173 ], [ 0, %17 ]
  %40 = shl i64 %34, 6
  %41 = tail call noalias ptr @malloc(i64 noundef %40) #9
  %42 = icmp eq ptr %41, null
  br i1 %42, label %195, label %43

43:                                               ; preds = %33
  %44 = shl nsw i64 %34, 1
  %45 = getelementptr inbounds double, ptr %41, i64 %44
  %46 = getelementptr inbounds double, ptr %45, i64 %44
  %47 = getelementptr inbounds double, ptr %46, i64 %44
  %48 = getelementptr inbounds double, ptr %47, i64 %34
  %49 = icmp sgt i64 %34, 0
  br i1 %49, label %54, label %50

50:                                               ; preds = %43
  %51 = tail call i32 @manipplan_panels(ptr noundef %0, ptr noundef nonnull %41, ptr noundef nonnull %45, i64 noundef %44, ptr noundef nonnull %46)
  br label %70

52:                                               ; preds = %54
  %53 = tail call i32 @manipplan_panels(ptr noundef %0, ptr noundef nonnull %41, ptr noundef nonnull %45, i64 noundef %44, ptr noundef nonnull %46)
  br i1 %49, label %77, label %70

54:                                               ; preds = %43, %54
  %55 = phi i64 [ %68, %54 ], [ 0, %43 ]
  %56 = getelementptr inbounds double, ptr %35, i64 %55
  %57 = load double, ptr %56, align 8
  %58 = getelementptr inbounds double, ptr %37, i64 %55
  %59 = load double, ptr %58, align 8
  %60 = fadd double %57, %59
  %61 = fmul double %60, 5.000000e-01
  %62 = shl nuw nsw i64 %55, 1
  %63 = getelementptr inbounds double, ptr %41, i64 %62
  store double %57, ptr %63, align 8
  %64 = or i64 %62, 1
  %65 = getelementptr inbounds double, ptr %41, i64 %64
  store double %61, ptr %65, align 8
  %66 = getelementptr inbounds double, ptr %45, i64 %62
  store double %61, ptr %66, align 8
  %67 = getelementptr inbounds double, ptr %45, i64 %64
  store double %59, ptr %67, align 8
  %68 = add nuw nsw i64 %55, 1
  %69 = icmp eq i64 %68, %34
  br i1 %69, label %52, label %54

70:                                               ; preds = %50, %52
  %71 = phi i32 [ %51, %50 ], [ %53, %52 ]
  %72 = tail call fastcc double @sum(ptr noundef nonnull %48, i64 noundef 0)
  br label %102

73:                                               ; preds = %98
  %74 = tail call fastcc double @sum(ptr noundef nonnull %48, i64 noundef %99)
  %75 = fadd double %36, %74
  %76 = fmul double %75, %5
  br i1 %49, label %116, label %102

77:                                               ; preds = %52, %98
  %78 = phi i64 [ %100, %98 ], [ 0, %52 ]
  %79 = phi i64 [ %99, %98 ], [ 0, %52 ]
  %80 = shl nuw nsw i64 %78, 1
  %81 = getelementptr inbounds double, ptr %46, i64 %80
  %82 = load double, ptr %81, align 8
  %83 = or i64 %80, 1
  %84 = getelementptr inbounds double, ptr %46, i64 %83
  %85 = load double, ptr %84, align 8
  %86 = fadd double %82, %85
  %87 = getelementptr inbounds double, ptr %47, i64 %78
  store double %86, ptr %87, align 8
  %88 = tail call double @llvm.fabs.f64(double %86) #12
  %89 = fcmp ueq double %88, 0x7FF0000000000000
  br i1 %89, label %98, label %90

90:                                               ; preds = %77
  %91 = getelementptr inbounds double, ptr %38, i64 %78
  %92 = load double, ptr %91, align 8
  %93 = tail call double @llvm.fabs.f64(double %92) #12
  %94 = fcmp ueq double %93, 0x7FF0000000000000
  br i1 %94, label %98, label %95

95:                                               ; preds = %90
  %96 = add nsw i64 %79, 1
  %97 = getelementptr inbounds double, ptr %48, i64 %79
  store double %92, ptr %97, align 8
  br label %98

98:                                               ; preds = %77, %90, %95
  %99 = phi i64 [ %96, %95 ], [ %79, %90 ], [ %79, %77 ]
  %100 = add nuw nsw i64 %78, 1
  %101 = icmp eq i64 %100, %34
  br i1 %101, label %73, label %77

102:                                              ; preds = %140, %70, %73
  %103 = phi i32 [ %53, %73 ], [ %71, %70 ], [ %53, %140 ]
  %104 = phi i64 [ 0, %73 ], [ 0, %70 ], [ %141, %140 ]
  %105 = phi i64 [ 0, %73 ], [ 0, %70 ], [ %142, %140 ]
  %106 = tail call fastcc double @sum(ptr noundef nonnull %48, i64 noundef %104)
  %107 = fadd double %36, %106
  %108 = mul i64 %105, 48
  %109 = or i64 %108, 8
  %110 = tail call noalias ptr @malloc(i64 noundef %109) #9
  %111 = icmp eq ptr %110, null
  br i1 %111, label %145, label %112

112:                                              ; preds = %102
  %113 = icmp sgt i64 %105, 0
  %114 = shl nsw i64 %105, 1
  %115 = shl nsw i64 %105, 2
  br label %146

116:                                              ; preds = %73, %140
  %117 = phi i64 [ %143, %140 ], [ 0, %73 ]
  %118 = phi i64 [ %142, %140 ], [ 0, %73 ]
  %119 = phi i64 [ %141, %140 ], [ 0, %73 ]
  %120 = getelementptr inbounds double, ptr %47, i64 %117
  %121 = load double, ptr %120, align 8
  %122 = tail call double @llvm.fabs.f64(double %121) #12
  %123 = fcmp ueq double %122, 0x7FF0000000000000
  br i1 %123, label %136, label %124

124:                                              ; preds = %116
  %125 = getelementptr inbounds double, ptr %38, i64 %117
  %126 = load double, ptr %125, align 8
  %127 = tail call double @llvm.fabs.f64(double %126) #12
  %128 = fcmp ueq double %127, 0x7FF0000000000000
  br i1 %128, label %136, label %129

129:                                              ; preds = %124
  %130 = fsub double %121, %126
  %131 = tail call double @llvm.fabs.f64(double %130)
  %132 = fcmp ugt double %131, %76
  br i1 %132, label %136, label %133

133:                                              ; preds = %129
  %134 = add nsw i64 %119, 1
  %135 = getelementptr inbounds double, ptr %48, i64 %119
  store double %121, ptr %135, align 8
  br label %140

136:                                              ; preds = %116, %129, %124
  %137 = sitofp i64 %117 to double
  %138 = add nsw i64 %118, 1
  %139 = getelementptr inbounds double, ptr %47, i64 %118
  store double %137, ptr %139, align 8
  br label %140

140:                                              ; preds = %136, %133
  %141 = phi i64 [ %134, %133 ], [ %119, %136 ]
  %142 = phi i64 [ %118, %133 ], [ %138, %136 ]
  %143 = add nuw nsw i64 %117, 1
  %144 = icmp eq i64 %143, %34
  br i1 %144, label %102, label %116

145:                                              ; preds = %102
  tail call void @free(ptr noundef nonnull %41) #10
  br label %195

146:                                              ; preds = %112, %151
  %147 = phi i1 [ true, %112 ], [ false, %151 ]
  %148 = phi i64 [ 0, %112 ], [ 1, %151 ]
  br i1 %113, label %149, label %151

149:                                              ; preds = %146
  %150 = mul nuw nsw i64 %105, %148
  br label %152

151:                                              ; preds = %152, %146
  br i1 %147, label %146, label %173

152:                                              ; preds = %149, %152
  %153 = phi i64 [ 0, %149 ], [ %171, %152 ]
  %154 = getelementptr inbounds double, ptr %47, i64 %153
  %155 = load double, ptr %154, align 8
  %156 = fptosi double %155 to i64
  %157 = shl nsw i64 %156, 1
  %158 = or i64 %157, %148
  %159 = add nsw i64 %153, %150
  %160 = getelementptr inbounds double, ptr %41, i64 %158
  %161 = load double, ptr %160, align 8
  %162 = getelementptr inbounds double, ptr %110, i64 %159
  store double %161, ptr %162, align 8
  %163 = getelementptr inbounds double, ptr %45, i64 %158
  %164 = load double, ptr %163, align 8
  %165 = add nsw i64 %159, %114
  %166 = getelementptr inbounds double, ptr %110, i64 %165
  store double %164, ptr %166, align 8
  %167 = getelementptr inbounds double, ptr %46, i64 %158
  %168 = load double, ptr %167, align 8
  %169 = add nsw i64 %159, %115
  %170 = getelementptr inbounds double, ptr %110, i64 %169
  store double %168, ptr %170, align 8
  %171 = add nuw nsw i64 %153, 1
  %172 = icmp eq i64 %171, %105
  br i1 %172, label %151, label %152

173:                                              ; preds = %151
  tail call void @free(ptr noundef %35) #10
  tail call void @free(ptr noundef %41) #10
  %174 = getelementptr inbounds double, ptr %110, i64 %114
  %175 = getelementptr inbounds double, ptr %174, i64 %114
  %176 = icmp sgt i64 %114, %3
  %177 = select i1 %176, double 0x7FF0000000000000, double %107
  %178 = select i1 %176, i64 0, i64 %114
  %179 = add nuw nsw i64 %39, 1
  %180 = icmp slt i64 %179, %4
  %181 = icmp ne i64 %178, 0
  %182 = select i1 %180, i1 %181, i1 false
  %183 = icmp eq i32 %103, 0
  %184 = select i1 %182, i1 %183, i1 false
  br i1 %184, label %33, label %185

185:                                              ; preds = %173, %17
  %186 = phi i32 [ %18, %17 ], [ %103, %173 ]
  %187 = phi ptr [ %13, %17 ], [ %175, %173 ]
  %188 = phi double [ 0.000000e+00, %17 ], [ %177, %173 ]
  %189 = phi ptr [ %9, %17 ], [ %110, %173 ]
  %190 = phi i64 [ %2, %17 ], [ %178, %173 ]
  %191 = icmp eq i32 %186, 0
  br i1 %191, label %192, label %195

192:                                              ; preds = %185
  %193 = tail call fastcc double @sum(ptr noundef %187, i64 noundef %190)
  %194 = fadd double %188, %193
  store double %194, ptr %6, align 8
  br label %195

195:                                              ; preds = %33, %145, %192, %185
  %196 = phi ptr [ %189, %192 ], [ %189, %185 ], [ %35, %145 ], [ %35, %33 ]
  %197 = phi i32 [ 0, %192 ], [ %186, %185 ], [ 1, %145 ], [ 1, %33 ]
  tail call void @free(ptr noundef %196) #10
  br label %198

198:                                              ; preds = %7, %195
  %199 = phi i32 [ %197, %195 ], [ 1, %7 ]
  ret i32 %199
}

define dso_local i32 @manipplan_minimum(ptr nocapture noundef readonly %0, i64 noundef %1, i64 noundef %2, i64 noundef %3, i64 noundef %4, ptr nocapture noundef %5) local_unnamed_addr #0 {
  %7 = icmp sgt i64 %1, %4
  %8 = add nsw i64 %1, 1
  %9 = add i64 %4, 1
  %10 = select i1 %7, i64 %8, i64 %9
  %11 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 4
  %12 = load i64, ptr %11, align 8
  %13 = add nsw i64 %12, 2
  %14 = shl i64 %10, 3
  %15 = mul i64 %14, %13
  %16 = tail call noalias ptr @malloc(i64 noundef %15) #9
  %17 = mul i64 %2, 24
  %18 = tail call noalias ptr @malloc(i64 noundef %17) #9
  %19 = icmp eq ptr %16, null
  %20 = icmp eq ptr %18, null
  %21 = or i1 %19, %20
  br i1 %21, label %212, label %22

22:                                               ; preds = %6
  %23 = getelementptr inbounds double, ptr %16, i64 %10
  %24 = getelementptr inbounds double, ptr %23, i64 %10
  %25 = getelementptr inbounds double, ptr %18, i64 %2
  %26 = getelementptr inbounds double, ptr %25, i64 %2
  %27 = sitofp i64 %1 to double
  %28 = fdiv double 1.000000e+00, %27
  %29 = icmp sgt i64 %1, 0
  br i1 %29, label %30, label %38

30:                                               ; preds = %22, %30
  %31 = phi i64 [ %36, %30 ], [ 0, %22 ]
  %32 = sitofp i64 %31 to double
  %33 = fmul double %28, %32
  %34 = fadd double %33, 0.000000e+00
  %35 = getelementptr inbounds double, ptr %16, i64 %31
  store double %34, ptr %35, align 8
  %36 = add nuw nsw i64 %31, 1
  %37 = icmp eq i64 %36, %1
  br i1 %37, label %38, label %30

38:                                               ; preds = %30, %22
  %39 = getelementptr inbounds double, ptr %16, i64 %1
  store double 1.000000e+00, ptr %39, align 8
  %40 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 2
  %41 = load ptr, ptr %40, align 8
  %42 = load ptr, ptr %0, align 8
  %43 = tail call i64 %41(ptr noundef %42, ptr noundef nonnull %16, i64 noundef %8, double noundef 0.000000e+00, ptr noundef %24) #10
  %44 = icmp eq i64 %43, 0
  br i1 %44, label %48, label %45

45:                                               ; preds = %38
  store double 0x7FF0000000000000, ptr %5, align 8
  %46 = getelementptr inbounds double, ptr %5, i64 1
  store double 0.000000e+00, ptr %46, align 8
  %47 = getelementptr inbounds double, ptr %5, i64 2
  store double 0xFFF0000000000000, ptr %47, align 8
  br label %212

48:                                               ; preds = %38
  %49 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 3
  %50 = load ptr, ptr %49, align 8
  %51 = tail call i32 %50(ptr noundef nonnull %24, ptr noundef nonnull %23, i64 noundef %8) #10
  %52 = icmp ne i32 %51, 0
  %53 = zext i1 %52 to i32
  store double 0x7FF0000000000000, ptr %5, align 8
  %54 = getelementptr inbounds double, ptr %5, i64 1
  store double 0.000000e+00, ptr %54, align 8
  %55 = getelementptr inbounds double, ptr %5, i64 2
  store double 0xFFF0000000000000, ptr %55, align 8
  %56 = icmp slt i64 %1, 0
  %57 = select i1 %56, i1 true, i1 %52
  br i1 %57, label %212, label %58

58:                                               ; preds = %48
  %59 = add nsw i64 %2, -1
  %60 = getelementptr inbounds double, ptr %26, i64 %59
  br label %71

61:                                               ; preds = %134
  %62 = icmp slt i64 %135, 1
  %63 = select i1 %62, i1 true, i1 %52
  br i1 %63, label %212, label %64

64:                                               ; preds = %61
  %65 = icmp sgt i64 %3, 0
  %66 = sitofp i64 %4 to double
  %67 = icmp sgt i64 %4, 0
  %68 = getelementptr inbounds double, ptr %16, i64 %4
  %69 = getelementptr inbounds %struct.Integral, ptr %0, i64 0, i32 3
  %70 = icmp slt i64 %4, 1
  br label %138

71:                                               ; preds = %58, %134
  %72 = phi double [ 0xFFF0000000000000, %58 ], [ %80, %134 ]
  %73 = phi i64 [ 0, %58 ], [ %136, %134 ]
  %74 = phi i64 [ 0, %58 ], [ %135, %134 ]
  %75 = getelementptr inbounds double, ptr %23, i64 %73
  %76 = load double, ptr %75, align 8
  %77 = fcmp ogt double %76, %72
  br i1 %77, label %78, label %79

78:                                               ; preds = %71
  store double %76, ptr %55, align 8
  br label %79

79:                                               ; preds = %78, %71
  %80 = phi double [ %76, %78 ], [ %72, %71 ]
  %81 = icmp eq i64 %73, 0
  br i1 %81, label %87, label %82

82:                                               ; preds = %79
  %83 = add nsw i64 %73, -1
  %84 = getelementptr inbounds double, ptr %23, i64 %83
  %85 = load double, ptr %84, align 8
  %86 = fcmp ogt double %76, %85
  br i1 %86, label %134, label %87

87:                                               ; preds = %82, %79
  %88 = icmp slt i64 %73, %1
  br i1 %88, label %89, label %94

89:                                               ; preds = %87
  %90 = add nuw nsw i64 %73, 1
  %91 = getelementptr inbounds double, ptr %23, i64 %90
  %92 = load double, ptr %91, align 8
  %93 = fcmp ogt double %76, %92
  br i1 %93, label %134, label %94

94:                                               ; preds = %89, %87
  %95 = icmp eq i64 %74, %2
  br i1 %95, label %96, label %99

96:                                               ; preds = %94
  %97 = load double, ptr %60, align 8
  %98 = fcmp ugt double %97, %76
  br i1 %98, label %99, label %134

99:                                               ; preds = %96, %94
  %100 = icmp slt i64 %74, %2
  %101 = zext i1 %100 to i64
  %102 = add nsw i64 %74, %101
  %103 = xor i1 %100, true
  %104 = sext i1 %103 to i64
  %105 = add nsw i64 %74, %104
  %106 = icmp sgt i64 %105, 0
  br i1 %106, label %107, label %122

107:                                              ; preds = %99, %113
  %108 = phi i64 [ %109, %113 ], [ %105, %99 ]
  %109 = add nsw i64 %108, -1
  %110 = getelementptr inbounds double, ptr %26, i64 %109
  %111 = load double, ptr %110, align 8
  %112 = fcmp ogt double %111, %76
  br i1 %112, label %113, label %122

113:                                              ; preds = %107
  %114 = getelementptr inbounds double, ptr %26, i64 %108
  store double %111, ptr %114, align 8
  %115 = getelementptr inbounds double, ptr %18, i64 %109
  %116 = load double, ptr %115, align 8
  %117 = getelementptr inbounds double, ptr %18, i64 %108
  store double %116, ptr %117, align 8
  %118 = getelementptr inbounds double, ptr %25, i64 %109
  %119 = load double, ptr %118, align 8
  %120 = getelementptr inbounds double, ptr %25, i64 %108
  store double %119, ptr %120, align 8
  %121 = icmp ugt i64 %108, 1
  br i1 %121, label %107, label %122

122:                                              ; preds = %107, %113, %99
  %123 = phi i64 [ %105, %99 ], [ 0, %113 ], [ %108, %107 ]
  %124 = getelementptr inbounds double, ptr %26, i64 %123
  store double %76, ptr %124, align 8
  %125 = tail call i64 @llvm.usub.sat.i64(i64 %73, i64 1)
  %126 = getelementptr inbounds double, ptr %16, i64 %125
  %127 = load double, ptr %126, align 8
  %128 = getelementptr inbounds double, ptr %18, i64 %123
  store double %127, ptr %128, align 8
  %129 = add nuw nsw i64 %73, 1
  %130 = select i1 %88, i64 %129, i64 %1
  %131 = getelementptr inbounds double, ptr %16, i64 %130
  %132 = load double, ptr %131, align 8
  %133 = getelementptr inbounds double, ptr %25, i64 %123
  store double %132, ptr %133, align 8
  br label %134

134:                                              ; preds = %96, %82, %89, %122
  %135 = phi i64 [ %74, %82 ], [ %74, %89 ], [ %2, %96 ], [ %102, %122 ]
  %136 = add nuw nsw i64 %73, 1
  %137 = icmp slt i64 %73, %1
  br i1 %137, label %71, label %61

138:                                              ; preds = %64, %144
  %139 = phi i64 [ 0, %64 ], [ %146, %144 ]
  br i1 %65, label %140, label %144

140:                                              ; preds = %138
  %141 = getelementptr inbounds double, ptr %18, i64 %139
  %142 = getelementptr inbounds double, ptr %25, i64 %139
  %143 = load double, ptr %142, align 8
  br label %150

144:                                              ; preds = %198, %138
  %145 = phi i32 [ 0, %138 ], [ %175, %198 ]
  %146 = add nuw nsw i64 %139, 1
  %147 = icmp slt i64 %146, %135
  %148 = icmp eq i32 %145, 0
  %149 = select i1 %147, i1 %148, i1 false
  br i1 %149, label %138, label %212

150:                                              ; preds = %140, %198
  %151 = phi double [ %143, %140 ], [ %208, %198 ]
  %152 = phi i64 [ 0, %140 ], [ %209, %198 ]
  %153 = load double, ptr %141, align 8
  %154 = fsub double %151, %153
  %155 = fdiv double %154, %66
  br i1 %67, label %156, label %164

156:                                              ; preds = %150, %156
  %157 = phi i64 [ %162, %156 ], [ 0, %150 ]
  %158 = sitofp i64 %157 to double
  %159 = fmul double %155, %158
  %160 = fadd double %153, %159
  %161 = getelementptr inbounds double, ptr %16, i64 %157
  store double %160, ptr %161, align 8
  %162 = add nuw nsw i64 %157, 1
  %163 = icmp eq i64 %162, %4
  br i1 %163, label %164, label %156

164:                                              ; preds = %156, %150
  store double %151, ptr %68, align 8
  %165 = load ptr, ptr %40, align 8
  %166 = load ptr, ptr %0, align 8
  %167 = tail call i64 %165(ptr noundef %166, ptr noundef %16, i64 noundef %9, double noundef 0.000000e+00, ptr noundef %24) #10
  %168 = icmp eq i64 %167, 0
  br i1 %168, label %169, label %174

169:                                              ; preds = %164
  %170 = load ptr, ptr %69, align 8
  %171 = tail call i32 %170(ptr noundef nonnull %24, ptr noundef nonnull %23, i64 noundef %9) #10
  %172 = icmp ne i32 %171, 0
  %173 = zext i1 %172 to i32
  br label %174

174:                                              ; preds = %164, %169
  %175 = phi i32 [ 1, %164 ], [ %173, %169 ]
  br i1 %70, label %176, label %179

176:                                              ; preds = %179, %174
  %177 = phi i64 [ 0, %174 ], [ %187, %179 ]
  %178 = icmp eq i32 %175, 0
  br i1 %178, label %190, label %198

179:                                              ; preds = %174, %179
  %180 = phi i64 [ %188, %179 ], [ 1, %174 ]
  %181 = phi i64 [ %187, %179 ], [ 0, %174 ]
  %182 = getelementptr inbounds double, ptr %23, i64 %180
  %183 = load double, ptr %182, align 8
  %184 = getelementptr inbounds double, ptr %23, i64 %181
  %185 = load double, ptr %184, align 8
  %186 = fcmp olt double %183, %185
  %187 = select i1 %186, i64 %180, i64 %181
  %188 = add nuw i64 %180, 1
  %189 = icmp eq i64 %180, %4
  br i1 %189, label %176, label %179

190:                                              ; preds = %176
  %191 = getelementptr inbounds double, ptr %23, i64 %177
  %192 = load double, ptr %191, align 8
  %193 = load double, ptr %5, align 8
  %194 = fcmp olt double %192, %193
  br i1 %194, label %195, label %198

195:                                              ; preds = %190
  store double %192, ptr %5, align 8
  %196 = getelementptr inbounds double, ptr %16, i64 %177
  %197 = load double, ptr %196, align 8
  store double %197, ptr %54, align 8
  br label %198

198:                                              ; preds = %195, %190, %176
  %199 = icmp sgt i64 %177, 0
  %200 = add nsw i64 %177, -1
  %201 = select i1 %199, i64 %200, i64 0
  %202 = getelementptr inbounds double, ptr %16, i64 %201
  %203 = load double, ptr %202, align 8
  store double %203, ptr %141, align 8
  %204 = icmp slt i64 %177, %4
  %205 = add nsw i64 %177, 1
  %206 = select i1 %204, i64 %205, i64 %4
  %207 = getelementptr inbounds double, ptr %16, i64 %206
  %208 = load double, ptr %207, align 8
  store double %208, ptr %142, align 8
  %209 = add nuw nsw i64 %152, 1
  %210 = icmp slt i64 %209, %3
  %211 = and i1 %210, %178
  br i1 %211, label %150, label %144

212:                                              ; preds = %144, %45, %48, %61, %6
  %213 = phi i32 [ 1, %6 ], [ %53, %61 ], [ 1, %45 ], [ %53, %48 ], [ %145, %144 ]
  tail call void @free(ptr noundef %16) #10
  tail call void @free(ptr noundef %18) #10
  ret i32 %213
}

declare i64 @llvm.smin.i64(i64, i64) #7

declare i64 @llvm.usub.sat.i64(i64, i64) #7

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
attributes #12 = { memory(none) }


