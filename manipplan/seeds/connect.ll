; connect.c 108a62294bb2cdf925062b34dd6a32d2aefd4274a5114c15360632a16a3324ae: written by make kernel

%struct.Side = type { i8, i8, i64 }
%struct.Search = type { i64, ptr, ptr, double, double, ptr, ptr, ptr, double, i64, ptr, ptr, [2 x double], double, ptr, i64, double, i64, ptr, ptr, i64, double, double, ptr, ptr, i64, i64, [2 x ptr], [2 x ptr], [2 x ptr], [2 x ptr], [2 x i64], [2 x i64], i64, i64 }

define dso_local i32 @manipplan_state(ptr nocapture noundef %0, ptr noundef %1) local_unnamed_addr #0 {
  %3 = alloca %struct.Side, align 8
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %3) #8
  %4 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
  %5 = load ptr, ptr %4, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %3, ptr noundef nonnull align 8 dereferenceable(16) %5, i64 16, i1 false)
  %6 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %7 = load i64, ptr %6, align 8
  %8 = icmp eq i64 %7, 0
  br i1 %8, label %18, label %9

9:                                                ; preds = %2
  %10 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 1
  %11 = load ptr, ptr %10, align 8
  %12 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %1, ptr noundef %1, ptr noundef nonnull %3, ptr noundef %11)
  %13 = icmp eq i32 %12, 0
  br i1 %13, label %14, label %18

14:                                               ; preds = %9
  %15 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 34
  %16 = load i64, ptr %15, align 8
  %17 = add nsw i64 %16, 1
  store i64 %17, ptr %15, align 8
  br label %82

18:                                               ; preds = %9, %2
  %19 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  %20 = load ptr, ptr %19, align 8
  %21 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %22 = load i64, ptr %21, align 8
  %23 = getelementptr inbounds double, ptr %20, i64 %22
  %24 = load double, ptr %23, align 8
  %25 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 13
  br label %39

26:                                               ; preds = %70
  %27 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 34
  %28 = load i64, ptr %27, align 8
  %29 = add nsw i64 %28, 1
  store i64 %29, ptr %27, align 8
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %33 = load ptr, ptr %32, align 8
  %34 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %35 = load double, ptr %34, align 8
  %36 = fadd double %71, %35
  %37 = tail call i32 %31(ptr noundef %33, ptr noundef %1, double noundef %36) #8
  %38 = icmp eq i32 %37, 2
  br i1 %38, label %72, label %78

39:                                               ; preds = %70, %18
  %40 = phi i1 [ true, %18 ], [ false, %70 ]
  %41 = phi i64 [ 0, %18 ], [ 1, %70 ]
  %42 = phi double [ %24, %18 ], [ %71, %70 ]
  %43 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 12, i64 %41
  %44 = load double, ptr %43, align 8
  %45 = fcmp ogt double %42, %44
  br i1 %45, label %46, label %70

46:                                               ; preds = %39
  %47 = load double, ptr %25, align 8
  %48 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %41
  %49 = load ptr, ptr %48, align 8
  %50 = load i64, ptr %0, align 8
  %51 = icmp sgt i64 %50, 0
  br i1 %51, label %52, label %64

52:                                               ; preds = %46, %52
  %53 = phi i64 [ %62, %52 ], [ 0, %46 ]
  %54 = phi double [ %61, %52 ], [ 0.000000e+00, %46 ]
  %55 = getelementptr inbounds double, ptr %49, i64 %53
  %56 = load double, ptr %55, align 8
  %57 = getelementptr inbounds double, ptr %1, i64 %53
  %58 = load double, ptr %57, align 8
  %59 = fsub double %56, %58
  %60 = fmul double %59, %59
  %61 = fadd double %54, %60
  %62 = add nuw nsw i64 %53, 1
  %63 = icmp eq i64 %62, %50
  br i1 %63, label %64, label %52

64:                                               ; preds = %52, %46
  %65 = phi double [ 0.000000e+00, %46 ], [ %61, %52 ]
  %66 = tail call double @llvm.sqrt.f64(double %65)
  %67 = fmul double %47, %66
  %68 = fadd double %44, %67
  %69 = tail call double @llvm.minnum.f64(double %42, double %68)
  br label %70

70:                                               ; preds = %64, %39
  %71 = phi double [ %69, %64 ], [ %42, %39 ]
  br i1 %40, label %39, label %26

72:                                               ; preds = %26
  %73 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %74 = load ptr, ptr %73, align 8
  %75 = load double, ptr %34, align 8
  %76 = fadd double %71, %75
  %77 = tail call i32 %74(ptr noundef %1, double noundef %76) #8
  br label %78

78:                                               ; preds = %26, %72
  %79 = phi i32 [ %77, %72 ], [ %37, %26 ]
  %80 = icmp eq i32 %79, 0
  %81 = zext i1 %80 to i32
  br label %82

82:                                               ; preds = %78, %14
  %83 = phi i32 [ %81, %78 ], [ 0, %14 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %3) #8
  ret i32 %83
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.memcpy.p0.p0.i64(ptr noalias nocapture writeonly, ptr noalias nocapture readonly, i64, i1 immarg) #2

define internal fastcc i32 @carry(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef %3, ptr nocapture noundef readonly %4) unnamed_addr #0 {
  %6 = alloca [4096 x double], align 16
  %7 = alloca [512 x double], align 16
  call void @llvm.lifetime.start.p0(i64 32768, ptr nonnull %6) #8
  call void @llvm.lifetime.start.p0(i64 4096, ptr nonnull %7) #8
  %8 = load i64, ptr %0, align 8
  %9 = icmp sgt i64 %8, 0
  br i1 %9, label %10, label %22

10:                                               ; preds = %5, %10
  %11 = phi double [ %19, %10 ], [ 0.000000e+00, %5 ]
  %12 = phi i64 [ %20, %10 ], [ 0, %5 ]
  %13 = getelementptr inbounds double, ptr %2, i64 %12
  %14 = load double, ptr %13, align 8
  %15 = getelementptr inbounds double, ptr %1, i64 %12
  %16 = load double, ptr %15, align 8
  %17 = fsub double %14, %16
  %18 = tail call double @llvm.fabs.f64(double %17)
  %19 = tail call double @llvm.maxnum.f64(double %11, double %18)
  %20 = add nuw nsw i64 %12, 1
  %21 = icmp eq i64 %20, %8
  br i1 %21, label %22, label %10

22:                                               ; preds = %10, %5
  %23 = phi double [ 0.000000e+00, %5 ], [ %19, %10 ]
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10
  %25 = load ptr, ptr %24, align 8
  %26 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %27 = load i64, ptr %26, align 8
  %28 = getelementptr inbounds double, ptr %25, i64 %27
  %29 = load double, ptr %28, align 8
  %30 = fdiv double %23, %29
  %31 = tail call double @llvm.ceil.f64(double %30)
  %32 = fptosi double %31 to i64
  %33 = tail call i64 @llvm.smax.i64(i64 %32, i64 1)
  %34 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 18
  %35 = add nuw nsw i64 %33, 1
  %36 = sitofp i64 %33 to double
  %37 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %38 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 19
  %39 = getelementptr inbounds %struct.Side, ptr %3, i64 0, i32 1
  %40 = getelementptr inbounds %struct.Side, ptr %3, i64 0, i32 2
  %41 = getelementptr inbounds %struct.Side, ptr %4, i64 0, i32 1
  %42 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20
  br label %47

43:                                               ; preds = %114
  %44 = add nuw nsw i64 %49, 64
  %45 = icmp ugt i64 %44, %33
  %46 = add nsw i64 %48, -64
  br i1 %45, label %158, label %47

47:                                               ; preds = %22, %43
  %48 = phi i64 [ %33, %22 ], [ %46, %43 ]
  %49 = phi i64 [ 1, %22 ], [ %44, %43 ]
  %50 = call i64 @llvm.smin.i64(i64 %48, i64 64)
  %51 = call i64 @llvm.smax.i64(i64 %50, i64 1)
  %52 = sub nsw i64 %35, %49
  %53 = call i64 @llvm.smin.i64(i64 %52, i64 64)
  %54 = icmp sgt i64 %52, 0
  br i1 %54, label %55, label %62

55:                                               ; preds = %47
  %56 = load i64, ptr %0, align 8
  %57 = icmp sgt i64 %56, 0
  br label %70

58:                                               ; preds = %89
  %59 = load ptr, ptr %34, align 8
  %60 = call i32 %59(ptr noundef nonnull %6, ptr noundef nonnull %7, i64 noundef %53) #8
  %61 = icmp eq i32 %60, 0
  br i1 %61, label %66, label %158

62:                                               ; preds = %47
  %63 = load ptr, ptr %34, align 8
  %64 = call i32 %63(ptr noundef nonnull %6, ptr noundef nonnull %7, i64 noundef %53) #8
  %65 = icmp eq i32 %64, 0
  br i1 %65, label %97, label %158

66:                                               ; preds = %58
  br i1 %54, label %67, label %97

67:                                               ; preds = %66
  %68 = load i64, ptr %37, align 8
  %69 = icmp sgt i64 %68, 0
  br label %92

70:                                               ; preds = %55, %89
  %71 = phi i64 [ 0, %55 ], [ %90, %89 ]
  %72 = add nuw nsw i64 %71, %49
  %73 = sitofp i64 %72 to double
  %74 = fdiv double %73, %36
  %75 = mul nsw i64 %56, %71
  %76 = getelementptr inbounds double, ptr %6, i64 %75
  br i1 %57, label %77, label %89

77:                                               ; preds = %70, %77
  %78 = phi i64 [ %87, %77 ], [ 0, %70 ]
  %79 = getelementptr inbounds double, ptr %1, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = getelementptr inbounds double, ptr %2, i64 %78
  %82 = load double, ptr %81, align 8
  %83 = fsub double %82, %80
  %84 = fmul double %74, %83
  %85 = fadd double %80, %84
  %86 = getelementptr inbounds double, ptr %76, i64 %78
  store double %85, ptr %86, align 8
  %87 = add nuw nsw i64 %78, 1
  %88 = icmp eq i64 %87, %56
  br i1 %88, label %89, label %77

89:                                               ; preds = %77, %70
  %90 = add nuw nsw i64 %71, 1
  %91 = icmp eq i64 %90, %51
  br i1 %91, label %58, label %70

92:                                               ; preds = %67, %120
  %93 = phi i64 [ 0, %67 ], [ %121, %120 ]
  br i1 %69, label %94, label %120

94:                                               ; preds = %92
  %95 = mul nsw i64 %68, %93
  %96 = load ptr, ptr %38, align 8
  br label %123

97:                                               ; preds = %120, %62, %66
  %98 = load i64, ptr %40, align 8
  %99 = load i8, ptr %3, align 8
  %100 = load i8, ptr %4, align 8
  %101 = xor i8 %100, %99
  %102 = load i8, ptr %39, align 1
  %103 = and i8 %101, %102
  %104 = load i8, ptr %41, align 1
  %105 = and i8 %103, %104
  %106 = icmp eq i8 %105, 0
  br i1 %106, label %114, label %107

107:                                              ; preds = %97, %107
  %108 = phi i32 [ %110, %107 ], [ 0, %97 ]
  %109 = phi i8 [ %112, %107 ], [ %105, %97 ]
  %110 = add nuw nsw i32 %108, 1
  %111 = add i8 %109, -1
  %112 = and i8 %111, %109
  %113 = icmp eq i8 %112, 0
  br i1 %113, label %114, label %107

114:                                              ; preds = %107, %97
  %115 = phi i32 [ 0, %97 ], [ %110, %107 ]
  %116 = sext i32 %115 to i64
  %117 = add nsw i64 %98, %116
  %118 = load i64, ptr %42, align 8
  %119 = icmp sgt i64 %117, %118
  br i1 %119, label %158, label %43

