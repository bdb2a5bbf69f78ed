; connect.c 9cd6701fb670ca508bf20255e614462683fc698681db2c06491846e74dae98f4: written by make kernel

%struct.Side = type { i8, i8, i64 }
%struct.Search = type { i64, ptr, ptr, double, double, ptr, ptr, ptr, double, i64, ptr, ptr, [2 x double], double, ptr, i64, double, i64, ptr, ptr, i64, i64, i64, [2 x ptr], [2 x ptr], [2 x ptr], [2 x i64], [2 x i64], i64, i64 }

define dso_local i32 @manipplan_state(ptr nocapture noundef %0, ptr noundef %1) local_unnamed_addr #0 {
  %3 = alloca %struct.Side, align 8
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %3) #8
  %4 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25
  %5 = load ptr, ptr %4, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %3, ptr noundef nonnull align 8 dereferenceable(16) %5, i64 16, i1 false)
  %6 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %7 = load i64, ptr %6, align 8
  %8 = icmp eq i64 %7, 0
  br i1 %8, label %18, label %9

9:                                                ; preds = %2
  %10 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25, i64 1
  %11 = load ptr, ptr %10, align 8
  %12 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %1, ptr noundef %1, ptr noundef nonnull %3, ptr noundef %11)
  %13 = icmp eq i32 %12, 0
  br i1 %13, label %14, label %18

14:                                               ; preds = %9
  %15 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
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
  %27 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
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
  %48 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %41
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
  %12 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
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
  %26 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25
  %27 = load ptr, ptr %26, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %4, ptr noundef nonnull align 8 dereferenceable(16) %27, i64 16, i1 false)
  %28 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %29 = load i64, ptr %28, align 8
  %30 = icmp eq i64 %29, 0
  br i1 %30, label %40, label %31

31:                                               ; preds = %25
  %32 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25, i64 1
  %33 = load ptr, ptr %32, align 8
  %34 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %1, ptr noundef %2, ptr noundef nonnull %4, ptr noundef %33)
  %35 = icmp eq i32 %34, 0
  br i1 %35, label %36, label %40

36:                                               ; preds = %31
  %37 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
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
  %37 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
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
  %58 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %51
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
  %146 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %139
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

define dso_local i32 @manipplan_connect(ptr nocapture noundef %0, i64 noundef %1) local_unnamed_addr #0 {
  %3 = alloca [64 x double], align 16
  %4 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
  %5 = load i64, ptr %4, align 8
  %6 = add nsw i64 %5, %1
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %8, label %295

8:                                                ; preds = %2
  %9 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %10 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  %11 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %12 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %13 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %14 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 16
  %15 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26
  %16 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22
  %17 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26, i64 1
  %18 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 28
  %19 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21
  %20 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %21 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %22 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23
  %23 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 1
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %25 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20
  br label %26

26:                                               ; preds = %8, %292
  %27 = phi i64 [ %5, %8 ], [ %293, %292 ]
  %28 = load i64, ptr %10, align 8
  %29 = load i64, ptr %9, align 8
  %30 = add nsw i64 %29, 1
  %31 = icmp slt i64 %30, %28
  br i1 %31, label %32, label %43

32:                                               ; preds = %26
  %33 = load ptr, ptr %11, align 8
  br label %34

34:                                               ; preds = %40, %32
  %35 = phi i64 [ %30, %32 ], [ %41, %40 ]
  %36 = phi i64 [ %29, %32 ], [ %35, %40 ]
  %37 = getelementptr inbounds i64, ptr %33, i64 %36
  %38 = load i64, ptr %37, align 8
  %39 = icmp slt i64 %27, %38
  br i1 %39, label %43, label %40

40:                                               ; preds = %34
  store i64 %35, ptr %9, align 8
  %41 = add i64 %35, 1
  %42 = icmp eq i64 %41, %28
  br i1 %42, label %43, label %34

43:                                               ; preds = %34, %40, %26
  %44 = load i64, ptr %0, align 8
  %45 = icmp sgt i64 %44, 0
  br i1 %45, label %46, label %49

46:                                               ; preds = %43
  %47 = load ptr, ptr %12, align 8
  %48 = load ptr, ptr %13, align 8
  br label %60