120:                                              ; preds = %155, %92
  %121 = add nuw nsw i64 %93, 1
  %122 = icmp eq i64 %121, %51
  br i1 %122, label %97, label %92

123:                                              ; preds = %94, %155
  %124 = phi i64 [ 0, %94 ], [ %156, %155 ]
  %125 = add nsw i64 %95, %124
  %126 = getelementptr inbounds [512 x double], ptr %7, i64 0, i64 %125
  %127 = load double, ptr %126, align 8
  %128 = call double @llvm.fabs.f64(double %127)
  %129 = getelementptr inbounds double, ptr %96, i64 %124
  %130 = load double, ptr %129, align 8
  %131 = fcmp olt double %128, %130
  br i1 %131, label %155, label %132

132:                                              ; preds = %123
  %133 = fcmp oge double %127, 0.000000e+00
  %134 = trunc i64 %124 to i32
  %135 = shl nuw i32 1, %134
  %136 = trunc i32 %135 to i8
  %137 = select i1 %133, i8 %136, i8 0
  %138 = load i8, ptr %39, align 1
  %139 = zext i8 %138 to i32
  %140 = and i32 %135, %139
  %141 = icmp ne i32 %140, 0
  %142 = load i8, ptr %3, align 8
  %143 = zext i8 %142 to i32
  %144 = and i32 %135, %143
  %145 = zext i8 %137 to i32
  %146 = icmp ne i32 %144, %145
  %147 = select i1 %141, i1 %146, i1 false
  %148 = zext i1 %147 to i64
  %149 = load i64, ptr %40, align 8
  %150 = add nsw i64 %149, %148
  store i64 %150, ptr %40, align 8
  %151 = xor i8 %136, -1
  %152 = and i8 %142, %151
  %153 = or i8 %152, %137
  store i8 %153, ptr %3, align 8
  %154 = or i8 %138, %136
  store i8 %154, ptr %39, align 1
  br label %155

155:                                              ; preds = %123, %132
  %156 = add nuw nsw i64 %124, 1
  %157 = icmp eq i64 %156, %68
  br i1 %157, label %120, label %123

158:                                              ; preds = %62, %58, %43, %114
  %159 = phi i32 [ 0, %58 ], [ 1, %43 ], [ 0, %114 ], [ 0, %62 ]
  call void @llvm.lifetime.end.p0(i64 4096, ptr nonnull %7) #8
  call void @llvm.lifetime.end.p0(i64 32768, ptr nonnull %6) #8
  ret i32 %159
}

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

define dso_local i32 @manipplan_motion(ptr nocapture noundef %0, ptr nocapture noundef readonly %1, ptr noundef %2) local_unnamed_addr #0 {
  %4 = alloca %struct.Side, align 8
  %5 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %6 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  %7 = load i64, ptr %6, align 8
  %8 = load i64, ptr %5, align 8
  %9 = add nsw i64 %8, 1
  %10 = icmp slt i64 %9, %7
  br i1 %10, label %11, label %25

11:                                               ; preds = %3
  %12 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 34
  %13 = load i64, ptr %12, align 8
  %14 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %15 = load ptr, ptr %14, align 8
  br label %16

16:                                               ; preds = %22, %11
  %17 = phi i64 [ %9, %11 ], [ %23, %22 ]
  %18 = phi i64 [ %8, %11 ], [ %17, %22 ]
  %19 = getelementptr inbounds i64, ptr %15, i64 %18
  %20 = load i64, ptr %19, align 8
  %21 = icmp slt i64 %13, %20
  br i1 %21, label %25, label %22

22:                                               ; preds = %16
  store i64 %17, ptr %5, align 8
  %23 = add i64 %17, 1
  %24 = icmp eq i64 %23, %7
  br i1 %24, label %25, label %16

25:                                               ; preds = %16, %22, %3
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %4) #8
  %26 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
  %27 = load ptr, ptr %26, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %4, ptr noundef nonnull align 8 dereferenceable(16) %27, i64 16, i1 false)
  %28 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %29 = load i64, ptr %28, align 8
  %30 = icmp eq i64 %29, 0
  br i1 %30, label %40, label %31

31:                                               ; preds = %25
  %32 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 1
  %33 = load ptr, ptr %32, align 8
  %34 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %1, ptr noundef %2, ptr noundef nonnull %4, ptr noundef %33)
  %35 = icmp eq i32 %34, 0
  br i1 %35, label %36, label %40

36:                                               ; preds = %31
  %37 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 34
  %38 = load i64, ptr %37, align 8
  %39 = add nsw i64 %38, 1
  store i64 %39, ptr %37, align 8
  br label %42

40:                                               ; preds = %31, %25
  %41 = tail call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef %1, ptr noundef %2)
  br label %42

42:                                               ; preds = %40, %36
  %43 = phi i32 [ %41, %40 ], [ 0, %36 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %4) #8
  ret i32 %43
}

define internal fastcc i32 @motion_is_free(ptr nocapture noundef %0, ptr nocapture noundef readonly %1, ptr noundef %2) unnamed_addr #0 {
  %4 = alloca [64 x double], align 16
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %4) #8
  %5 = load i64, ptr %0, align 8
  %6 = icmp sgt i64 %5, 0
  br i1 %6, label %7, label %19

7:                                                ; preds = %3, %7
  %8 = phi double [ %16, %7 ], [ 0.000000e+00, %3 ]
  %9 = phi i64 [ %17, %7 ], [ 0, %3 ]
  %10 = getelementptr inbounds double, ptr %2, i64 %9
  %11 = load double, ptr %10, align 8
  %12 = getelementptr inbounds double, ptr %1, i64 %9
  %13 = load double, ptr %12, align 8
  %14 = fsub double %11, %13
  %15 = tail call double @llvm.fabs.f64(double %14)
  %16 = tail call double @llvm.maxnum.f64(double %8, double %15)
  %17 = add nuw nsw i64 %9, 1
  %18 = icmp eq i64 %17, %5
  br i1 %18, label %19, label %7

19:                                               ; preds = %7, %3
  %20 = phi double [ 0.000000e+00, %3 ], [ %16, %7 ]
  %21 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %24 = load i64, ptr %23, align 8
  %25 = getelementptr inbounds double, ptr %22, i64 %24
  %26 = load double, ptr %25, align 8
  %27 = fdiv double %20, %26
  %28 = tail call double @llvm.ceil.f64(double %27)
  %29 = fptosi double %28 to i64
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds double, ptr %31, i64 %24
  %33 = load double, ptr %32, align 8
  %34 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 13
  br label %49

35:                                               ; preds = %78
  %36 = tail call i64 @llvm.smax.i64(i64 %29, i64 1)
  %37 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 34
  %38 = load i64, ptr %37, align 8
  %39 = add nsw i64 %38, 1
  store i64 %39, ptr %37, align 8
  %40 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %41 = load ptr, ptr %40, align 8
  %42 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %43 = load ptr, ptr %42, align 8
  %44 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %45 = load double, ptr %44, align 8
  %46 = fadd double %79, %45
  %47 = tail call i32 %41(ptr noundef %43, ptr noundef %2, double noundef %46) #8
  %48 = icmp eq i32 %47, 2
  br i1 %48, label %80, label %86

49:                                               ; preds = %78, %19
  %50 = phi i1 [ true, %19 ], [ false, %78 ]
  %51 = phi i64 [ 0, %19 ], [ 1, %78 ]
  %52 = phi double [ %33, %19 ], [ %79, %78 ]
  %53 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 12, i64 %51
  %54 = load double, ptr %53, align 8
  %55 = fcmp ogt double %52, %54
  br i1 %55, label %56, label %78

56:                                               ; preds = %49
  %57 = load double, ptr %34, align 8
  %58 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %51
  %59 = load ptr, ptr %58, align 8
  br i1 %6, label %60, label %72

60:                                               ; preds = %56, %60
  %61 = phi i64 [ %70, %60 ], [ 0, %56 ]
  %62 = phi double [ %69, %60 ], [ 0.000000e+00, %56 ]
  %63 = getelementptr inbounds double, ptr %59, i64 %61
  %64 = load double, ptr %63, align 8
  %65 = getelementptr inbounds double, ptr %2, i64 %61
  %66 = load double, ptr %65, align 8
  %67 = fsub double %64, %66
  %68 = fmul double %67, %67
  %69 = fadd double %62, %68
  %70 = add nuw nsw i64 %61, 1
  %71 = icmp eq i64 %70, %5
  br i1 %71, label %72, label %60

72:                                               ; preds = %60, %56
  %73 = phi double [ 0.000000e+00, %56 ], [ %69, %60 ]
  %74 = tail call double @llvm.sqrt.f64(double %73)
  %75 = fmul double %57, %74
  %76 = fadd double %54, %75
  %77 = tail call double @llvm.minnum.f64(double %52, double %76)
  br label %78

78:                                               ; preds = %72, %49
  %79 = phi double [ %77, %72 ], [ %52, %49 ]
  br i1 %50, label %49, label %35

80:                                               ; preds = %35
  %81 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %82 = load ptr, ptr %81, align 8
  %83 = load double, ptr %44, align 8
  %84 = fadd double %79, %83
  %85 = tail call i32 %82(ptr noundef %2, double noundef %84) #8
  br label %86

86:                                               ; preds = %35, %80
  %87 = phi i32 [ %85, %80 ], [ %47, %35 ]
  %88 = icmp eq i32 %87, 0
  br i1 %88, label %89, label %182

89:                                               ; preds = %86, %89
  %90 = phi i64 [ %91, %89 ], [ 1, %86 ]
  %91 = shl nsw i64 %90, 1
  %92 = icmp slt i64 %91, %36
  br i1 %92, label %89, label %93

93:                                               ; preds = %89
  %94 = icmp ugt i64 %36, 1
  %95 = icmp sgt i64 %90, 0
  %96 = select i1 %95, i1 %94, i1 false
  br i1 %96, label %97, label %182

97:                                               ; preds = %93
  %98 = sitofp i64 %36 to double
  %99 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  br label %100

100:                                              ; preds = %97, %179
  %101 = phi i64 [ %90, %97 ], [ %180, %179 ]
  %102 = icmp slt i64 %101, %36
  br i1 %102, label %103, label %179

103:                                              ; preds = %100
  %104 = shl nuw nsw i64 %101, 1
  br label %105

105:                                              ; preds = %103, %176
  %106 = phi i64 [ %101, %103 ], [ %177, %176 ]
  %107 = sitofp i64 %106 to double
  %108 = fdiv double %107, %98
  %109 = load i64, ptr %0, align 8
  %110 = icmp sgt i64 %109, 0
  br i1 %110, label %111, label %123

111:                                              ; preds = %105, %111
  %112 = phi i64 [ %121, %111 ], [ 0, %105 ]
  %113 = getelementptr inbounds double, ptr %1, i64 %112
  %114 = load double, ptr %113, align 8
  %115 = getelementptr inbounds double, ptr %2, i64 %112
  %116 = load double, ptr %115, align 8
  %117 = fsub double %116, %114
  %118 = fmul double %108, %117
  %119 = fadd double %114, %118
  %120 = getelementptr inbounds double, ptr %4, i64 %112
  store double %119, ptr %120, align 8
  %121 = add nuw nsw i64 %112, 1
  %122 = icmp eq i64 %121, %109
  br i1 %122, label %123, label %111

123:                                              ; preds = %111, %105
  %124 = load ptr, ptr %30, align 8
  %125 = load i64, ptr %23, align 8
  %126 = getelementptr inbounds double, ptr %124, i64 %125
  %127 = load double, ptr %126, align 8
  br label %137