49:                                               ; preds = %60, %43
  %50 = phi double [ 0.000000e+00, %43 ], [ %69, %60 ]
  %51 = tail call double @llvm.sqrt.f64(double %50)
  %52 = load double, ptr %14, align 8
  %53 = fdiv double %51, %52
  %54 = fptosi double %53 to i64
  %55 = add nsw i64 %54, 3
  %56 = load i64, ptr %15, align 8
  %57 = add nsw i64 %55, %56
  %58 = load i64, ptr %16, align 8
  %59 = icmp sgt i64 %57, %58
  br i1 %59, label %295, label %72

60:                                               ; preds = %60, %46
  %61 = phi double [ 0.000000e+00, %46 ], [ %69, %60 ]
  %62 = phi i64 [ 0, %46 ], [ %70, %60 ]
  %63 = getelementptr inbounds double, ptr %47, i64 %62
  %64 = load double, ptr %63, align 8
  %65 = getelementptr inbounds double, ptr %48, i64 %62
  %66 = load double, ptr %65, align 8
  %67 = fsub double %64, %66
  %68 = fmul double %67, %67
  %69 = fadd double %61, %68
  %70 = add nuw nsw i64 %62, 1
  %71 = icmp eq i64 %70, %44
  br i1 %71, label %49, label %60

72:                                               ; preds = %49
  %73 = load i64, ptr %17, align 8
  %74 = add nsw i64 %73, %55
  %75 = icmp sgt i64 %74, %58
  br i1 %75, label %295, label %76

76:                                               ; preds = %72
  %77 = load i64, ptr %18, align 8
  %78 = sub nsw i64 1, %77
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %3) #8
  %79 = load i64, ptr %19, align 8
  %80 = add i64 %79, -7046029254386353131
  store i64 %80, ptr %19, align 8
  %81 = lshr i64 %80, 30
  %82 = xor i64 %81, %80
  %83 = mul i64 %82, -4658895280553007687
  %84 = lshr i64 %83, 27
  %85 = xor i64 %84, %83
  %86 = mul i64 %85, -7723592293110705685
  %87 = lshr i64 %86, 42
  %88 = lshr i64 %86, 11
  %89 = xor i64 %87, %88
  %90 = uitofp i64 %89 to double
  %91 = fmul double %90, 0x3CA0000000000000
  %92 = load double, ptr %20, align 8
  %93 = fcmp olt double %91, %92
  br i1 %93, label %94, label %109

94:                                               ; preds = %76
  %95 = load double, ptr %21, align 8
  %96 = add i64 %79, 4354685564936845354
  store i64 %96, ptr %19, align 8
  %97 = lshr i64 %96, 30
  %98 = xor i64 %97, %96
  %99 = mul i64 %98, -4658895280553007687
  %100 = lshr i64 %99, 27
  %101 = xor i64 %100, %99
  %102 = mul i64 %101, -7723592293110705685
  %103 = lshr i64 %102, 42
  %104 = lshr i64 %102, 11
  %105 = xor i64 %103, %104
  %106 = uitofp i64 %105 to double
  %107 = fmul double %106, 0x3CA0000000000000
  %108 = fmul double %107, %95
  br label %109

109:                                              ; preds = %94, %76
  %110 = phi i64 [ %96, %94 ], [ %80, %76 ]
  %111 = phi double [ %108, %94 ], [ 0x7FF0000000000000, %76 ]
  br i1 %45, label %112, label %153

112:                                              ; preds = %109
  %113 = load ptr, ptr %22, align 8
  %114 = load ptr, ptr %23, align 8
  %115 = load ptr, ptr %13, align 8
  %116 = load ptr, ptr %12, align 8
  br label %118

117:                                              ; preds = %118
  store i64 %135, ptr %19, align 8
  br label %153