128:                                              ; preds = %166
  %129 = load i64, ptr %37, align 8
  %130 = add nsw i64 %129, 1
  store i64 %130, ptr %37, align 8
  %131 = load ptr, ptr %40, align 8
  %132 = load ptr, ptr %42, align 8
  %133 = load double, ptr %44, align 8
  %134 = fadd double %167, %133
  %135 = call i32 %131(ptr noundef %132, ptr noundef nonnull %4, double noundef %134) #8
  %136 = icmp eq i32 %135, 2
  br i1 %136, label %168, label %173

137:                                              ; preds = %166, %123
  %138 = phi i1 [ true, %123 ], [ false, %166 ]
  %139 = phi i64 [ 0, %123 ], [ 1, %166 ]
  %140 = phi double [ %127, %123 ], [ %167, %166 ]
  %141 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 12, i64 %139
  %142 = load double, ptr %141, align 8
  %143 = fcmp ogt double %140, %142
  br i1 %143, label %144, label %166

144:                                              ; preds = %137
  %145 = load double, ptr %34, align 8
  %146 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %139
  %147 = load ptr, ptr %146, align 8
  br i1 %110, label %148, label %160

148:                                              ; preds = %144, %148
  %149 = phi i64 [ %158, %148 ], [ 0, %144 ]
  %150 = phi double [ %157, %148 ], [ 0.000000e+00, %144 ]
  %151 = getelementptr inbounds double, ptr %147, i64 %149
  %152 = load double, ptr %151, align 8
  %153 = getelementptr inbounds double, ptr %4, i64 %149
  %154 = load double, ptr %153, align 8
  %155 = fsub double %152, %154
  %156 = fmul double %155, %155
  %157 = fadd double %150, %156
  %158 = add nuw nsw i64 %149, 1
  %159 = icmp eq i64 %158, %109
  br i1 %159, label %160, label %148

160:                                              ; preds = %148, %144
  %161 = phi double [ 0.000000e+00, %144 ], [ %157, %148 ]
  %162 = call double @llvm.sqrt.f64(double %161)
  %163 = fmul double %145, %162
  %164 = fadd double %142, %163
  %165 = call double @llvm.minnum.f64(double %140, double %164)
  br label %166

166:                                              ; preds = %160, %137
  %167 = phi double [ %165, %160 ], [ %140, %137 ]
  br i1 %138, label %137, label %128

168:                                              ; preds = %128
  %169 = load ptr, ptr %99, align 8
  %170 = load double, ptr %44, align 8
  %171 = fadd double %167, %170
  %172 = call i32 %169(ptr noundef nonnull %4, double noundef %171) #8
  br label %173

173:                                              ; preds = %128, %168
  %174 = phi i32 [ %172, %168 ], [ %135, %128 ]
  %175 = icmp eq i32 %174, 0
  br i1 %175, label %176, label %182

176:                                              ; preds = %173
  %177 = add nsw i64 %106, %104
  %178 = icmp slt i64 %177, %36
  br i1 %178, label %105, label %179

179:                                              ; preds = %176, %100
  %180 = lshr i64 %101, 1
  %181 = icmp ugt i64 %101, 1
  br i1 %181, label %100, label %182

182:                                              ; preds = %179, %173, %93, %86
  %183 = phi i32 [ 0, %86 ], [ 1, %93 ], [ 0, %173 ], [ 1, %179 ]
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %4) #8
  ret i32 %183
}

define dso_local i32 @manipplan_connect(ptr noundef %0, i64 noundef %1) local_unnamed_addr #0 {
  %3 = alloca [64 x double], align 16
  %4 = alloca [64 x double], align 16
  %5 = alloca [64 x double], align 16
  %6 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 34
  %7 = load i64, ptr %6, align 8
  %8 = add nsw i64 %7, %1
  %9 = icmp sgt i64 %1, 0
  br i1 %9, label %10, label %519

10:                                               ; preds = %2
  %11 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %12 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  %13 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %14 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %15 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %16 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 16
  %17 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31
  %18 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26
  %19 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31, i64 1
  %20 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 33
  %21 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21
  %22 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22
  %23 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %25 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %26 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27
  %27 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 1
  %28 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %29 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20
  br label %30

30:                                               ; preds = %10, %516
  %31 = phi i64 [ %7, %10 ], [ %517, %516 ]
  %32 = load i64, ptr %12, align 8
  %33 = load i64, ptr %11, align 8
  %34 = add nsw i64 %33, 1
  %35 = icmp slt i64 %34, %32
  br i1 %35, label %36, label %47

36:                                               ; preds = %30
  %37 = load ptr, ptr %13, align 8
  br label %38

38:                                               ; preds = %44, %36
  %39 = phi i64 [ %34, %36 ], [ %45, %44 ]
  %40 = phi i64 [ %33, %36 ], [ %39, %44 ]
  %41 = getelementptr inbounds i64, ptr %37, i64 %40
  %42 = load i64, ptr %41, align 8
  %43 = icmp slt i64 %31, %42
  br i1 %43, label %47, label %44

44:                                               ; preds = %38
  store i64 %39, ptr %11, align 8
  %45 = add i64 %39, 1
  %46 = icmp eq i64 %45, %32
  br i1 %46, label %47, label %38

47:                                               ; preds = %38, %44, %30
  %48 = load i64, ptr %0, align 8
  %49 = icmp sgt i64 %48, 0
  br i1 %49, label %50, label %53

50:                                               ; preds = %47
  %51 = load ptr, ptr %14, align 8
  %52 = load ptr, ptr %15, align 8
  br label %64

53:                                               ; preds = %64, %47
  %54 = phi double [ 0.000000e+00, %47 ], [ %73, %64 ]
  %55 = tail call double @llvm.sqrt.f64(double %54)
  %56 = load double, ptr %16, align 8
  %57 = fdiv double %55, %56
  %58 = fptosi double %57 to i64
  %59 = add nsw i64 %58, 3
  %60 = load i64, ptr %17, align 8
  %61 = add nsw i64 %59, %60
  %62 = load i64, ptr %18, align 8
  %63 = icmp sgt i64 %61, %62
  br i1 %63, label %519, label %76

64:                                               ; preds = %64, %50
  %65 = phi double [ 0.000000e+00, %50 ], [ %73, %64 ]
  %66 = phi i64 [ 0, %50 ], [ %74, %64 ]
  %67 = getelementptr inbounds double, ptr %51, i64 %66
  %68 = load double, ptr %67, align 8
  %69 = getelementptr inbounds double, ptr %52, i64 %66
  %70 = load double, ptr %69, align 8
  %71 = fsub double %68, %70
  %72 = fmul double %71, %71
  %73 = fadd double %65, %72
  %74 = add nuw nsw i64 %66, 1
  %75 = icmp eq i64 %74, %48
  br i1 %75, label %53, label %64

76:                                               ; preds = %53
  %77 = load i64, ptr %19, align 8
  %78 = add nsw i64 %77, %59
  %79 = icmp sgt i64 %78, %62
  br i1 %79, label %519, label %80

80:                                               ; preds = %76
  %81 = load i64, ptr %20, align 8
  %82 = sub nsw i64 1, %81
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %5) #8
  %83 = load double, ptr %21, align 8
  %84 = fcmp olt double %83, 0x7FF0000000000000
  br i1 %84, label %85, label %234

85:                                               ; preds = %80
  %86 = load double, ptr %22, align 8
  %87 = fcmp ogt double %86, 0.000000e+00
  br i1 %87, label %88, label %234

88:                                               ; preds = %85
  %89 = load i64, ptr %23, align 8
  %90 = add i64 %89, -7046029254386353131
  store i64 %90, ptr %23, align 8
  %91 = lshr i64 %90, 30
  %92 = xor i64 %91, %90
  %93 = mul i64 %92, -4658895280553007687
  %94 = lshr i64 %93, 27
  %95 = xor i64 %94, %93
  %96 = mul i64 %95, -7723592293110705685
  %97 = lshr i64 %96, 42
  %98 = lshr i64 %96, 11
  %99 = xor i64 %97, %98
  %100 = uitofp i64 %99 to double
  %101 = fmul double %100, 0x3CA0000000000000
  %102 = load double, ptr %24, align 8
  %103 = fcmp olt double %101, %102
  br i1 %103, label %104, label %234

104:                                              ; preds = %88
  %105 = fdiv double %83, %86
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %3) #8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %4) #8
  %106 = load ptr, ptr %26, align 8
  %107 = load ptr, ptr %27, align 8
  br i1 %49, label %108, label %124

108:                                              ; preds = %104, %108
  %109 = phi i64 [ %118, %108 ], [ 0, %104 ]
  %110 = phi double [ %117, %108 ], [ 0.000000e+00, %104 ]
  %111 = getelementptr inbounds double, ptr %107, i64 %109
  %112 = load double, ptr %111, align 8
  %113 = getelementptr inbounds double, ptr %106, i64 %109
  %114 = load double, ptr %113, align 8
  %115 = fsub double %112, %114
  %116 = fmul double %115, %115
  %117 = fadd double %110, %116
  %118 = add nuw nsw i64 %109, 1
  %119 = icmp eq i64 %118, %48
  br i1 %119, label %120, label %108

120:                                              ; preds = %108, %139
  %121 = phi i64 [ %148, %139 ], [ %90, %108 ]
  %122 = phi i32 [ %140, %139 ], [ 0, %108 ]
  br label %144

123:                                              ; preds = %139
  store i64 %148, ptr %23, align 8
  br label %124

124:                                              ; preds = %123, %104
  %125 = phi i64 [ %148, %123 ], [ %90, %104 ]
  %126 = phi double [ %117, %123 ], [ 0.000000e+00, %104 ]
  %127 = phi i1 [ %141, %123 ], [ false, %104 ]
  %128 = phi double [ %165, %123 ], [ 0.000000e+00, %104 ]
  %129 = tail call double @llvm.sqrt.f64(double %126)
  %130 = fmul double %105, %105
  %131 = fmul double %129, %129
  %132 = fsub double %130, %131
  %133 = tail call double @llvm.maxnum.f64(double %132, double 0.000000e+00)
  %134 = tail call double @llvm.sqrt.f64(double %133)
  %135 = tail call double @llvm.sqrt.f64(double %128)
  %136 = fdiv double 1.000000e+00, %135
  %137 = freeze i1 %127
  %138 = select i1 %137, double %136, double 1.000000e+00
  br i1 %49, label %168, label %233

139:                                              ; preds = %144
  %140 = add nuw nsw i32 %122, 1
  %141 = fcmp ogt double %165, 1.000000e+00
  %142 = icmp ult i32 %122, 999
  %143 = select i1 %141, i1 %142, i1 false
  br i1 %143, label %120, label %123

144:                                              ; preds = %144, %120
  %145 = phi i64 [ %121, %120 ], [ %148, %144 ]
  %146 = phi double [ 0.000000e+00, %120 ], [ %165, %144 ]
  %147 = phi i64 [ 0, %120 ], [ %166, %144 ]
  %148 = add i64 %145, -7046029254386353131
  %149 = lshr i64 %148, 30
  %150 = xor i64 %149, %148
  %151 = mul i64 %150, -4658895280553007687
  %152 = lshr i64 %151, 27
  %153 = xor i64 %152, %151
  %154 = mul i64 %153, -7723592293110705685
  %155 = lshr i64 %154, 42
  %156 = lshr i64 %154, 11
  %157 = xor i64 %155, %156
  %158 = uitofp i64 %157 to double
  %159 = fmul double %158, 0x3CA0000000000000
  %160 = fmul double %159, 2.000000e+00
  %161 = fadd double %160, -1.000000e+00
  %162 = getelementptr inbounds [64 x double], ptr %3, i64 0, i64 %147
  store double %161, ptr %162, align 8
  %163 = fmul double %161, %161
  %164 = freeze double %163
  %165 = fadd double %146, %164
  %166 = add nuw nsw i64 %147, 1
  %167 = icmp eq i64 %166, %48
  br i1 %167, label %139, label %144