118:                                              ; preds = %118, %112
  %119 = phi i64 [ %110, %112 ], [ %135, %118 ]
  %120 = phi i64 [ 0, %112 ], [ %151, %118 ]
  %121 = getelementptr inbounds double, ptr %113, i64 %120
  %122 = load double, ptr %121, align 8
  %123 = getelementptr inbounds double, ptr %114, i64 %120
  %124 = load double, ptr %123, align 8
  %125 = getelementptr inbounds double, ptr %115, i64 %120
  %126 = load double, ptr %125, align 8
  %127 = tail call double @llvm.minnum.f64(double %122, double %124)
  %128 = fsub double %127, %111
  %129 = tail call double @llvm.maxnum.f64(double %126, double %128)
  %130 = getelementptr inbounds double, ptr %116, i64 %120
  %131 = load double, ptr %130, align 8
  %132 = tail call double @llvm.maxnum.f64(double %122, double %124)
  %133 = fadd double %111, %132
  %134 = tail call double @llvm.minnum.f64(double %131, double %133)
  %135 = add i64 %119, -7046029254386353131
  %136 = lshr i64 %135, 30
  %137 = xor i64 %136, %135
  %138 = mul i64 %137, -4658895280553007687
  %139 = lshr i64 %138, 27
  %140 = xor i64 %139, %138
  %141 = mul i64 %140, -7723592293110705685
  %142 = lshr i64 %141, 42
  %143 = lshr i64 %141, 11
  %144 = xor i64 %142, %143
  %145 = uitofp i64 %144 to double
  %146 = fmul double %145, 0x3CA0000000000000
  %147 = fsub double %134, %129
  %148 = fmul double %147, %146
  %149 = fadd double %129, %148
  %150 = getelementptr inbounds double, ptr %3, i64 %120
  store double %149, ptr %150, align 8
  %151 = add nuw nsw i64 %120, 1
  %152 = icmp eq i64 %151, %44
  br i1 %152, label %117, label %118

153:                                              ; preds = %109, %117
  %154 = add nsw i64 %27, 1
  store i64 %154, ptr %4, align 8
  %155 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26, i64 %77
  %156 = load i64, ptr %155, align 8
  %157 = icmp sgt i64 %156, 0
  br i1 %157, label %158, label %186

158:                                              ; preds = %153
  %159 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %77
  %160 = load ptr, ptr %159, align 8
  br label %161

161:                                              ; preds = %167, %158
  %162 = phi i64 [ 0, %158 ], [ %171, %167 ]
  %163 = phi i64 [ 0, %158 ], [ %172, %167 ]
  %164 = phi double [ 0x7FF0000000000000, %158 ], [ %170, %167 ]
  %165 = mul nsw i64 %163, %44
  %166 = getelementptr inbounds double, ptr %160, i64 %165
  br i1 %45, label %174, label %167

167:                                              ; preds = %174, %161
  %168 = phi double [ 0.000000e+00, %161 ], [ %183, %174 ]
  %169 = fcmp olt double %168, %164
  %170 = select i1 %169, double %168, double %164
  %171 = select i1 %169, i64 %163, i64 %162
  %172 = add nuw nsw i64 %163, 1
  %173 = icmp eq i64 %172, %156
  br i1 %173, label %186, label %161

174:                                              ; preds = %161, %174
  %175 = phi i64 [ %184, %174 ], [ 0, %161 ]
  %176 = phi double [ %183, %174 ], [ 0.000000e+00, %161 ]
  %177 = getelementptr inbounds double, ptr %3, i64 %175
  %178 = load double, ptr %177, align 8
  %179 = getelementptr inbounds double, ptr %166, i64 %175
  %180 = load double, ptr %179, align 8
  %181 = fsub double %178, %180
  %182 = fmul double %181, %181
  %183 = fadd double %176, %182
  %184 = add nuw nsw i64 %175, 1
  %185 = icmp eq i64 %184, %44
  br i1 %185, label %167, label %174

186:                                              ; preds = %167, %153
  %187 = phi i64 [ 0, %153 ], [ %171, %167 ]
  %188 = call fastcc i64 @extend(ptr noundef nonnull %0, i64 noundef %77, i64 noundef %187, ptr noundef nonnull %3)
  %189 = icmp slt i64 %188, 0
  br i1 %189, label %292, label %190

190:                                              ; preds = %186
  %191 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %77
  %192 = load ptr, ptr %191, align 8
  %193 = load i64, ptr %0, align 8
  %194 = mul nsw i64 %193, %188
  %195 = getelementptr inbounds double, ptr %192, i64 %194
  %196 = shl i64 %193, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 16 %3, ptr align 8 %195, i64 %196, i1 false)
  %197 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26, i64 %78
  %198 = load i64, ptr %197, align 8
  %199 = icmp sgt i64 %198, 0
  br i1 %199, label %200, label %231

200:                                              ; preds = %190
  %201 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %78
  %202 = load ptr, ptr %201, align 8
  %203 = icmp sgt i64 %193, 0
  br label %204

204:                                              ; preds = %210, %200
  %205 = phi i64 [ 0, %200 ], [ %214, %210 ]
  %206 = phi i64 [ 0, %200 ], [ %215, %210 ]
  %207 = phi double [ 0x7FF0000000000000, %200 ], [ %213, %210 ]
  %208 = mul nsw i64 %206, %193
  %209 = getelementptr inbounds double, ptr %202, i64 %208
  br i1 %203, label %217, label %210

210:                                              ; preds = %217, %204
  %211 = phi double [ 0.000000e+00, %204 ], [ %226, %217 ]
  %212 = fcmp olt double %211, %207
  %213 = select i1 %212, double %211, double %207
  %214 = select i1 %212, i64 %206, i64 %205
  %215 = add nuw nsw i64 %206, 1
  %216 = icmp eq i64 %215, %198
  br i1 %216, label %229, label %204

217:                                              ; preds = %204, %217
  %218 = phi i64 [ %227, %217 ], [ 0, %204 ]
  %219 = phi double [ %226, %217 ], [ 0.000000e+00, %204 ]
  %220 = getelementptr inbounds double, ptr %3, i64 %218
  %221 = load double, ptr %220, align 8
  %222 = getelementptr inbounds double, ptr %209, i64 %218
  %223 = load double, ptr %222, align 8
  %224 = fsub double %221, %223
  %225 = fmul double %224, %224
  %226 = fadd double %219, %225
  %227 = add nuw nsw i64 %218, 1
  %228 = icmp eq i64 %227, %193
  br i1 %228, label %210, label %217

229:                                              ; preds = %210
  %230 = icmp sgt i64 %214, -1
  br i1 %230, label %231, label %287

231:                                              ; preds = %190, %229
  %232 = phi i64 [ %214, %229 ], [ 0, %190 ]
  %233 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %78
  br label %234

234:                                              ; preds = %231, %284
  %235 = phi i64 [ %232, %231 ], [ %285, %284 ]
  %236 = load ptr, ptr %233, align 8
  %237 = load i64, ptr %0, align 8
  %238 = mul nsw i64 %237, %235
  %239 = getelementptr inbounds double, ptr %236, i64 %238
  %240 = shl i64 %237, 3
  %241 = call i32 @bcmp(ptr %239, ptr nonnull %3, i64 %240)
  %242 = icmp eq i32 %241, 0
  br i1 %242, label %243, label %284

243:                                              ; preds = %234
  %244 = load i64, ptr %24, align 8
  %245 = icmp eq i64 %244, 0
  br i1 %245, label %281, label %246

246:                                              ; preds = %243
  %247 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25, i64 %78
  %248 = load ptr, ptr %247, align 8
  %249 = getelementptr inbounds %struct.Side, ptr %248, i64 %235
  %250 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25, i64 %77
  %251 = load ptr, ptr %250, align 8
  %252 = getelementptr inbounds %struct.Side, ptr %251, i64 %188
  %253 = getelementptr inbounds %struct.Side, ptr %251, i64 %188, i32 2
  %254 = load i64, ptr %253, align 8
  %255 = getelementptr inbounds %struct.Side, ptr %248, i64 %235, i32 2
  %256 = load i64, ptr %255, align 8
  %257 = add nsw i64 %256, %254
  %258 = load i8, ptr %252, align 8
  %259 = load i8, ptr %249, align 8
  %260 = xor i8 %259, %258
  %261 = getelementptr inbounds %struct.Side, ptr %251, i64 %188, i32 1
  %262 = load i8, ptr %261, align 1
  %263 = and i8 %260, %262
  %264 = getelementptr inbounds %struct.Side, ptr %248, i64 %235, i32 1
  %265 = load i8, ptr %264, align 1
  %266 = and i8 %263, %265
  %267 = icmp eq i8 %266, 0
  br i1 %267, label %275, label %268

268:                                              ; preds = %246, %268
  %269 = phi i32 [ %271, %268 ], [ 0, %246 ]
  %270 = phi i8 [ %273, %268 ], [ %266, %246 ]
  %271 = add nuw nsw i32 %269, 1
  %272 = add i8 %270, -1
  %273 = and i8 %272, %270
  %274 = icmp eq i8 %273, 0
  br i1 %274, label %275, label %268

275:                                              ; preds = %268, %246
  %276 = phi i32 [ 0, %246 ], [ %271, %268 ]
  %277 = sext i32 %276 to i64
  %278 = add nsw i64 %257, %277
  %279 = load i64, ptr %25, align 8
  %280 = icmp sgt i64 %278, %279
  br i1 %280, label %287, label %281