168:                                              ; preds = %124, %168
  %169 = phi i64 [ %189, %168 ], [ 0, %124 ]
  %170 = phi double [ %188, %168 ], [ 0.000000e+00, %124 ]
  %171 = icmp eq i64 %169, 0
  %172 = select i1 %171, double %105, double %134
  %173 = fmul double %172, 5.000000e-01
  %174 = fmul double %138, %173
  %175 = getelementptr inbounds [64 x double], ptr %3, i64 0, i64 %169
  %176 = load double, ptr %175, align 8
  %177 = fmul double %176, %174
  store double %177, ptr %175, align 8
  %178 = getelementptr inbounds double, ptr %107, i64 %169
  %179 = load double, ptr %178, align 8
  %180 = getelementptr inbounds double, ptr %106, i64 %169
  %181 = load double, ptr %180, align 8
  %182 = fsub double %179, %181
  %183 = fdiv double %182, %129
  %184 = uitofp i1 %171 to double
  %185 = fsub double %183, %184
  %186 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %169
  store double %185, ptr %186, align 8
  %187 = fmul double %177, %185
  %188 = fadd double %170, %187
  %189 = add nuw nsw i64 %169, 1
  %190 = icmp eq i64 %189, %48
  br i1 %190, label %197, label %168

191:                                              ; preds = %197
  %192 = fmul double %188, 2.000000e+00
  %193 = fcmp ogt double %203, 0.000000e+00
  %194 = fdiv double %192, %203
  %195 = load ptr, ptr %15, align 8
  %196 = load ptr, ptr %14, align 8
  br label %206

197:                                              ; preds = %168, %197
  %198 = phi i64 [ %204, %197 ], [ 0, %168 ]
  %199 = phi double [ %203, %197 ], [ 0.000000e+00, %168 ]
  %200 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %198
  %201 = load double, ptr %200, align 8
  %202 = fmul double %201, %201
  %203 = fadd double %199, %202
  %204 = add nuw nsw i64 %198, 1
  %205 = icmp eq i64 %204, %48
  br i1 %205, label %191, label %197

206:                                              ; preds = %221, %191
  %207 = phi i64 [ 0, %191 ], [ %231, %221 ]
  %208 = getelementptr inbounds double, ptr %106, i64 %207
  %209 = load double, ptr %208, align 8
  %210 = getelementptr inbounds double, ptr %107, i64 %207
  %211 = load double, ptr %210, align 8
  %212 = fadd double %209, %211
  %213 = fmul double %212, 5.000000e-01
  %214 = getelementptr inbounds [64 x double], ptr %3, i64 0, i64 %207
  %215 = load double, ptr %214, align 8
  %216 = fadd double %215, %213
  br i1 %193, label %217, label %221

217:                                              ; preds = %206
  %218 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %207
  %219 = load double, ptr %218, align 8
  %220 = fmul double %194, %219
  br label %221

221:                                              ; preds = %217, %206
  %222 = phi double [ %220, %217 ], [ 0.000000e+00, %206 ]
  %223 = fsub double %216, %222
  %224 = getelementptr inbounds double, ptr %5, i64 %207
  %225 = getelementptr inbounds double, ptr %195, i64 %207
  %226 = load double, ptr %225, align 8
  %227 = tail call double @llvm.maxnum.f64(double %223, double %226)
  %228 = getelementptr inbounds double, ptr %196, i64 %207
  %229 = load double, ptr %228, align 8
  %230 = tail call double @llvm.minnum.f64(double %227, double %229)
  store double %230, ptr %224, align 8
  %231 = add nuw nsw i64 %207, 1
  %232 = icmp eq i64 %231, %48
  br i1 %232, label %233, label %206

233:                                              ; preds = %221, %124
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %4) #8
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %3) #8
  br label %309

234:                                              ; preds = %88, %85, %80
  %235 = load i64, ptr %23, align 8
  %236 = add i64 %235, -7046029254386353131
  store i64 %236, ptr %23, align 8
  %237 = lshr i64 %236, 30
  %238 = xor i64 %237, %236
  %239 = mul i64 %238, -4658895280553007687
  %240 = lshr i64 %239, 27
  %241 = xor i64 %240, %239
  %242 = mul i64 %241, -7723592293110705685
  %243 = lshr i64 %242, 42
  %244 = lshr i64 %242, 11
  %245 = xor i64 %243, %244
  %246 = uitofp i64 %245 to double
  %247 = fmul double %246, 0x3CA0000000000000
  %248 = load double, ptr %24, align 8
  %249 = fcmp olt double %247, %248
  br i1 %249, label %250, label %265

250:                                              ; preds = %234
  %251 = load double, ptr %25, align 8
  %252 = add i64 %235, 4354685564936845354
  store i64 %252, ptr %23, align 8
  %253 = lshr i64 %252, 30
  %254 = xor i64 %253, %252
  %255 = mul i64 %254, -4658895280553007687
  %256 = lshr i64 %255, 27
  %257 = xor i64 %256, %255
  %258 = mul i64 %257, -7723592293110705685
  %259 = lshr i64 %258, 42
  %260 = lshr i64 %258, 11
  %261 = xor i64 %259, %260
  %262 = uitofp i64 %261 to double
  %263 = fmul double %262, 0x3CA0000000000000
  %264 = fmul double %263, %251
  br label %265

265:                                              ; preds = %250, %234
  %266 = phi i64 [ %252, %250 ], [ %236, %234 ]
  %267 = phi double [ %264, %250 ], [ 0x7FF0000000000000, %234 ]
  br i1 %49, label %268, label %309

268:                                              ; preds = %265
  %269 = load ptr, ptr %26, align 8
  %270 = load ptr, ptr %27, align 8
  %271 = load ptr, ptr %15, align 8
  %272 = load ptr, ptr %14, align 8
  br label %273

273:                                              ; preds = %273, %268
  %274 = phi i64 [ %266, %268 ], [ %290, %273 ]
  %275 = phi i64 [ 0, %268 ], [ %306, %273 ]
  %276 = getelementptr inbounds double, ptr %269, i64 %275
  %277 = load double, ptr %276, align 8
  %278 = getelementptr inbounds double, ptr %270, i64 %275
  %279 = load double, ptr %278, align 8
  %280 = getelementptr inbounds double, ptr %271, i64 %275
  %281 = load double, ptr %280, align 8
  %282 = tail call double @llvm.minnum.f64(double %277, double %279)
  %283 = fsub double %282, %267
  %284 = tail call double @llvm.maxnum.f64(double %281, double %283)
  %285 = getelementptr inbounds double, ptr %272, i64 %275
  %286 = load double, ptr %285, align 8
  %287 = tail call double @llvm.maxnum.f64(double %277, double %279)
  %288 = fadd double %267, %287
  %289 = tail call double @llvm.minnum.f64(double %286, double %288)
  %290 = add i64 %274, -7046029254386353131
  %291 = lshr i64 %290, 30
  %292 = xor i64 %291, %290
  %293 = mul i64 %292, -4658895280553007687
  %294 = lshr i64 %293, 27
  %295 = xor i64 %294, %293
  %296 = mul i64 %295, -7723592293110705685
  %297 = lshr i64 %296, 42
  %298 = lshr i64 %296, 11
  %299 = xor i64 %297, %298
  %300 = uitofp i64 %299 to double
  %301 = fmul double %300, 0x3CA0000000000000
  %302 = fsub double %289, %284
  %303 = fmul double %302, %301
  %304 = fadd double %284, %303
  %305 = getelementptr inbounds double, ptr %5, i64 %275
  store double %304, ptr %305, align 8
  %306 = add nuw nsw i64 %275, 1
  %307 = icmp eq i64 %306, %48
  br i1 %307, label %308, label %273

308:                                              ; preds = %273
  store i64 %290, ptr %23, align 8
  br label %309

309:                                              ; preds = %233, %265, %308
  %310 = phi i64 [ %125, %233 ], [ %266, %265 ], [ %290, %308 ]
  br i1 %84, label %311, label %325

311:                                              ; preds = %309
  %312 = add i64 %310, -7046029254386353131
  store i64 %312, ptr %23, align 8
  %313 = lshr i64 %312, 30
  %314 = xor i64 %313, %312
  %315 = mul i64 %314, -4658895280553007687
  %316 = lshr i64 %315, 27
  %317 = xor i64 %316, %315
  %318 = mul i64 %317, -7723592293110705685
  %319 = lshr i64 %318, 42
  %320 = lshr i64 %318, 11
  %321 = xor i64 %319, %320
  %322 = uitofp i64 %321 to double
  %323 = fmul double %322, 0x3CA0000000000000
  %324 = fmul double %83, %323
  br label %325

325:                                              ; preds = %309, %311
  %326 = phi double [ %324, %311 ], [ 0.000000e+00, %309 ]
  %327 = add nsw i64 %31, 1
  store i64 %327, ptr %6, align 8
  %328 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31, i64 %81
  %329 = load i64, ptr %328, align 8
  %330 = icmp sgt i64 %329, 0
  br i1 %330, label %331, label %375

331:                                              ; preds = %325
  %332 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %81
  %333 = load ptr, ptr %332, align 8
  %334 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %81
  %335 = fcmp oeq double %83, 0x7FF0000000000000
  br label %336

336:                                              ; preds = %370, %331
  %337 = phi i64 [ 0, %331 ], [ %372, %370 ]
  %338 = phi i64 [ 0, %331 ], [ %373, %370 ]
  %339 = phi double [ 0x7FF0000000000000, %331 ], [ %371, %370 ]
  %340 = mul nsw i64 %338, %48
  %341 = getelementptr inbounds double, ptr %333, i64 %340
  br i1 %49, label %345, label %342

342:                                              ; preds = %345, %336
  %343 = phi double [ 0.000000e+00, %336 ], [ %354, %345 ]
  %344 = fcmp olt double %343, %339
  br i1 %344, label %357, label %370

345:                                              ; preds = %336, %345
  %346 = phi i64 [ %355, %345 ], [ 0, %336 ]
  %347 = phi double [ %354, %345 ], [ 0.000000e+00, %336 ]
  %348 = getelementptr inbounds double, ptr %5, i64 %346
  %349 = load double, ptr %348, align 8
  %350 = getelementptr inbounds double, ptr %341, i64 %346
  %351 = load double, ptr %350, align 8
  %352 = fsub double %349, %351
  %353 = fmul double %352, %352
  %354 = fadd double %347, %353
  %355 = add nuw nsw i64 %346, 1
  %356 = icmp eq i64 %355, %48
  br i1 %356, label %342, label %345

357:                                              ; preds = %342
  %358 = icmp eq i64 %338, 0
  %359 = select i1 %358, i1 true, i1 %335
  br i1 %359, label %369, label %360

360:                                              ; preds = %357
  %361 = load ptr, ptr %334, align 8
  %362 = getelementptr inbounds double, ptr %361, i64 %338
  %363 = load double, ptr %362, align 8
  %364 = load double, ptr %22, align 8
  %365 = tail call double @llvm.sqrt.f64(double %343)
  %366 = fmul double %365, %364
  %367 = fadd double %363, %366
  %368 = fcmp ugt double %367, %326
  br i1 %368, label %370, label %369

369:                                              ; preds = %360, %357
  br label %370

370:                                              ; preds = %369, %360, %342
  %371 = phi double [ %343, %369 ], [ %339, %360 ], [ %339, %342 ]
  %372 = phi i64 [ %338, %369 ], [ %337, %360 ], [ %337, %342 ]
  %373 = add nuw nsw i64 %338, 1
  %374 = icmp eq i64 %373, %329
  br i1 %374, label %375, label %336