281:                                              ; preds = %275, %243
  %282 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %77
  store i64 %188, ptr %282, align 8
  %283 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %78
  store i64 %235, ptr %283, align 8
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %3) #8
  br label %295

284:                                              ; preds = %234
  %285 = call fastcc i64 @extend(ptr noundef nonnull %0, i64 noundef %78, i64 noundef %235, ptr noundef nonnull %3)
  %286 = icmp sgt i64 %285, -1
  br i1 %286, label %234, label %287

287:                                              ; preds = %284, %229, %275
  %288 = load i64, ptr %15, align 8
  %289 = load i64, ptr %17, align 8
  %290 = icmp sgt i64 %288, %289
  %291 = zext i1 %290 to i64
  store i64 %291, ptr %18, align 8
  br label %292

292:                                              ; preds = %186, %287
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %3) #8
  %293 = load i64, ptr %4, align 8
  %294 = icmp slt i64 %293, %6
  br i1 %294, label %26, label %295

295:                                              ; preds = %72, %292, %49, %2, %281
  %296 = phi i32 [ 1, %281 ], [ 0, %2 ], [ 2, %72 ], [ 0, %292 ], [ 2, %49 ]
  ret i32 %296
}

define internal fastcc i64 @extend(ptr nocapture noundef %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3) unnamed_addr #0 {
  %5 = alloca %struct.Side, align 8
  %6 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %1
  %7 = load ptr, ptr %6, align 8
  %8 = load i64, ptr %0, align 8
  %9 = mul nsw i64 %8, %2
  %10 = getelementptr inbounds double, ptr %7, i64 %9
  %11 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26, i64 %1
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
  %54 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25, i64 %1
  %55 = load ptr, ptr %54, align 8
  %56 = getelementptr inbounds %struct.Side, ptr %55, i64 %2
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %5, ptr noundef nonnull align 8 dereferenceable(16) %56, i64 16, i1 false)
  %57 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %58 = load i64, ptr %57, align 8
  %59 = icmp eq i64 %58, 0
  br i1 %59, label %66, label %60

60:                                               ; preds = %53
  %61 = sub nsw i64 1, %1
  %62 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25, i64 %61
  %63 = load ptr, ptr %62, align 8
  %64 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %10, ptr noundef %14, ptr noundef nonnull %5, ptr noundef %63)
  %65 = icmp eq i32 %64, 0
  br i1 %65, label %77, label %66

66:                                               ; preds = %60, %53
  %67 = tail call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef %10, ptr noundef %14)
  %68 = icmp eq i32 %67, 0
  br i1 %68, label %77, label %69

69:                                               ; preds = %66
  %70 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24, i64 %1
  %71 = load ptr, ptr %70, align 8
  %72 = getelementptr inbounds i64, ptr %71, i64 %12
  store i64 %2, ptr %72, align 8
  %73 = load ptr, ptr %54, align 8
  %74 = getelementptr inbounds %struct.Side, ptr %73, i64 %12
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %74, ptr noundef nonnull align 8 dereferenceable(16) %5, i64 16, i1 false)
  %75 = load i64, ptr %11, align 8
  %76 = add nsw i64 %75, 1
  store i64 %76, ptr %11, align 8
  br label %77

77:                                               ; preds = %66, %60, %69
  %78 = phi i64 [ %12, %69 ], [ -1, %60 ], [ -1, %66 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %5) #8
  ret i64 %78
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
  %13 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %11
  %14 = load i64, ptr %13, align 8
  %15 = icmp sgt i64 %14, -1
  br i1 %15, label %16, label %20

16:                                               ; preds = %9
  %17 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24, i64 %11
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
  %29 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27
  %30 = load i64, ptr %29, align 8
  %31 = icmp sgt i64 %30, -1
  br i1 %31, label %32, label %35

32:                                               ; preds = %28
  %33 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23
  %34 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24
  br label %45

35:                                               ; preds = %45, %28
  %36 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24, i64 1
  %37 = load ptr, ptr %36, align 8
  %38 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 1
  %39 = load i64, ptr %38, align 8
  %40 = getelementptr inbounds i64, ptr %37, i64 %39
  %41 = load i64, ptr %40, align 8
  %42 = icmp sgt i64 %41, -1
  br i1 %42, label %43, label %75

43:                                               ; preds = %35
  %44 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 1
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
  %14 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25
  %15 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25, i64 1
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
  %18 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21
  %19 = getelementptr inbounds double, ptr %9, i64 1
  %20 = getelementptr inbounds [2 x i64], ptr %11, i64 0, i64 1
  %21 = getelementptr inbounds [2 x [64 x double]], ptr %10, i64 0, i64 1
  %22 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %23 = getelementptr inbounds %struct.Side, ptr %7, i64 0, i32 2
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25
  %25 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25, i64 1
  %26 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  %27 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %28 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 13
  %29 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %31 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %32 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %33 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  br label %34

34:                                               ; preds = %283, %17
  %35 = phi i64 [ %3, %17 ], [ %284, %283 ]
  %36 = phi i64 [ 0, %17 ], [ %285, %283 ]
  %37 = load i64, ptr %0, align 8
  %38 = icmp sgt i64 %37, 0
  br label %70

39:                                               ; preds = %283, %5
  %40 = phi i64 [ %3, %5 ], [ %284, %283 ]
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
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %11) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(16) %11, i8 -1, i64 16, i1 false)
  %98 = load i64, ptr %0, align 8
  %99 = icmp sgt i64 %98, 0
  br label %103

100:                                              ; preds = %129
  %101 = load i64, ptr %11, align 16
  %102 = icmp eq i64 %101, %132
  br i1 %102, label %283, label %166

103:                                              ; preds = %97, %129
  %104 = phi i64 [ 1, %97 ], [ %130, %129 ]
  %105 = phi i64 [ 0, %97 ], [ %104, %129 ]
  %106 = phi double [ 0.000000e+00, %97 ], [ %125, %129 ]
  %107 = mul nsw i64 %98, %105
  %108 = getelementptr inbounds double, ptr %1, i64 %107
  %109 = getelementptr inbounds double, ptr %108, i64 %98
  br i1 %99, label %110, label %122

110:                                              ; preds = %103, %110
  %111 = phi i64 [ %120, %110 ], [ 0, %103 ]
  %112 = phi double [ %119, %110 ], [ 0.000000e+00, %103 ]
  %113 = getelementptr inbounds double, ptr %109, i64 %111
  %114 = load double, ptr %113, align 8
  %115 = getelementptr inbounds double, ptr %108, i64 %111
  %116 = load double, ptr %115, align 8
  %117 = fsub double %114, %116
  %118 = fmul double %117, %117
  %119 = fadd double %112, %118
  %120 = add nuw nsw i64 %111, 1
  %121 = icmp eq i64 %120, %98
  br i1 %121, label %122, label %110

122:                                              ; preds = %110, %103
  %123 = phi double [ 0.000000e+00, %103 ], [ %119, %110 ]
  %124 = call double @llvm.sqrt.f64(double %123)
  %125 = fadd double %106, %124
  %126 = add nuw nsw i64 %105, 2
  %127 = icmp eq i64 %126, %35
  %128 = fcmp ogt double %124, 0.000000e+00
  br label %135

129:                                              ; preds = %165
  %130 = add nuw nsw i64 %104, 1
  %131 = icmp slt i64 %130, %35
  %132 = load i64, ptr %20, align 8
  %133 = icmp slt i64 %132, 0
  %134 = select i1 %131, i1 %133, i1 false
  br i1 %134, label %103, label %100

135:                                              ; preds = %122, %165
  %136 = phi i1 [ true, %122 ], [ false, %165 ]
  %137 = phi i64 [ 0, %122 ], [ 1, %165 ]
  %138 = getelementptr inbounds [2 x i64], ptr %11, i64 0, i64 %137
  %139 = load i64, ptr %138, align 8
  %140 = icmp slt i64 %139, 0
  br i1 %140, label %141, label %165

141:                                              ; preds = %135
  %142 = getelementptr inbounds [2 x double], ptr %9, i64 0, i64 %137
  %143 = load double, ptr %142, align 8
  %144 = fcmp olt double %143, %125
  %145 = select i1 %144, i1 true, i1 %127
  br i1 %145, label %146, label %165

146:                                              ; preds = %141
  %147 = fsub double %143, %106
  %148 = fdiv double %147, %124
  %149 = select i1 %128, double %148, double 0.000000e+00
  store i64 %105, ptr %138, align 8
  %150 = call double @llvm.maxnum.f64(double %149, double 0.000000e+00)
  %151 = call double @llvm.minnum.f64(double %150, double 1.000000e+00)
  %152 = getelementptr inbounds [2 x [64 x double]], ptr %10, i64 0, i64 %137
  br i1 %99, label %153, label %165