375:                                              ; preds = %370, %325
  %376 = phi i64 [ 0, %325 ], [ %372, %370 ]
  %377 = call fastcc i64 @extend(ptr noundef nonnull %0, i64 noundef %81, i64 noundef %376, ptr noundef nonnull %5)
  %378 = icmp slt i64 %377, 0
  br i1 %378, label %516, label %379

379:                                              ; preds = %375
  %380 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %81
  %381 = load ptr, ptr %380, align 8
  %382 = load i64, ptr %0, align 8
  %383 = mul nsw i64 %382, %377
  %384 = getelementptr inbounds double, ptr %381, i64 %383
  %385 = shl i64 %382, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 16 %5, ptr align 8 %384, i64 %385, i1 false)
  %386 = load double, ptr %21, align 8
  %387 = fcmp olt double %386, 0x7FF0000000000000
  br i1 %387, label %388, label %394

388:                                              ; preds = %379
  %389 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %81
  %390 = load ptr, ptr %389, align 8
  %391 = getelementptr inbounds double, ptr %390, i64 %377
  %392 = load double, ptr %391, align 8
  %393 = fsub double %386, %392
  br label %394

394:                                              ; preds = %379, %388
  %395 = phi double [ %393, %388 ], [ 0.000000e+00, %379 ]
  %396 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31, i64 %82
  %397 = load i64, ptr %396, align 8
  %398 = icmp sgt i64 %397, 0
  br i1 %398, label %399, label %446

399:                                              ; preds = %394
  %400 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %82
  %401 = load ptr, ptr %400, align 8
  %402 = icmp sgt i64 %382, 0
  %403 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %82
  %404 = fcmp oeq double %386, 0x7FF0000000000000
  br label %405

405:                                              ; preds = %439, %399
  %406 = phi i64 [ 0, %399 ], [ %441, %439 ]
  %407 = phi i64 [ 0, %399 ], [ %442, %439 ]
  %408 = phi double [ 0x7FF0000000000000, %399 ], [ %440, %439 ]
  %409 = mul nsw i64 %407, %382
  %410 = getelementptr inbounds double, ptr %401, i64 %409
  br i1 %402, label %414, label %411

411:                                              ; preds = %414, %405
  %412 = phi double [ 0.000000e+00, %405 ], [ %423, %414 ]
  %413 = fcmp olt double %412, %408
  br i1 %413, label %426, label %439

414:                                              ; preds = %405, %414
  %415 = phi i64 [ %424, %414 ], [ 0, %405 ]
  %416 = phi double [ %423, %414 ], [ 0.000000e+00, %405 ]
  %417 = getelementptr inbounds double, ptr %5, i64 %415
  %418 = load double, ptr %417, align 8
  %419 = getelementptr inbounds double, ptr %410, i64 %415
  %420 = load double, ptr %419, align 8
  %421 = fsub double %418, %420
  %422 = fmul double %421, %421
  %423 = fadd double %416, %422
  %424 = add nuw nsw i64 %415, 1
  %425 = icmp eq i64 %424, %382
  br i1 %425, label %411, label %414

426:                                              ; preds = %411
  %427 = icmp eq i64 %407, 0
  %428 = select i1 %427, i1 true, i1 %404
  br i1 %428, label %438, label %429

429:                                              ; preds = %426
  %430 = load ptr, ptr %403, align 8
  %431 = getelementptr inbounds double, ptr %430, i64 %407
  %432 = load double, ptr %431, align 8
  %433 = load double, ptr %22, align 8
  %434 = tail call double @llvm.sqrt.f64(double %412)
  %435 = fmul double %434, %433
  %436 = fadd double %432, %435
  %437 = fcmp ugt double %436, %395
  br i1 %437, label %439, label %438

438:                                              ; preds = %429, %426
  br label %439

439:                                              ; preds = %438, %429, %411
  %440 = phi double [ %412, %438 ], [ %408, %429 ], [ %408, %411 ]
  %441 = phi i64 [ %407, %438 ], [ %406, %429 ], [ %406, %411 ]
  %442 = add nuw nsw i64 %407, 1
  %443 = icmp eq i64 %442, %397
  br i1 %443, label %444, label %405

444:                                              ; preds = %439
  %445 = icmp sgt i64 %441, -1
  br i1 %445, label %446, label %511

446:                                              ; preds = %394, %444
  %447 = phi i64 [ %441, %444 ], [ 0, %394 ]
  %448 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %82
  br label %449

449:                                              ; preds = %446, %508
  %450 = phi i64 [ %447, %446 ], [ %509, %508 ]
  %451 = load ptr, ptr %448, align 8
  %452 = load i64, ptr %0, align 8
  %453 = mul nsw i64 %452, %450
  %454 = getelementptr inbounds double, ptr %451, i64 %453
  %455 = shl i64 %452, 3
  %456 = call i32 @bcmp(ptr %454, ptr nonnull %5, i64 %455)
  %457 = icmp eq i32 %456, 0
  br i1 %457, label %458, label %508

458:                                              ; preds = %449
  %459 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %81
  %460 = load ptr, ptr %459, align 8
  %461 = getelementptr inbounds %struct.Side, ptr %460, i64 %377
  %462 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %82
  %463 = load ptr, ptr %462, align 8
  %464 = getelementptr inbounds %struct.Side, ptr %463, i64 %450
  %465 = load double, ptr %21, align 8
  %466 = fcmp olt double %465, 0x7FF0000000000000
  br i1 %466, label %467, label %473

467:                                              ; preds = %458
  %468 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %82
  %469 = load ptr, ptr %468, align 8
  %470 = getelementptr inbounds double, ptr %469, i64 %450
  %471 = load double, ptr %470, align 8
  %472 = fcmp olt double %471, %395
  br i1 %472, label %473, label %511

473:                                              ; preds = %467, %458
  %474 = load i64, ptr %28, align 8
  %475 = icmp eq i64 %474, 0
  br i1 %475, label %505, label %476

476:                                              ; preds = %473
  %477 = getelementptr inbounds %struct.Side, ptr %460, i64 %377, i32 2
  %478 = load i64, ptr %477, align 8
  %479 = getelementptr inbounds %struct.Side, ptr %463, i64 %450, i32 2
  %480 = load i64, ptr %479, align 8
  %481 = add nsw i64 %480, %478
  %482 = load i8, ptr %461, align 8
  %483 = load i8, ptr %464, align 8
  %484 = xor i8 %483, %482
  %485 = getelementptr inbounds %struct.Side, ptr %460, i64 %377, i32 1
  %486 = load i8, ptr %485, align 1
  %487 = and i8 %484, %486
  %488 = getelementptr inbounds %struct.Side, ptr %463, i64 %450, i32 1
  %489 = load i8, ptr %488, align 1
  %490 = and i8 %487, %489
  %491 = icmp eq i8 %490, 0
  br i1 %491, label %499, label %492

492:                                              ; preds = %476, %492
  %493 = phi i32 [ %495, %492 ], [ 0, %476 ]
  %494 = phi i8 [ %497, %492 ], [ %490, %476 ]
  %495 = add nuw nsw i32 %493, 1
  %496 = add i8 %494, -1
  %497 = and i8 %496, %494
  %498 = icmp eq i8 %497, 0
  br i1 %498, label %499, label %492

499:                                              ; preds = %492, %476
  %500 = phi i32 [ 0, %476 ], [ %495, %492 ]
  %501 = sext i32 %500 to i64
  %502 = add nsw i64 %481, %501
  %503 = load i64, ptr %29, align 8
  %504 = icmp sgt i64 %502, %503
  br i1 %504, label %511, label %505

505:                                              ; preds = %499, %473
  %506 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 32, i64 %81
  store i64 %377, ptr %506, align 8
  %507 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 32, i64 %82
  store i64 %450, ptr %507, align 8
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %5) #8
  br label %519

508:                                              ; preds = %449
  %509 = call fastcc i64 @extend(ptr noundef nonnull %0, i64 noundef %82, i64 noundef %450, ptr noundef nonnull %5)
  %510 = icmp sgt i64 %509, -1
  br i1 %510, label %449, label %511

511:                                              ; preds = %508, %444, %499, %467
  %512 = load i64, ptr %17, align 8
  %513 = load i64, ptr %19, align 8
  %514 = icmp sgt i64 %512, %513
  %515 = zext i1 %514 to i64
  store i64 %515, ptr %20, align 8
  br label %516

516:                                              ; preds = %511, %375
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %5) #8
  %517 = load i64, ptr %6, align 8
  %518 = icmp slt i64 %517, %8
  br i1 %518, label %30, label %519

519:                                              ; preds = %76, %516, %53, %2, %505
  %520 = phi i32 [ 1, %505 ], [ 0, %2 ], [ 2, %76 ], [ 0, %516 ], [ 2, %53 ]
  ret i32 %520
}

define internal fastcc i64 @extend(ptr nocapture noundef %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3) unnamed_addr #0 {
  %5 = alloca %struct.Side, align 8
  %6 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %1
  %7 = load ptr, ptr %6, align 8
  %8 = load i64, ptr %0, align 8
  %9 = mul nsw i64 %8, %2
  %10 = getelementptr inbounds double, ptr %7, i64 %9
  %11 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31, i64 %1
  %12 = load i64, ptr %11, align 8
  %13 = mul nsw i64 %12, %8
  %14 = getelementptr inbounds double, ptr %7, i64 %13
  %15 = icmp sgt i64 %8, 0
  br i1 %15, label %16, label %33

16:                                               ; preds = %4, %16
  %17 = phi i64 [ %26, %16 ], [ 0, %4 ]
  %18 = phi double [ %25, %16 ], [ 0.000000e+00, %4 ]
  %19 = getelementptr inbounds double, ptr %3, i64 %17
  %20 = load double, ptr %19, align 8
  %21 = getelementptr inbounds double, ptr %10, i64 %17
  %22 = load double, ptr %21, align 8
  %23 = fsub double %20, %22
  %24 = fmul double %23, %23
  %25 = fadd double %18, %24
  %26 = add nuw nsw i64 %17, 1
  %27 = icmp eq i64 %26, %8
  br i1 %27, label %28, label %16

28:                                               ; preds = %16
  %29 = tail call double @llvm.sqrt.f64(double %25)
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 16
  %31 = load double, ptr %30, align 8
  %32 = fcmp ogt double %29, %31
  br i1 %32, label %37, label %51

33:                                               ; preds = %4
  %34 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 16
  %35 = load double, ptr %34, align 8
  %36 = fcmp olt double %35, 0.000000e+00
  br i1 %36, label %53, label %51

37:                                               ; preds = %28
  %38 = fdiv double %31, %29
  br label %39

39:                                               ; preds = %37, %39
  %40 = phi i64 [ %49, %39 ], [ 0, %37 ]
  %41 = getelementptr inbounds double, ptr %10, i64 %40
  %42 = load double, ptr %41, align 8
  %43 = getelementptr inbounds double, ptr %3, i64 %40
  %44 = load double, ptr %43, align 8
  %45 = fsub double %44, %42
  %46 = fmul double %38, %45
  %47 = fadd double %42, %46
  %48 = getelementptr inbounds double, ptr %14, i64 %40
  store double %47, ptr %48, align 8
  %49 = add nuw nsw i64 %40, 1
  %50 = icmp eq i64 %49, %8
  br i1 %50, label %53, label %39

51:                                               ; preds = %33, %28
  %52 = shl i64 %8, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %14, ptr align 8 %3, i64 %52, i1 false)
  br label %53

53:                                               ; preds = %39, %33, %51
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %5) #8
  %54 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %1
  %55 = load ptr, ptr %54, align 8
  %56 = getelementptr inbounds %struct.Side, ptr %55, i64 %2
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %5, ptr noundef nonnull align 8 dereferenceable(16) %56, i64 16, i1 false)
  %57 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21
  %58 = load double, ptr %57, align 8
  %59 = fcmp olt double %58, 0x7FF0000000000000
  br i1 %59, label %60, label %99