153:                                              ; preds = %146, %153
  %154 = phi i64 [ %163, %153 ], [ 0, %146 ]
  %155 = getelementptr inbounds double, ptr %108, i64 %154
  %156 = load double, ptr %155, align 8
  %157 = getelementptr inbounds double, ptr %109, i64 %154
  %158 = load double, ptr %157, align 8
  %159 = fsub double %158, %156
  %160 = fmul double %151, %159
  %161 = fadd double %156, %160
  %162 = getelementptr inbounds double, ptr %152, i64 %154
  store double %161, ptr %162, align 8
  %163 = add nuw nsw i64 %154, 1
  %164 = icmp eq i64 %163, %98
  br i1 %164, label %165, label %153

165:                                              ; preds = %153, %146, %141, %135
  br i1 %136, label %135, label %129

166:                                              ; preds = %100
  %167 = add nsw i64 %101, 1
  %168 = mul i64 %167, %13
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %2, ptr align 8 %1, i64 %168, i1 false)
  %169 = add nsw i64 %101, 2
  %170 = load i64, ptr %0, align 8
  %171 = mul nsw i64 %170, %167
  %172 = getelementptr inbounds double, ptr %2, i64 %171
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %172, ptr nonnull align 16 %10, i64 %13, i1 false)
  %173 = add nsw i64 %101, 3
  %174 = load i64, ptr %0, align 8
  %175 = mul nsw i64 %174, %169
  %176 = getelementptr inbounds double, ptr %2, i64 %175
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %176, ptr nonnull align 16 %21, i64 %13, i1 false)
  %177 = load i64, ptr %0, align 8
  %178 = mul nsw i64 %177, %173
  %179 = getelementptr inbounds double, ptr %2, i64 %178
  %180 = add nsw i64 %132, 1
  %181 = mul nsw i64 %177, %180
  %182 = getelementptr inbounds double, ptr %1, i64 %181
  %183 = xor i64 %132, -1
  %184 = add i64 %35, %183
  %185 = mul i64 %184, %13
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %179, ptr align 8 %182, i64 %185, i1 false)
  %186 = add nsw i64 %173, %184
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %7) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %7, i8 0, i64 16, i1 false)
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %8, i8 0, i64 16, i1 false)
  %187 = load i64, ptr %22, align 8
  %188 = icmp eq i64 %187, 0
  br i1 %188, label %189, label %190

189:                                              ; preds = %166
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  br label %223

190:                                              ; preds = %166
  %191 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef nonnull %10, ptr noundef nonnull %10, ptr noundef nonnull %7, ptr noundef nonnull %8)
  %192 = icmp eq i32 %191, 0
  br i1 %192, label %196, label %193

193:                                              ; preds = %190
  %194 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef nonnull %10, ptr noundef nonnull %21, ptr noundef nonnull %7, ptr noundef nonnull %8)
  %195 = icmp eq i32 %194, 0
  br i1 %195, label %196, label %197

196:                                              ; preds = %193, %190
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  br label %200

197:                                              ; preds = %193
  %198 = load i64, ptr %23, align 8
  %199 = icmp eq i64 %198, 0
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  br i1 %199, label %223, label %200

200:                                              ; preds = %196, %197
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %6) #8
  %201 = load ptr, ptr %24, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %6, ptr noundef nonnull align 8 dereferenceable(16) %201, i64 16, i1 false)
  %202 = load i64, ptr %22, align 8
  %203 = icmp eq i64 %202, 0
  br i1 %203, label %204, label %205

204:                                              ; preds = %200
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %6) #8
  br label %223

205:                                              ; preds = %200
  %206 = call i64 @llvm.smax.i64(i64 %186, i64 1)
  %207 = add nsw i64 %206, -1
  br label %208

208:                                              ; preds = %212, %205
  %209 = phi i64 [ %210, %212 ], [ 0, %205 ]
  %210 = add nuw nsw i64 %209, 1
  %211 = icmp eq i64 %209, %207
  br i1 %211, label %221, label %212

212:                                              ; preds = %208
  %213 = load i64, ptr %0, align 8
  %214 = mul nsw i64 %213, %209
  %215 = getelementptr inbounds double, ptr %2, i64 %214
  %216 = mul nsw i64 %213, %210
  %217 = getelementptr inbounds double, ptr %2, i64 %216
  %218 = load ptr, ptr %25, align 8
  %219 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %215, ptr noundef %217, ptr noundef nonnull %6, ptr noundef %218)
  %220 = icmp eq i32 %219, 0
  br i1 %220, label %221, label %208

221:                                              ; preds = %208, %212
  %222 = icmp slt i64 %210, %186
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %6) #8
  br i1 %222, label %283, label %223

223:                                              ; preds = %204, %189, %221, %197
  %224 = load ptr, ptr %26, align 8
  %225 = load i64, ptr %27, align 8
  %226 = getelementptr inbounds double, ptr %224, i64 %225
  %227 = load double, ptr %226, align 8
  br label %237

228:                                              ; preds = %268
  %229 = load i64, ptr %29, align 8
  %230 = add nsw i64 %229, 1
  store i64 %230, ptr %29, align 8
  %231 = load ptr, ptr %30, align 8
  %232 = load ptr, ptr %31, align 8
  %233 = load double, ptr %32, align 8
  %234 = fadd double %269, %233
  %235 = call i32 %231(ptr noundef %232, ptr noundef nonnull %10, double noundef %234) #8
  %236 = icmp eq i32 %235, 2
  br i1 %236, label %270, label %275

237:                                              ; preds = %268, %223
  %238 = phi i1 [ true, %223 ], [ false, %268 ]
  %239 = phi i64 [ 0, %223 ], [ 1, %268 ]
  %240 = phi double [ %227, %223 ], [ %269, %268 ]
  %241 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 12, i64 %239
  %242 = load double, ptr %241, align 8
  %243 = fcmp ogt double %240, %242
  br i1 %243, label %244, label %268

244:                                              ; preds = %237
  %245 = load double, ptr %28, align 8
  %246 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %239
  %247 = load ptr, ptr %246, align 8
  %248 = load i64, ptr %0, align 8
  %249 = icmp sgt i64 %248, 0
  br i1 %249, label %250, label %262

250:                                              ; preds = %244, %250
  %251 = phi i64 [ %260, %250 ], [ 0, %244 ]
  %252 = phi double [ %259, %250 ], [ 0.000000e+00, %244 ]
  %253 = getelementptr inbounds double, ptr %247, i64 %251
  %254 = load double, ptr %253, align 8
  %255 = getelementptr inbounds double, ptr %10, i64 %251
  %256 = load double, ptr %255, align 8
  %257 = fsub double %254, %256
  %258 = fmul double %257, %257
  %259 = fadd double %252, %258
  %260 = add nuw nsw i64 %251, 1
  %261 = icmp eq i64 %260, %248
  br i1 %261, label %262, label %250

262:                                              ; preds = %250, %244
  %263 = phi double [ 0.000000e+00, %244 ], [ %259, %250 ]
  %264 = call double @llvm.sqrt.f64(double %263)
  %265 = fmul double %245, %264
  %266 = fadd double %242, %265
  %267 = call double @llvm.minnum.f64(double %240, double %266)
  br label %268

268:                                              ; preds = %262, %237
  %269 = phi double [ %267, %262 ], [ %240, %237 ]
  br i1 %238, label %237, label %228

270:                                              ; preds = %228
  %271 = load ptr, ptr %33, align 8
  %272 = load double, ptr %32, align 8
  %273 = fadd double %269, %272
  %274 = call i32 %271(ptr noundef nonnull %10, double noundef %273) #8
  br label %275

275:                                              ; preds = %228, %270
  %276 = phi i32 [ %274, %270 ], [ %235, %228 ]
  %277 = icmp eq i32 %276, 0
  br i1 %277, label %278, label %283

278:                                              ; preds = %275
  %279 = call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef nonnull %10, ptr noundef nonnull %21)
  %280 = icmp eq i32 %279, 0
  br i1 %280, label %283, label %281

281:                                              ; preds = %278
  %282 = mul i64 %186, %13
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1, ptr align 8 %2, i64 %282, i1 false)
  br label %283

283:                                              ; preds = %281, %221, %278, %275, %100
  %284 = phi i64 [ %35, %100 ], [ %186, %281 ], [ %35, %221 ], [ %35, %278 ], [ %35, %275 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %11) #8
  call void @llvm.lifetime.end.p0(i64 1024, ptr nonnull %10) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %9) #8
  %285 = add nuw nsw i64 %36, 1
  %286 = icmp slt i64 %285, %4
  %287 = icmp sgt i64 %284, 2
  %288 = select i1 %286, i1 %287, i1 false
  br i1 %288, label %34, label %39
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