60:                                               ; preds = %53
  %61 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %1
  %62 = load ptr, ptr %61, align 8
  %63 = getelementptr inbounds double, ptr %62, i64 %2
  %64 = load double, ptr %63, align 8
  %65 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23
  %66 = load ptr, ptr %65, align 8
  %67 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24
  %68 = load ptr, ptr %67, align 8
  %69 = tail call double %66(ptr noundef %68, ptr noundef %10, ptr noundef %14) #8
  %70 = fadd double %64, %69
  %71 = load ptr, ptr %61, align 8
  %72 = getelementptr inbounds double, ptr %71, i64 %12
  store double %70, ptr %72, align 8
  %73 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22
  %74 = load double, ptr %73, align 8
  %75 = sub nsw i64 1, %1
  %76 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %75
  %77 = load ptr, ptr %76, align 8
  %78 = load i64, ptr %0, align 8
  %79 = icmp sgt i64 %78, 0
  br i1 %79, label %80, label %92

80:                                               ; preds = %60, %80
  %81 = phi i64 [ %90, %80 ], [ 0, %60 ]
  %82 = phi double [ %89, %80 ], [ 0.000000e+00, %60 ]
  %83 = getelementptr inbounds double, ptr %77, i64 %81
  %84 = load double, ptr %83, align 8
  %85 = getelementptr inbounds double, ptr %14, i64 %81
  %86 = load double, ptr %85, align 8
  %87 = fsub double %84, %86
  %88 = fmul double %87, %87
  %89 = fadd double %82, %88
  %90 = add nuw nsw i64 %81, 1
  %91 = icmp eq i64 %90, %78
  br i1 %91, label %92, label %80

92:                                               ; preds = %80, %60
  %93 = phi double [ 0.000000e+00, %60 ], [ %89, %80 ]
  %94 = tail call double @llvm.sqrt.f64(double %93)
  %95 = fmul double %74, %94
  %96 = fadd double %70, %95
  %97 = load double, ptr %57, align 8
  %98 = fcmp olt double %96, %97
  br i1 %98, label %99, label %120

99:                                               ; preds = %92, %53
  %100 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %101 = load i64, ptr %100, align 8
  %102 = icmp eq i64 %101, 0
  br i1 %102, label %109, label %103

103:                                              ; preds = %99
  %104 = sub nsw i64 1, %1
  %105 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %104
  %106 = load ptr, ptr %105, align 8
  %107 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %10, ptr noundef %14, ptr noundef nonnull %5, ptr noundef %106)
  %108 = icmp eq i32 %107, 0
  br i1 %108, label %120, label %109

109:                                              ; preds = %103, %99
  %110 = tail call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef %10, ptr noundef %14)
  %111 = icmp eq i32 %110, 0
  br i1 %111, label %120, label %112

112:                                              ; preds = %109
  %113 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 28, i64 %1
  %114 = load ptr, ptr %113, align 8
  %115 = getelementptr inbounds i64, ptr %114, i64 %12
  store i64 %2, ptr %115, align 8
  %116 = load ptr, ptr %54, align 8
  %117 = getelementptr inbounds %struct.Side, ptr %116, i64 %12
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %117, ptr noundef nonnull align 8 dereferenceable(16) %5, i64 16, i1 false)
  %118 = load i64, ptr %11, align 8
  %119 = add nsw i64 %118, 1
  store i64 %119, ptr %11, align 8
  br label %120

120:                                              ; preds = %109, %103, %92, %112
  %121 = phi i64 [ %12, %112 ], [ -1, %92 ], [ -1, %103 ], [ -1, %109 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %5) #8
  ret i64 %121
}

define dso_local i64 @manipplan_way(ptr nocapture noundef readonly %0, ptr noundef writeonly %1) local_unnamed_addr #3 {
  %3 = alloca [2 x i64], align 16
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %3) #8
  br label %9

4:                                                ; preds = %20
  %5 = load i64, ptr %3, align 16
  %6 = getelementptr inbounds [2 x i64], ptr %3, i64 0, i64 1
  %7 = load i64, ptr %6, align 8
  %8 = icmp eq ptr %1, null
  br i1 %8, label %75, label %28

9:                                                ; preds = %2, %20
  %10 = phi i1 [ true, %2 ], [ false, %20 ]
  %11 = phi i64 [ 0, %2 ], [ 1, %20 ]
  %12 = getelementptr inbounds [2 x i64], ptr %3, i64 0, i64 %11
  store i64 0, ptr %12, align 8
  %13 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 32, i64 %11
  %14 = load i64, ptr %13, align 8
  %15 = icmp sgt i64 %14, -1
  br i1 %15, label %16, label %20

16:                                               ; preds = %9
  %17 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 28, i64 %11
  %18 = load ptr, ptr %17, align 8
  br label %21

19:                                               ; preds = %21
  store i64 %24, ptr %12, align 8
  br label %20

20:                                               ; preds = %19, %9
  br i1 %10, label %9, label %4

21:                                               ; preds = %16, %21
  %22 = phi i64 [ 0, %16 ], [ %24, %21 ]
  %23 = phi i64 [ %14, %16 ], [ %26, %21 ]
  %24 = add nuw nsw i64 %22, 1
  %25 = getelementptr inbounds i64, ptr %18, i64 %23
  %26 = load i64, ptr %25, align 8
  %27 = icmp sgt i64 %26, -1
  br i1 %27, label %21, label %19

28:                                               ; preds = %4
  %29 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 32
  %30 = load i64, ptr %29, align 8
  %31 = icmp sgt i64 %30, -1
  br i1 %31, label %32, label %35

32:                                               ; preds = %28
  %33 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27
  %34 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 28
  br label %45

35:                                               ; preds = %45, %28
  %36 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 28, i64 1
  %37 = load ptr, ptr %36, align 8
  %38 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 32, i64 1
  %39 = load i64, ptr %38, align 8
  %40 = getelementptr inbounds i64, ptr %37, i64 %39
  %41 = load i64, ptr %40, align 8
  %42 = icmp sgt i64 %41, -1
  br i1 %42, label %43, label %75

43:                                               ; preds = %35
  %44 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 1
  br label %60

45:                                               ; preds = %32, %45
  %46 = phi i64 [ %30, %32 ], [ %58, %45 ]
  %47 = phi i64 [ %5, %32 ], [ %48, %45 ]
  %48 = add nsw i64 %47, -1
  %49 = load i64, ptr %0, align 8
  %50 = mul nsw i64 %49, %48
  %51 = getelementptr inbounds double, ptr %1, i64 %50
  %52 = load ptr, ptr %33, align 8
  %53 = mul nsw i64 %49, %46
  %54 = getelementptr inbounds double, ptr %52, i64 %53
  %55 = shl i64 %49, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %51, ptr align 8 %54, i64 %55, i1 false)
  %56 = load ptr, ptr %34, align 8
  %57 = getelementptr inbounds i64, ptr %56, i64 %46
  %58 = load i64, ptr %57, align 8
  %59 = icmp sgt i64 %58, -1
  br i1 %59, label %45, label %35

60:                                               ; preds = %43, %60
  %61 = phi i64 [ %41, %43 ], [ %73, %60 ]
  %62 = phi i64 [ %5, %43 ], [ %72, %60 ]
  %63 = load i64, ptr %0, align 8
  %64 = mul nsw i64 %63, %62
  %65 = getelementptr inbounds double, ptr %1, i64 %64
  %66 = load ptr, ptr %44, align 8
  %67 = mul nsw i64 %63, %61
  %68 = getelementptr inbounds double, ptr %66, i64 %67
  %69 = shl i64 %63, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 8 %65, ptr align 8 %68, i64 %69, i1 false)
  %70 = load ptr, ptr %36, align 8
  %71 = getelementptr inbounds i64, ptr %70, i64 %61
  %72 = add nsw i64 %62, 1
  %73 = load i64, ptr %71, align 8
  %74 = icmp sgt i64 %73, -1
  br i1 %74, label %60, label %75

75:                                               ; preds = %60, %35, %4
  %76 = add i64 %5, -1
  %77 = add i64 %76, %7
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %3) #8
  ret i64 %77
}

define dso_local i32 @manipplan_allowed(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, i64 noundef %2) local_unnamed_addr #0 {
  %4 = alloca %struct.Side, align 8
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %4) #8
  %5 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
  %6 = load ptr, ptr %5, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %4, ptr noundef nonnull align 8 dereferenceable(16) %6, i64 16, i1 false)
  %7 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %8 = load i64, ptr %7, align 8
  %9 = icmp eq i64 %8, 0
  br i1 %9, label %30, label %10

10:                                               ; preds = %3
  %11 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 1
  %12 = tail call i64 @llvm.smax.i64(i64 %2, i64 1)
  %13 = add nsw i64 %12, -1
  br label %14

14:                                               ; preds = %18, %10
  %15 = phi i64 [ %16, %18 ], [ 0, %10 ]
  %16 = add nuw nsw i64 %15, 1
  %17 = icmp eq i64 %15, %13
  br i1 %17, label %27, label %18

18:                                               ; preds = %14
  %19 = load i64, ptr %0, align 8
  %20 = mul nsw i64 %19, %15
  %21 = getelementptr inbounds double, ptr %1, i64 %20
  %22 = mul nsw i64 %19, %16
  %23 = getelementptr inbounds double, ptr %1, i64 %22
  %24 = load ptr, ptr %11, align 8
  %25 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %21, ptr noundef %23, ptr noundef nonnull %4, ptr noundef %24)
  %26 = icmp eq i32 %25, 0
  br i1 %26, label %27, label %14

27:                                               ; preds = %18, %14
  %28 = icmp sge i64 %16, %2
  %29 = zext i1 %28 to i32
  br label %30

30:                                               ; preds = %3, %27
  %31 = phi i32 [ 1, %3 ], [ %29, %27 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %4) #8
  ret i32 %31
}

define dso_local i32 @manipplan_clear(ptr nocapture noundef %0, ptr nocapture noundef readonly %1, ptr noundef %2) local_unnamed_addr #0 {
  %4 = tail call fastcc i32 @motion_is_free(ptr noundef %0, ptr noundef %1, ptr noundef %2)
  ret i32 %4
}

define dso_local i64 @manipplan_skip(ptr nocapture noundef %0, ptr noundef %1, ptr nocapture noundef %2, i64 noundef %3) local_unnamed_addr #0 {
  %5 = alloca %struct.Side, align 8
  %6 = alloca %struct.Side, align 8
  %7 = alloca %struct.Side, align 8
  %8 = load i64, ptr %0, align 8
  %9 = shl i64 %8, 3
  %10 = icmp sgt i64 %3, 2
  br i1 %10, label %11, label %24

11:                                               ; preds = %4
  %12 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %13 = getelementptr inbounds %struct.Side, ptr %6, i64 0, i32 2
  %14 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
  %15 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 1
  br label %16

16:                                               ; preds = %11, %92
  %17 = phi i64 [ 0, %11 ], [ %19, %92 ]
  %18 = phi i64 [ %3, %11 ], [ %93, %92 ]
  %19 = add nuw nsw i64 %17, 1
  %20 = add nsw i64 %18, -1
  %21 = icmp sgt i64 %20, %19
  br i1 %21, label %22, label %92

22:                                               ; preds = %16
  %23 = mul i64 %19, %9
  br label %26

24:                                               ; preds = %92, %4
  %25 = phi i64 [ %3, %4 ], [ %93, %92 ]
  ret i64 %25

26:                                               ; preds = %22, %89
  %27 = phi i64 [ %20, %22 ], [ %90, %89 ]
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %2, ptr align 8 %1, i64 %23, i1 false)
  %28 = load i64, ptr %0, align 8
  %29 = mul nsw i64 %28, %19
  %30 = getelementptr inbounds double, ptr %2, i64 %29
  %31 = mul nsw i64 %28, %27
  %32 = getelementptr inbounds double, ptr %1, i64 %31
  %33 = sub nsw i64 %18, %27
  %34 = mul i64 %33, %9
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %30, ptr align 8 %32, i64 %34, i1 false)
  %35 = load i64, ptr %0, align 8
  %36 = mul nsw i64 %35, %17
  %37 = getelementptr inbounds double, ptr %1, i64 %36
  %38 = mul nsw i64 %35, %27
  %39 = getelementptr inbounds double, ptr %1, i64 %38
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %6) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %6, i8 0, i64 16, i1 false)
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %7) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %7, i8 0, i64 16, i1 false)
  %40 = load i64, ptr %12, align 8
  %41 = icmp eq i64 %40, 0
  br i1 %41, label %42, label %43

42:                                               ; preds = %26
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %6) #8
  br label %77

43:                                               ; preds = %26
  %44 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %37, ptr noundef %37, ptr noundef nonnull %6, ptr noundef nonnull %7)
  %45 = icmp eq i32 %44, 0
  br i1 %45, label %49, label %46

46:                                               ; preds = %43
  %47 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %37, ptr noundef %39, ptr noundef nonnull %6, ptr noundef nonnull %7)
  %48 = icmp eq i32 %47, 0
  br i1 %48, label %49, label %50

49:                                               ; preds = %46, %43
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %6) #8
  br label %53

50:                                               ; preds = %46
  %51 = load i64, ptr %13, align 8
  %52 = icmp eq i64 %51, 0
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %6) #8
  br i1 %52, label %77, label %53

53:                                               ; preds = %49, %50
  %54 = add nuw nsw i64 %33, %17
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %5) #8
  %55 = load ptr, ptr %14, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %5, ptr noundef nonnull align 8 dereferenceable(16) %55, i64 16, i1 false)
  %56 = load i64, ptr %12, align 8
  %57 = icmp eq i64 %56, 0
  br i1 %57, label %58, label %59

58:                                               ; preds = %53
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %5) #8
  br label %77

59:                                               ; preds = %53
  %60 = tail call i64 @llvm.smax.i64(i64 %54, i64 0)
  br label %61

61:                                               ; preds = %65, %59
  %62 = phi i64 [ %66, %65 ], [ 0, %59 ]
  %63 = icmp eq i64 %62, %60
  br i1 %63, label %64, label %65

64:                                               ; preds = %61
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %5) #8
  br label %77

65:                                               ; preds = %61
  %66 = add nuw nsw i64 %62, 1
  %67 = load i64, ptr %0, align 8
  %68 = mul nsw i64 %67, %62
  %69 = getelementptr inbounds double, ptr %2, i64 %68
  %70 = mul nsw i64 %67, %66
  %71 = getelementptr inbounds double, ptr %2, i64 %70
  %72 = load ptr, ptr %15, align 8
  %73 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %69, ptr noundef %71, ptr noundef nonnull %5, ptr noundef %72)
  %74 = icmp eq i32 %73, 0
  br i1 %74, label %75, label %61

75:                                               ; preds = %65
  %76 = icmp slt i64 %62, %54
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %5) #8
  br i1 %76, label %89, label %77

77:                                               ; preds = %64, %58, %42, %75, %50
  %78 = load i64, ptr %0, align 8
  %79 = mul nsw i64 %78, %17
  %80 = getelementptr inbounds double, ptr %1, i64 %79
  %81 = mul nsw i64 %78, %27
  %82 = getelementptr inbounds double, ptr %1, i64 %81
  %83 = tail call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef %80, ptr noundef %82)
  %84 = icmp eq i32 %83, 0
  br i1 %84, label %89, label %85

85:                                               ; preds = %77
  %86 = add i64 %19, %18
  %87 = sub i64 %86, %27
  %88 = mul i64 %87, %9
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1, ptr align 8 %2, i64 %88, i1 false)
  br label %92

89:                                               ; preds = %77, %75
  %90 = add nsw i64 %27, -1
  %91 = icmp sgt i64 %90, %19
  br i1 %91, label %26, label %92

92:                                               ; preds = %89, %16, %85
  %93 = phi i64 [ %87, %85 ], [ %18, %16 ], [ %18, %89 ]
  %94 = add nuw nsw i64 %17, 3
  %95 = icmp slt i64 %94, %93
  br i1 %95, label %16, label %24
}

define dso_local i64 @manipplan_shorten(ptr nocapture noundef %0, ptr nocapture noundef %1, ptr nocapture noundef %2, i64 noundef %3, i64 noundef %4) local_unnamed_addr #0 {
  %6 = alloca %struct.Side, align 8
  %7 = alloca %struct.Side, align 8
  %8 = alloca %struct.Side, align 8
  %9 = alloca [2 x double], align 16
  %10 = alloca [2 x [64 x double]], align 16
  %11 = alloca [2 x i64], align 16
  %12 = load i64, ptr %0, align 8
  %13 = shl i64 %12, 3
  %14 = icmp sgt i64 %4, 0
  %15 = icmp sgt i64 %3, 2
  %16 = and i1 %14, %15
  br i1 %16, label %17, label %39

17:                                               ; preds = %5
  %18 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25
  %19 = getelementptr inbounds double, ptr %9, i64 1
  %20 = getelementptr inbounds [2 x i64], ptr %11, i64 0, i64 1
  %21 = getelementptr inbounds [2 x [64 x double]], ptr %10, i64 0, i64 1
  %22 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %23 = getelementptr inbounds %struct.Side, ptr %7, i64 0, i32 2
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
  %25 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 1
  %26 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  %27 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %28 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 13
  %29 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 34
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %31 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %32 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %33 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  br label %34

34:                                               ; preds = %307, %17
  %35 = phi i64 [ %3, %17 ], [ %308, %307 ]
  %36 = phi i64 [ 0, %17 ], [ %309, %307 ]
  %37 = load i64, ptr %0, align 8
  %38 = icmp sgt i64 %37, 0
  br label %70

39:                                               ; preds = %307, %5
  %40 = phi i64 [ %3, %5 ], [ %308, %307 ]
  ret i64 %40

41:                                               ; preds = %90
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %9) #8
  %42 = load i64, ptr %18, align 8
  %43 = add i64 %42, -7046029254386353131
  %44 = lshr i64 %43, 30
  %45 = xor i64 %44, %43
  %46 = mul i64 %45, -4658895280553007687
  %47 = lshr i64 %46, 27
  %48 = xor i64 %47, %46
  %49 = mul i64 %48, -7723592293110705685
  %50 = lshr i64 %49, 42
  %51 = lshr i64 %49, 11
  %52 = xor i64 %50, %51
  %53 = uitofp i64 %52 to double
  %54 = fmul double %53, 0x3CA0000000000000
  %55 = fmul double %93, %54
  store double %55, ptr %9, align 16
  %56 = add i64 %42, 4354685564936845354
  store i64 %56, ptr %18, align 8
  %57 = lshr i64 %56, 30
  %58 = xor i64 %57, %56
  %59 = mul i64 %58, -4658895280553007687
  %60 = lshr i64 %59, 27
  %61 = xor i64 %60, %59
  %62 = mul i64 %61, -7723592293110705685
  %63 = lshr i64 %62, 42
  %64 = lshr i64 %62, 11
  %65 = xor i64 %63, %64
  %66 = uitofp i64 %65 to double
  %67 = fmul double %66, 0x3CA0000000000000
  %68 = fmul double %93, %67
  store double %68, ptr %19, align 8
  call void @llvm.lifetime.start.p0(i64 1024, ptr nonnull %10) #8
  %69 = fcmp ogt double %55, %68
  br i1 %69, label %96, label %97

70:                                               ; preds = %34, %90
  %71 = phi i64 [ 1, %34 ], [ %94, %90 ]
  %72 = phi double [ 0.000000e+00, %34 ], [ %93, %90 ]
  %73 = phi i64 [ 0, %34 ], [ %71, %90 ]
  %74 = mul nsw i64 %37, %73
  %75 = getelementptr inbounds double, ptr %1, i64 %74
  %76 = mul nsw i64 %37, %71
  %77 = getelementptr inbounds double, ptr %1, i64 %76
  br i1 %38, label %78, label %90

78:                                               ; preds = %70, %78
  %79 = phi i64 [ %88, %78 ], [ 0, %70 ]
  %80 = phi double [ %87, %78 ], [ 0.000000e+00, %70 ]
  %81 = getelementptr inbounds double, ptr %77, i64 %79
  %82 = load double, ptr %81, align 8
  %83 = getelementptr inbounds double, ptr %75, i64 %79
  %84 = load double, ptr %83, align 8
  %85 = fsub double %82, %84
  %86 = fmul double %85, %85
  %87 = fadd double %80, %86
  %88 = add nuw nsw i64 %79, 1
  %89 = icmp eq i64 %88, %37
  br i1 %89, label %90, label %78

90:                                               ; preds = %78, %70
  %91 = phi double [ 0.000000e+00, %70 ], [ %87, %78 ]
  %92 = call double @llvm.sqrt.f64(double %91)
  %93 = fadd double %72, %92
  %94 = add nuw nsw i64 %71, 1
  %95 = icmp eq i64 %94, %35
  br i1 %95, label %41, label %70

96:                                               ; preds = %41
  store double %68, ptr %9, align 16
  store double %55, ptr %19, align 8
  br label %97

97:                                               ; preds = %41, %96
  %98 = phi double [ %55, %96 ], [ %68, %41 ]
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %11) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(16) %11, i8 -1, i64 16, i1 false)
  %99 = load i64, ptr %0, align 8
  %100 = icmp sgt i64 %99, 0
  br label %104

101:                                              ; preds = %130
  %102 = load i64, ptr %11, align 16
  %103 = icmp eq i64 %102, %133
  br i1 %103, label %307, label %167

104:                                              ; preds = %97, %130
  %105 = phi i64 [ 1, %97 ], [ %131, %130 ]
  %106 = phi i64 [ 0, %97 ], [ %105, %130 ]
  %107 = phi double [ 0.000000e+00, %97 ], [ %126, %130 ]
  %108 = mul nsw i64 %99, %106
  %109 = getelementptr inbounds double, ptr %1, i64 %108
  %110 = getelementptr inbounds double, ptr %109, i64 %99
  br i1 %100, label %111, label %123

111:                                              ; preds = %104, %111
  %112 = phi i64 [ %121, %111 ], [ 0, %104 ]
  %113 = phi double [ %120, %111 ], [ 0.000000e+00, %104 ]
  %114 = getelementptr inbounds double, ptr %110, i64 %112
  %115 = load double, ptr %114, align 8
  %116 = getelementptr inbounds double, ptr %109, i64 %112
  %117 = load double, ptr %116, align 8
  %118 = fsub double %115, %117
  %119 = fmul double %118, %118
  %120 = fadd double %113, %119
  %121 = add nuw nsw i64 %112, 1
  %122 = icmp eq i64 %121, %99
  br i1 %122, label %123, label %111

123:                                              ; preds = %111, %104
  %124 = phi double [ 0.000000e+00, %104 ], [ %120, %111 ]
  %125 = call double @llvm.sqrt.f64(double %124)
  %126 = fadd double %107, %125
  %127 = add nuw nsw i64 %106, 2
  %128 = icmp eq i64 %127, %35
  %129 = fcmp ogt double %125, 0.000000e+00
  br label %136

130:                                              ; preds = %166
  %131 = add nuw nsw i64 %105, 1
  %132 = icmp slt i64 %131, %35
  %133 = load i64, ptr %20, align 8
  %134 = icmp slt i64 %133, 0
  %135 = select i1 %132, i1 %134, i1 false
  br i1 %135, label %104, label %101

136:                                              ; preds = %123, %166
  %137 = phi i1 [ true, %123 ], [ false, %166 ]
  %138 = phi i64 [ 0, %123 ], [ 1, %166 ]
  %139 = getelementptr inbounds [2 x i64], ptr %11, i64 0, i64 %138
  %140 = load i64, ptr %139, align 8
  %141 = icmp slt i64 %140, 0
  br i1 %141, label %142, label %166

142:                                              ; preds = %136
  %143 = getelementptr inbounds [2 x double], ptr %9, i64 0, i64 %138
  %144 = load double, ptr %143, align 8
  %145 = fcmp olt double %144, %126
  %146 = select i1 %145, i1 true, i1 %128
  br i1 %146, label %147, label %166

147:                                              ; preds = %142
  %148 = fsub double %144, %107
  %149 = fdiv double %148, %125
  %150 = select i1 %129, double %149, double 0.000000e+00
  store i64 %106, ptr %139, align 8
  %151 = call double @llvm.maxnum.f64(double %150, double 0.000000e+00)
  %152 = call double @llvm.minnum.f64(double %151, double 1.000000e+00)
  %153 = getelementptr inbounds [2 x [64 x double]], ptr %10, i64 0, i64 %138
  br i1 %100, label %154, label %166

154:                                              ; preds = %147, %154
  %155 = phi i64 [ %164, %154 ], [ 0, %147 ]
  %156 = getelementptr inbounds double, ptr %109, i64 %155
  %157 = load double, ptr %156, align 8
  %158 = getelementptr inbounds double, ptr %110, i64 %155
  %159 = load double, ptr %158, align 8
  %160 = fsub double %159, %157
  %161 = fmul double %152, %160
  %162 = fadd double %157, %161
  %163 = getelementptr inbounds double, ptr %153, i64 %155
  store double %162, ptr %163, align 8
  %164 = add nuw nsw i64 %155, 1
  %165 = icmp eq i64 %164, %99
  br i1 %165, label %166, label %154

166:                                              ; preds = %154, %147, %142, %136
  br i1 %137, label %136, label %130

167:                                              ; preds = %101
  %168 = load double, ptr %9, align 16
  %169 = fsub double %98, %168
  %170 = load i64, ptr %0, align 8
  %171 = icmp sgt i64 %170, 0
  br i1 %171, label %172, label %184

172:                                              ; preds = %167, %172
  %173 = phi i64 [ %182, %172 ], [ 0, %167 ]
  %174 = phi double [ %181, %172 ], [ 0.000000e+00, %167 ]
  %175 = getelementptr inbounds double, ptr %21, i64 %173
  %176 = load double, ptr %175, align 8
  %177 = getelementptr inbounds double, ptr %10, i64 %173
  %178 = load double, ptr %177, align 8
  %179 = fsub double %176, %178
  %180 = fmul double %179, %179
  %181 = fadd double %174, %180
  %182 = add nuw nsw i64 %173, 1
  %183 = icmp eq i64 %182, %170
  br i1 %183, label %184, label %172

184:                                              ; preds = %172, %167
  %185 = phi double [ 0.000000e+00, %167 ], [ %181, %172 ]
  %186 = call double @llvm.sqrt.f64(double %185)
  %187 = fsub double %169, %186
  %188 = fmul double %93, 1.000000e-02
  %189 = fcmp olt double %187, %188
  br i1 %189, label %307, label %190

190:                                              ; preds = %184
  %191 = add nsw i64 %102, 1
  %192 = mul i64 %191, %13
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %2, ptr align 8 %1, i64 %192, i1 false)
  %193 = add nsw i64 %102, 2
  %194 = load i64, ptr %0, align 8
  %195 = mul nsw i64 %194, %191
  %196 = getelementptr inbounds double, ptr %2, i64 %195
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %196, ptr nonnull align 16 %10, i64 %13, i1 false)
  %197 = add nsw i64 %102, 3
  %198 = load i64, ptr %0, align 8
  %199 = mul nsw i64 %198, %193
  %200 = getelementptr inbounds double, ptr %2, i64 %199
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %200, ptr nonnull align 16 %21, i64 %13, i1 false)
  %201 = load i64, ptr %0, align 8
  %202 = mul nsw i64 %201, %197
  %203 = getelementptr inbounds double, ptr %2, i64 %202
  %204 = add nsw i64 %133, 1
  %205 = mul nsw i64 %201, %204
  %206 = getelementptr inbounds double, ptr %1, i64 %205
  %207 = xor i64 %133, -1
  %208 = add i64 %35, %207
  %209 = mul i64 %208, %13
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %203, ptr align 8 %206, i64 %209, i1 false)
  %210 = add nsw i64 %197, %208
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %7) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %7, i8 0, i64 16, i1 false)
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %8, i8 0, i64 16, i1 false)
  %211 = load i64, ptr %22, align 8
  %212 = icmp eq i64 %211, 0
  br i1 %212, label %213, label %214

213:                                              ; preds = %190
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  br label %247

214:                                              ; preds = %190
  %215 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef nonnull %10, ptr noundef nonnull %10, ptr noundef nonnull %7, ptr noundef nonnull %8)
  %216 = icmp eq i32 %215, 0
  br i1 %216, label %220, label %217

217:                                              ; preds = %214
  %218 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef nonnull %10, ptr noundef nonnull %21, ptr noundef nonnull %7, ptr noundef nonnull %8)
  %219 = icmp eq i32 %218, 0
  br i1 %219, label %220, label %221

220:                                              ; preds = %217, %214
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  br label %224

221:                                              ; preds = %217
  %222 = load i64, ptr %23, align 8
  %223 = icmp eq i64 %222, 0
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  br i1 %223, label %247, label %224

224:                                              ; preds = %220, %221
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %6) #8
  %225 = load ptr, ptr %24, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %6, ptr noundef nonnull align 8 dereferenceable(16) %225, i64 16, i1 false)
  %226 = load i64, ptr %22, align 8
  %227 = icmp eq i64 %226, 0
  br i1 %227, label %228, label %229

228:                                              ; preds = %224
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %6) #8
  br label %247

229:                                              ; preds = %224
  %230 = call i64 @llvm.smax.i64(i64 %210, i64 1)
  %231 = add nsw i64 %230, -1
  br label %232

232:                                              ; preds = %236, %229
  %233 = phi i64 [ %234, %236 ], [ 0, %229 ]
  %234 = add nuw nsw i64 %233, 1
  %235 = icmp eq i64 %233, %231
  br i1 %235, label %245, label %236

236:                                              ; preds = %232
  %237 = load i64, ptr %0, align 8
  %238 = mul nsw i64 %237, %233
  %239 = getelementptr inbounds double, ptr %2, i64 %238
  %240 = mul nsw i64 %237, %234
  %241 = getelementptr inbounds double, ptr %2, i64 %240
  %242 = load ptr, ptr %25, align 8
  %243 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %239, ptr noundef %241, ptr noundef nonnull %6, ptr noundef %242)
  %244 = icmp eq i32 %243, 0
  br i1 %244, label %245, label %232

245:                                              ; preds = %232, %236
  %246 = icmp slt i64 %234, %210
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %6) #8
  br i1 %246, label %307, label %247

247:                                              ; preds = %228, %213, %245, %221
  %248 = load ptr, ptr %26, align 8
  %249 = load i64, ptr %27, align 8
  %250 = getelementptr inbounds double, ptr %248, i64 %249
  %251 = load double, ptr %250, align 8
  br label %261

252:                                              ; preds = %292
  %253 = load i64, ptr %29, align 8
  %254 = add nsw i64 %253, 1
  store i64 %254, ptr %29, align 8
  %255 = load ptr, ptr %30, align 8
  %256 = load ptr, ptr %31, align 8
  %257 = load double, ptr %32, align 8
  %258 = fadd double %293, %257
  %259 = call i32 %255(ptr noundef %256, ptr noundef nonnull %10, double noundef %258) #8
  %260 = icmp eq i32 %259, 2
  br i1 %260, label %294, label %299

261:                                              ; preds = %292, %247
  %262 = phi i1 [ true, %247 ], [ false, %292 ]
  %263 = phi i64 [ 0, %247 ], [ 1, %292 ]
  %264 = phi double [ %251, %247 ], [ %293, %292 ]
  %265 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 12, i64 %263
  %266 = load double, ptr %265, align 8
  %267 = fcmp ogt double %264, %266
  br i1 %267, label %268, label %292

268:                                              ; preds = %261
  %269 = load double, ptr %28, align 8
  %270 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %263
  %271 = load ptr, ptr %270, align 8
  %272 = load i64, ptr %0, align 8
  %273 = icmp sgt i64 %272, 0
  br i1 %273, label %274, label %286

274:                                              ; preds = %268, %274
  %275 = phi i64 [ %284, %274 ], [ 0, %268 ]
  %276 = phi double [ %283, %274 ], [ 0.000000e+00, %268 ]
  %277 = getelementptr inbounds double, ptr %271, i64 %275
  %278 = load double, ptr %277, align 8
  %279 = getelementptr inbounds double, ptr %10, i64 %275
  %280 = load double, ptr %279, align 8
  %281 = fsub double %278, %280
  %282 = fmul double %281, %281
  %283 = fadd double %276, %282
  %284 = add nuw nsw i64 %275, 1
  %285 = icmp eq i64 %284, %272
  br i1 %285, label %286, label %274

286:                                              ; preds = %274, %268
  %287 = phi double [ 0.000000e+00, %268 ], [ %283, %274 ]
  %288 = call double @llvm.sqrt.f64(double %287)
  %289 = fmul double %269, %288
  %290 = fadd double %266, %289
  %291 = call double @llvm.minnum.f64(double %264, double %290)
  br label %292

292:                                              ; preds = %286, %261
  %293 = phi double [ %291, %286 ], [ %264, %261 ]
  br i1 %262, label %261, label %252

294:                                              ; preds = %252
  %295 = load ptr, ptr %33, align 8
  %296 = load double, ptr %32, align 8
  %297 = fadd double %293, %296
  %298 = call i32 %295(ptr noundef nonnull %10, double noundef %297) #8
  br label %299

299:                                              ; preds = %252, %294
  %300 = phi i32 [ %298, %294 ], [ %259, %252 ]
  %301 = icmp eq i32 %300, 0
  br i1 %301, label %302, label %307

302:                                              ; preds = %299
  %303 = call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef nonnull %10, ptr noundef nonnull %21)
  %304 = icmp eq i32 %303, 0
  br i1 %304, label %307, label %305

305:                                              ; preds = %302
  %306 = mul i64 %210, %13
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1, ptr align 8 %2, i64 %306, i1 false)
  br label %307

307:                                              ; preds = %305, %245, %302, %299, %101, %184
  %308 = phi i64 [ %35, %184 ], [ %35, %101 ], [ %210, %305 ], [ %35, %245 ], [ %35, %302 ], [ %35, %299 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %11) #8
  call void @llvm.lifetime.end.p0(i64 1024, ptr nonnull %10) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %9) #8
  %309 = add nuw nsw i64 %36, 1
  %310 = icmp slt i64 %309, %4
  %311 = icmp sgt i64 %308, 2
  %312 = select i1 %310, i1 %311, i1 false
  br i1 %312, label %34, label %39
}

declare double @llvm.maxnum.f64(double, double) #4

declare double @llvm.minnum.f64(double, double) #4

declare double @llvm.fabs.f64(double) #4

declare double @llvm.ceil.f64(double) #4

declare double @llvm.sqrt.f64(double) #4

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #5

declare i64 @llvm.smin.i64(i64, i64) #6

declare i32 @bcmp(ptr nocapture, ptr nocapture, i64) local_unnamed_addr #7

declare i64 @llvm.smax.i64(i64, i64) #6

attributes #0 = { nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #3 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #5 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #6 = { nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #7 = { nofree nounwind willreturn memory(argmem: read) }
attributes #8 = { nounwind }


