; connect.c 0f0e60f3819d1c6b15006bc43febbcbd2a8689d3e230379066726f5be6fbe60f: written by make kernel

%struct.Side = type { i8, i8, i64 }
%struct.Search = type { i64, ptr, ptr, double, double, ptr, ptr, ptr, double, i64, ptr, ptr, [2 x double], double, ptr, i64, double, i64, ptr, ptr, i64, double, double, ptr, ptr, i64, i64, [2 x ptr], [2 x ptr], [2 x ptr], [2 x ptr], [2 x i64], [2 x i64], i64, i64, ptr }
%struct.Constraints = type { i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr }

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
  br label %20

18:                                               ; preds = %9, %2
  %19 = tail call fastcc i32 @is_free(ptr noundef nonnull %0, ptr noundef %1)
  br label %20

20:                                               ; preds = %18, %14
  %21 = phi i32 [ %19, %18 ], [ 0, %14 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %3) #8
  ret i32 %21
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

define internal fastcc i32 @is_free(ptr nocapture noundef %0, ptr noundef %1) unnamed_addr #0 {
  %3 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %6 = load i64, ptr %5, align 8
  %7 = getelementptr inbounds double, ptr %4, i64 %6
  %8 = load double, ptr %7, align 8
  %9 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 13
  br label %17

10:                                               ; preds = %48
  %11 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 34
  %12 = load i64, ptr %11, align 8
  %13 = add nsw i64 %12, 1
  store i64 %13, ptr %11, align 8
  %14 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 35
  %15 = load ptr, ptr %14, align 8
  %16 = icmp eq ptr %15, null
  br i1 %16, label %53, label %50

17:                                               ; preds = %2, %48
  %18 = phi i1 [ true, %2 ], [ false, %48 ]
  %19 = phi i64 [ 0, %2 ], [ 1, %48 ]
  %20 = phi double [ %8, %2 ], [ %49, %48 ]
  %21 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 12, i64 %19
  %22 = load double, ptr %21, align 8
  %23 = fcmp ogt double %20, %22
  br i1 %23, label %24, label %48

24:                                               ; preds = %17
  %25 = load double, ptr %9, align 8
  %26 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %19
  %27 = load ptr, ptr %26, align 8
  %28 = load i64, ptr %0, align 8
  %29 = icmp sgt i64 %28, 0
  br i1 %29, label %30, label %42

30:                                               ; preds = %24, %30
  %31 = phi i64 [ %40, %30 ], [ 0, %24 ]
  %32 = phi double [ %39, %30 ], [ 0.000000e+00, %24 ]
  %33 = getelementptr inbounds double, ptr %27, i64 %31
  %34 = load double, ptr %33, align 8
  %35 = getelementptr inbounds double, ptr %1, i64 %31
  %36 = load double, ptr %35, align 8
  %37 = fsub double %34, %36
  %38 = fmul double %37, %37
  %39 = fadd double %32, %38
  %40 = add nuw nsw i64 %31, 1
  %41 = icmp eq i64 %40, %28
  br i1 %41, label %42, label %30

42:                                               ; preds = %30, %24
  %43 = phi double [ 0.000000e+00, %24 ], [ %39, %30 ]
  %44 = tail call double @llvm.sqrt.f64(double %43)
  %45 = fmul double %25, %44
  %46 = fadd double %22, %45
  %47 = tail call double @llvm.minnum.f64(double %20, double %46)
  br label %48

48:                                               ; preds = %17, %42
  %49 = phi double [ %47, %42 ], [ %20, %17 ]
  br i1 %18, label %17, label %10

50:                                               ; preds = %10
  %51 = tail call fastcc i32 @keeps(ptr noundef nonnull %15, ptr noundef %1)
  %52 = icmp eq i32 %51, 0
  br i1 %52, label %73, label %53

53:                                               ; preds = %50, %10
  %54 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %55 = load ptr, ptr %54, align 8
  %56 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %57 = load ptr, ptr %56, align 8
  %58 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %59 = load double, ptr %58, align 8
  %60 = fadd double %49, %59
  %61 = tail call i32 %55(ptr noundef %57, ptr noundef %1, double noundef %60) #8
  %62 = icmp eq i32 %61, 2
  br i1 %62, label %63, label %69

63:                                               ; preds = %53
  %64 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %65 = load ptr, ptr %64, align 8
  %66 = load double, ptr %58, align 8
  %67 = fadd double %49, %66
  %68 = tail call i32 %65(ptr noundef %1, double noundef %67) #8
  br label %69

69:                                               ; preds = %53, %63
  %70 = phi i32 [ %68, %63 ], [ %61, %53 ]
  %71 = icmp eq i32 %70, 0
  %72 = zext i1 %71 to i32
  br label %73

73:                                               ; preds = %50, %69
  %74 = phi i32 [ %72, %69 ], [ 0, %50 ]
  ret i32 %74
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
  %30 = tail call i64 @llvm.smax.i64(i64 %29, i64 1)
  %31 = tail call fastcc i32 @is_free(ptr noundef nonnull %0, ptr noundef %2)
  %32 = icmp eq i32 %31, 0
  br i1 %32, label %75, label %33

33:                                               ; preds = %19, %33
  %34 = phi i64 [ %35, %33 ], [ 1, %19 ]
  %35 = shl nsw i64 %34, 1
  %36 = icmp slt i64 %35, %30
  br i1 %36, label %33, label %37

37:                                               ; preds = %33
  %38 = icmp ugt i64 %30, 1
  %39 = icmp sgt i64 %34, 0
  %40 = select i1 %39, i1 %38, i1 false
  br i1 %40, label %41, label %75

41:                                               ; preds = %37
  %42 = sitofp i64 %30 to double
  br label %43

43:                                               ; preds = %41, %72
  %44 = phi i64 [ %34, %41 ], [ %73, %72 ]
  %45 = icmp slt i64 %44, %30
  br i1 %45, label %46, label %72

46:                                               ; preds = %43
  %47 = shl nuw nsw i64 %44, 1
  br label %48

48:                                               ; preds = %46, %69
  %49 = phi i64 [ %44, %46 ], [ %70, %69 ]
  %50 = sitofp i64 %49 to double
  %51 = fdiv double %50, %42
  %52 = load i64, ptr %0, align 8
  %53 = icmp sgt i64 %52, 0
  br i1 %53, label %54, label %66

54:                                               ; preds = %48, %54
  %55 = phi i64 [ %64, %54 ], [ 0, %48 ]
  %56 = getelementptr inbounds double, ptr %1, i64 %55
  %57 = load double, ptr %56, align 8
  %58 = getelementptr inbounds double, ptr %2, i64 %55
  %59 = load double, ptr %58, align 8
  %60 = fsub double %59, %57
  %61 = fmul double %51, %60
  %62 = fadd double %57, %61
  %63 = getelementptr inbounds double, ptr %4, i64 %55
  store double %62, ptr %63, align 8
  %64 = add nuw nsw i64 %55, 1
  %65 = icmp eq i64 %64, %52
  br i1 %65, label %66, label %54

66:                                               ; preds = %54, %48
  %67 = call fastcc i32 @is_free(ptr noundef nonnull %0, ptr noundef nonnull %4)
  %68 = icmp eq i32 %67, 0
  br i1 %68, label %75, label %69

69:                                               ; preds = %66
  %70 = add nsw i64 %49, %47
  %71 = icmp slt i64 %70, %30
  br i1 %71, label %48, label %72

72:                                               ; preds = %69, %43
  %73 = lshr i64 %44, 1
  %74 = icmp ugt i64 %44, 1
  br i1 %74, label %43, label %75

75:                                               ; preds = %72, %66, %37, %19
  %76 = phi i32 [ 0, %19 ], [ 1, %37 ], [ 0, %66 ], [ 1, %72 ]
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %4) #8
  ret i32 %76
}

define dso_local i32 @manipplan_connect(ptr noundef %0, i64 noundef %1) local_unnamed_addr #0 {
  %3 = alloca [64 x double], align 16
  %4 = alloca [64 x double], align 16
  %5 = alloca [64 x double], align 16
  %6 = alloca [64 x double], align 16
  %7 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 34
  %8 = load i64, ptr %7, align 8
  %9 = add nsw i64 %8, %1
  %10 = icmp sgt i64 %1, 0
  br i1 %10, label %11, label %567

11:                                               ; preds = %2
  %12 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %13 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  %14 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %15 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %16 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %17 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 16
  %18 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 35
  %19 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31
  %20 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26
  %21 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31, i64 1
  %22 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 33
  %23 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22
  %25 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25
  %26 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %27 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %28 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27
  %29 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 1
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %31 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20
  br label %32

32:                                               ; preds = %11, %564
  %33 = phi i64 [ %8, %11 ], [ %565, %564 ]
  %34 = load i64, ptr %13, align 8
  %35 = load i64, ptr %12, align 8
  %36 = add nsw i64 %35, 1
  %37 = icmp slt i64 %36, %34
  br i1 %37, label %38, label %49

38:                                               ; preds = %32
  %39 = load ptr, ptr %14, align 8
  br label %40

40:                                               ; preds = %46, %38
  %41 = phi i64 [ %36, %38 ], [ %47, %46 ]
  %42 = phi i64 [ %35, %38 ], [ %41, %46 ]
  %43 = getelementptr inbounds i64, ptr %39, i64 %42
  %44 = load i64, ptr %43, align 8
  %45 = icmp slt i64 %33, %44
  br i1 %45, label %49, label %46

46:                                               ; preds = %40
  store i64 %41, ptr %12, align 8
  %47 = add i64 %41, 1
  %48 = icmp eq i64 %47, %34
  br i1 %48, label %49, label %40

49:                                               ; preds = %40, %46, %32
  %50 = load i64, ptr %0, align 8
  %51 = icmp sgt i64 %50, 0
  br i1 %51, label %52, label %55

52:                                               ; preds = %49
  %53 = load ptr, ptr %15, align 8
  %54 = load ptr, ptr %16, align 8
  br label %70

55:                                               ; preds = %70, %49
  %56 = phi double [ 0.000000e+00, %49 ], [ %79, %70 ]
  %57 = call double @llvm.sqrt.f64(double %56)
  %58 = load double, ptr %17, align 8
  %59 = load ptr, ptr %18, align 8
  %60 = icmp eq ptr %59, null
  %61 = select i1 %60, double 1.000000e+00, double 1.562500e-02
  %62 = fmul double %58, %61
  %63 = fdiv double %57, %62
  %64 = fptosi double %63 to i64
  %65 = add nsw i64 %64, 3
  %66 = load i64, ptr %19, align 8
  %67 = add nsw i64 %65, %66
  %68 = load i64, ptr %20, align 8
  %69 = icmp sgt i64 %67, %68
  br i1 %69, label %567, label %82

70:                                               ; preds = %70, %52
  %71 = phi double [ 0.000000e+00, %52 ], [ %79, %70 ]
  %72 = phi i64 [ 0, %52 ], [ %80, %70 ]
  %73 = getelementptr inbounds double, ptr %53, i64 %72
  %74 = load double, ptr %73, align 8
  %75 = getelementptr inbounds double, ptr %54, i64 %72
  %76 = load double, ptr %75, align 8
  %77 = fsub double %74, %76
  %78 = fmul double %77, %77
  %79 = fadd double %71, %78
  %80 = add nuw nsw i64 %72, 1
  %81 = icmp eq i64 %80, %50
  br i1 %81, label %55, label %70

82:                                               ; preds = %55
  %83 = load i64, ptr %21, align 8
  %84 = add nsw i64 %83, %65
  %85 = icmp sgt i64 %84, %68
  br i1 %85, label %567, label %86

86:                                               ; preds = %82
  %87 = load i64, ptr %22, align 8
  %88 = sub nsw i64 1, %87
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %5) #8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %6) #8
  %89 = load double, ptr %23, align 8
  %90 = fcmp olt double %89, 0x7FF0000000000000
  br i1 %90, label %91, label %239

91:                                               ; preds = %86
  %92 = load double, ptr %24, align 8
  %93 = fcmp ogt double %92, 0.000000e+00
  br i1 %93, label %94, label %239

94:                                               ; preds = %91
  %95 = load i64, ptr %25, align 8
  %96 = add i64 %95, -7046029254386353131
  store i64 %96, ptr %25, align 8
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
  %108 = load double, ptr %26, align 8
  %109 = fcmp olt double %107, %108
  br i1 %109, label %110, label %239

110:                                              ; preds = %94
  %111 = fdiv double %89, %92
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %3) #8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %4) #8
  %112 = load ptr, ptr %28, align 8
  %113 = load ptr, ptr %29, align 8
  br i1 %51, label %114, label %130

114:                                              ; preds = %110, %114
  %115 = phi i64 [ %124, %114 ], [ 0, %110 ]
  %116 = phi double [ %123, %114 ], [ 0.000000e+00, %110 ]
  %117 = getelementptr inbounds double, ptr %113, i64 %115
  %118 = load double, ptr %117, align 8
  %119 = getelementptr inbounds double, ptr %112, i64 %115
  %120 = load double, ptr %119, align 8
  %121 = fsub double %118, %120
  %122 = fmul double %121, %121
  %123 = fadd double %116, %122
  %124 = add nuw nsw i64 %115, 1
  %125 = icmp eq i64 %124, %50
  br i1 %125, label %126, label %114

126:                                              ; preds = %114, %144
  %127 = phi i64 [ %153, %144 ], [ %96, %114 ]
  %128 = phi i32 [ %145, %144 ], [ 0, %114 ]
  br label %149

129:                                              ; preds = %144
  store i64 %153, ptr %25, align 8
  br label %130

130:                                              ; preds = %129, %110
  %131 = phi double [ %123, %129 ], [ 0.000000e+00, %110 ]
  %132 = phi i1 [ %146, %129 ], [ false, %110 ]
  %133 = phi double [ %170, %129 ], [ 0.000000e+00, %110 ]
  %134 = call double @llvm.sqrt.f64(double %131)
  %135 = fmul double %111, %111
  %136 = fmul double %134, %134
  %137 = fsub double %135, %136
  %138 = call double @llvm.maxnum.f64(double %137, double 0.000000e+00)
  %139 = call double @llvm.sqrt.f64(double %138)
  %140 = call double @llvm.sqrt.f64(double %133)
  %141 = fdiv double 1.000000e+00, %140
  %142 = freeze i1 %132
  %143 = select i1 %142, double %141, double 1.000000e+00
  br i1 %51, label %173, label %238

144:                                              ; preds = %149
  %145 = add nuw nsw i32 %128, 1
  %146 = fcmp ogt double %170, 1.000000e+00
  %147 = icmp ult i32 %128, 999
  %148 = select i1 %146, i1 %147, i1 false
  br i1 %148, label %126, label %129

149:                                              ; preds = %149, %126
  %150 = phi i64 [ %127, %126 ], [ %153, %149 ]
  %151 = phi double [ 0.000000e+00, %126 ], [ %170, %149 ]
  %152 = phi i64 [ 0, %126 ], [ %171, %149 ]
  %153 = add i64 %150, -7046029254386353131
  %154 = lshr i64 %153, 30
  %155 = xor i64 %154, %153
  %156 = mul i64 %155, -4658895280553007687
  %157 = lshr i64 %156, 27
  %158 = xor i64 %157, %156
  %159 = mul i64 %158, -7723592293110705685
  %160 = lshr i64 %159, 42
  %161 = lshr i64 %159, 11
  %162 = xor i64 %160, %161
  %163 = uitofp i64 %162 to double
  %164 = fmul double %163, 0x3CA0000000000000
  %165 = fmul double %164, 2.000000e+00
  %166 = fadd double %165, -1.000000e+00
  %167 = getelementptr inbounds [64 x double], ptr %3, i64 0, i64 %152
  store double %166, ptr %167, align 8
  %168 = fmul double %166, %166
  %169 = freeze double %168
  %170 = fadd double %151, %169
  %171 = add nuw nsw i64 %152, 1
  %172 = icmp eq i64 %171, %50
  br i1 %172, label %144, label %149

173:                                              ; preds = %130, %173
  %174 = phi i64 [ %194, %173 ], [ 0, %130 ]
  %175 = phi double [ %193, %173 ], [ 0.000000e+00, %130 ]
  %176 = icmp eq i64 %174, 0
  %177 = select i1 %176, double %111, double %139
  %178 = fmul double %177, 5.000000e-01
  %179 = fmul double %143, %178
  %180 = getelementptr inbounds [64 x double], ptr %3, i64 0, i64 %174
  %181 = load double, ptr %180, align 8
  %182 = fmul double %181, %179
  store double %182, ptr %180, align 8
  %183 = getelementptr inbounds double, ptr %113, i64 %174
  %184 = load double, ptr %183, align 8
  %185 = getelementptr inbounds double, ptr %112, i64 %174
  %186 = load double, ptr %185, align 8
  %187 = fsub double %184, %186
  %188 = fdiv double %187, %134
  %189 = uitofp i1 %176 to double
  %190 = fsub double %188, %189
  %191 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %174
  store double %190, ptr %191, align 8
  %192 = fmul double %182, %190
  %193 = fadd double %175, %192
  %194 = add nuw nsw i64 %174, 1
  %195 = icmp eq i64 %194, %50
  br i1 %195, label %202, label %173

196:                                              ; preds = %202
  %197 = fmul double %193, 2.000000e+00
  %198 = fcmp ogt double %208, 0.000000e+00
  %199 = fdiv double %197, %208
  %200 = load ptr, ptr %16, align 8
  %201 = load ptr, ptr %15, align 8
  br label %211

202:                                              ; preds = %173, %202
  %203 = phi i64 [ %209, %202 ], [ 0, %173 ]
  %204 = phi double [ %208, %202 ], [ 0.000000e+00, %173 ]
  %205 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %203
  %206 = load double, ptr %205, align 8
  %207 = fmul double %206, %206
  %208 = fadd double %204, %207
  %209 = add nuw nsw i64 %203, 1
  %210 = icmp eq i64 %209, %50
  br i1 %210, label %196, label %202

211:                                              ; preds = %226, %196
  %212 = phi i64 [ 0, %196 ], [ %236, %226 ]
  %213 = getelementptr inbounds double, ptr %112, i64 %212
  %214 = load double, ptr %213, align 8
  %215 = getelementptr inbounds double, ptr %113, i64 %212
  %216 = load double, ptr %215, align 8
  %217 = fadd double %214, %216
  %218 = fmul double %217, 5.000000e-01
  %219 = getelementptr inbounds [64 x double], ptr %3, i64 0, i64 %212
  %220 = load double, ptr %219, align 8
  %221 = fadd double %220, %218
  br i1 %198, label %222, label %226

222:                                              ; preds = %211
  %223 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %212
  %224 = load double, ptr %223, align 8
  %225 = fmul double %199, %224
  br label %226

226:                                              ; preds = %222, %211
  %227 = phi double [ %225, %222 ], [ 0.000000e+00, %211 ]
  %228 = fsub double %221, %227
  %229 = getelementptr inbounds double, ptr %5, i64 %212
  store double %228, ptr %229, align 8
  %230 = getelementptr inbounds double, ptr %200, i64 %212
  %231 = load double, ptr %230, align 8
  %232 = call double @llvm.maxnum.f64(double %228, double %231)
  %233 = getelementptr inbounds double, ptr %201, i64 %212
  %234 = load double, ptr %233, align 8
  %235 = call double @llvm.minnum.f64(double %232, double %234)
  store double %235, ptr %229, align 8
  %236 = add nuw nsw i64 %212, 1
  %237 = icmp eq i64 %236, %50
  br i1 %237, label %238, label %211

238:                                              ; preds = %226, %130
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %4) #8
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %3) #8
  br label %314

239:                                              ; preds = %94, %91, %86
  %240 = load i64, ptr %25, align 8
  %241 = add i64 %240, -7046029254386353131
  store i64 %241, ptr %25, align 8
  %242 = lshr i64 %241, 30
  %243 = xor i64 %242, %241
  %244 = mul i64 %243, -4658895280553007687
  %245 = lshr i64 %244, 27
  %246 = xor i64 %245, %244
  %247 = mul i64 %246, -7723592293110705685
  %248 = lshr i64 %247, 42
  %249 = lshr i64 %247, 11
  %250 = xor i64 %248, %249
  %251 = uitofp i64 %250 to double
  %252 = fmul double %251, 0x3CA0000000000000
  %253 = load double, ptr %26, align 8
  %254 = fcmp olt double %252, %253
  br i1 %254, label %255, label %270

255:                                              ; preds = %239
  %256 = load double, ptr %27, align 8
  %257 = add i64 %240, 4354685564936845354
  store i64 %257, ptr %25, align 8
  %258 = lshr i64 %257, 30
  %259 = xor i64 %258, %257
  %260 = mul i64 %259, -4658895280553007687
  %261 = lshr i64 %260, 27
  %262 = xor i64 %261, %260
  %263 = mul i64 %262, -7723592293110705685
  %264 = lshr i64 %263, 42
  %265 = lshr i64 %263, 11
  %266 = xor i64 %264, %265
  %267 = uitofp i64 %266 to double
  %268 = fmul double %267, 0x3CA0000000000000
  %269 = fmul double %268, %256
  br label %270

270:                                              ; preds = %255, %239
  %271 = phi i64 [ %257, %255 ], [ %241, %239 ]
  %272 = phi double [ %269, %255 ], [ 0x7FF0000000000000, %239 ]
  br i1 %51, label %273, label %314

273:                                              ; preds = %270
  %274 = load ptr, ptr %28, align 8
  %275 = load ptr, ptr %29, align 8
  %276 = load ptr, ptr %16, align 8
  %277 = load ptr, ptr %15, align 8
  br label %278

278:                                              ; preds = %278, %273
  %279 = phi i64 [ %271, %273 ], [ %295, %278 ]
  %280 = phi i64 [ 0, %273 ], [ %311, %278 ]
  %281 = getelementptr inbounds double, ptr %274, i64 %280
  %282 = load double, ptr %281, align 8
  %283 = getelementptr inbounds double, ptr %275, i64 %280
  %284 = load double, ptr %283, align 8
  %285 = getelementptr inbounds double, ptr %276, i64 %280
  %286 = load double, ptr %285, align 8
  %287 = call double @llvm.minnum.f64(double %282, double %284)
  %288 = fsub double %287, %272
  %289 = call double @llvm.maxnum.f64(double %286, double %288)
  %290 = getelementptr inbounds double, ptr %277, i64 %280
  %291 = load double, ptr %290, align 8
  %292 = call double @llvm.maxnum.f64(double %282, double %284)
  %293 = fadd double %272, %292
  %294 = call double @llvm.minnum.f64(double %291, double %293)
  %295 = add i64 %279, -7046029254386353131
  %296 = lshr i64 %295, 30
  %297 = xor i64 %296, %295
  %298 = mul i64 %297, -4658895280553007687
  %299 = lshr i64 %298, 27
  %300 = xor i64 %299, %298
  %301 = mul i64 %300, -7723592293110705685
  %302 = lshr i64 %301, 42
  %303 = lshr i64 %301, 11
  %304 = xor i64 %302, %303
  %305 = uitofp i64 %304 to double
  %306 = fmul double %305, 0x3CA0000000000000
  %307 = fsub double %294, %289
  %308 = fmul double %307, %306
  %309 = fadd double %289, %308
  %310 = getelementptr inbounds double, ptr %5, i64 %280
  store double %309, ptr %310, align 8
  %311 = add nuw nsw i64 %280, 1
  %312 = icmp eq i64 %311, %50
  br i1 %312, label %313, label %278

313:                                              ; preds = %278
  store i64 %295, ptr %25, align 8
  br label %314

314:                                              ; preds = %238, %270, %313
  br i1 %60, label %320, label %315

315:                                              ; preds = %314
  %316 = load ptr, ptr %16, align 8
  %317 = load ptr, ptr %15, align 8
  %318 = call fastcc i32 @project(ptr noundef nonnull %59, ptr noundef %316, ptr noundef %317, ptr noundef nonnull %5, ptr noundef nonnull %6)
  %319 = load double, ptr %23, align 8
  br label %320

320:                                              ; preds = %315, %314
  %321 = phi double [ %319, %315 ], [ %89, %314 ]
  %322 = fcmp olt double %321, 0x7FF0000000000000
  br i1 %322, label %323, label %338

323:                                              ; preds = %320
  %324 = load i64, ptr %25, align 8
  %325 = add i64 %324, -7046029254386353131
  store i64 %325, ptr %25, align 8
  %326 = lshr i64 %325, 30
  %327 = xor i64 %326, %325
  %328 = mul i64 %327, -4658895280553007687
  %329 = lshr i64 %328, 27
  %330 = xor i64 %329, %328
  %331 = mul i64 %330, -7723592293110705685
  %332 = lshr i64 %331, 42
  %333 = lshr i64 %331, 11
  %334 = xor i64 %332, %333
  %335 = uitofp i64 %334 to double
  %336 = fmul double %335, 0x3CA0000000000000
  %337 = fmul double %321, %336
  br label %338

338:                                              ; preds = %320, %323
  %339 = phi double [ %337, %323 ], [ 0.000000e+00, %320 ]
  %340 = load i64, ptr %7, align 8
  %341 = add nsw i64 %340, 1
  store i64 %341, ptr %7, align 8
  %342 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31, i64 %87
  %343 = load i64, ptr %342, align 8
  %344 = icmp sgt i64 %343, 0
  br i1 %344, label %345, label %391

345:                                              ; preds = %338
  %346 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %87
  %347 = load ptr, ptr %346, align 8
  %348 = load i64, ptr %0, align 8
  %349 = icmp sgt i64 %348, 0
  %350 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %87
  %351 = fcmp oeq double %321, 0x7FF0000000000000
  br label %352

352:                                              ; preds = %386, %345
  %353 = phi i64 [ 0, %345 ], [ %388, %386 ]
  %354 = phi i64 [ 0, %345 ], [ %389, %386 ]
  %355 = phi double [ 0x7FF0000000000000, %345 ], [ %387, %386 ]
  %356 = mul nsw i64 %354, %348
  %357 = getelementptr inbounds double, ptr %347, i64 %356
  br i1 %349, label %361, label %358

358:                                              ; preds = %361, %352
  %359 = phi double [ 0.000000e+00, %352 ], [ %370, %361 ]
  %360 = fcmp olt double %359, %355
  br i1 %360, label %373, label %386

361:                                              ; preds = %352, %361
  %362 = phi i64 [ %371, %361 ], [ 0, %352 ]
  %363 = phi double [ %370, %361 ], [ 0.000000e+00, %352 ]
  %364 = getelementptr inbounds double, ptr %5, i64 %362
  %365 = load double, ptr %364, align 8
  %366 = getelementptr inbounds double, ptr %357, i64 %362
  %367 = load double, ptr %366, align 8
  %368 = fsub double %365, %367
  %369 = fmul double %368, %368
  %370 = fadd double %363, %369
  %371 = add nuw nsw i64 %362, 1
  %372 = icmp eq i64 %371, %348
  br i1 %372, label %358, label %361

373:                                              ; preds = %358
  %374 = icmp eq i64 %354, 0
  %375 = select i1 %374, i1 true, i1 %351
  br i1 %375, label %385, label %376

376:                                              ; preds = %373
  %377 = load ptr, ptr %350, align 8
  %378 = getelementptr inbounds double, ptr %377, i64 %354
  %379 = load double, ptr %378, align 8
  %380 = load double, ptr %24, align 8
  %381 = call double @llvm.sqrt.f64(double %359)
  %382 = fmul double %381, %380
  %383 = fadd double %379, %382
  %384 = fcmp ugt double %383, %339
  br i1 %384, label %386, label %385

385:                                              ; preds = %376, %373
  br label %386

386:                                              ; preds = %385, %376, %358
  %387 = phi double [ %359, %385 ], [ %355, %376 ], [ %355, %358 ]
  %388 = phi i64 [ %354, %385 ], [ %353, %376 ], [ %353, %358 ]
  %389 = add nuw nsw i64 %354, 1
  %390 = icmp eq i64 %389, %343
  br i1 %390, label %391, label %352

391:                                              ; preds = %386, %338
  %392 = phi i64 [ 0, %338 ], [ %388, %386 ]
  %393 = load double, ptr %17, align 8
  %394 = call fastcc i64 @extend_by(ptr noundef %0, i64 noundef %87, i64 noundef %392, ptr noundef nonnull %5, double noundef %393)
  %395 = load ptr, ptr %18, align 8
  %396 = icmp ne ptr %395, null
  %397 = icmp slt i64 %394, 0
  %398 = select i1 %396, i1 %397, i1 false
  br i1 %398, label %399, label %408

399:                                              ; preds = %391, %399
  %400 = phi double [ %404, %399 ], [ 2.500000e-01, %391 ]
  %401 = load double, ptr %17, align 8
  %402 = fmul double %400, %401
  %403 = call fastcc i64 @extend_by(ptr noundef nonnull %0, i64 noundef %87, i64 noundef %392, ptr noundef nonnull %5, double noundef %402)
  %404 = fmul double %400, 2.500000e-01
  %405 = icmp slt i64 %403, 0
  %406 = fcmp oge double %404, 6.250000e-02
  %407 = select i1 %405, i1 %406, i1 false
  br i1 %407, label %399, label %408

408:                                              ; preds = %399, %391
  %409 = phi i64 [ %394, %391 ], [ %403, %399 ]
  %410 = icmp slt i64 %409, 0
  br i1 %410, label %564, label %411

411:                                              ; preds = %408
  %412 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %87
  %413 = load ptr, ptr %412, align 8
  %414 = load i64, ptr %0, align 8
  %415 = mul nsw i64 %414, %409
  %416 = getelementptr inbounds double, ptr %413, i64 %415
  %417 = shl i64 %414, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 16 %5, ptr align 8 %416, i64 %417, i1 false)
  %418 = load double, ptr %23, align 8
  %419 = fcmp olt double %418, 0x7FF0000000000000
  br i1 %419, label %420, label %426

420:                                              ; preds = %411
  %421 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %87
  %422 = load ptr, ptr %421, align 8
  %423 = getelementptr inbounds double, ptr %422, i64 %409
  %424 = load double, ptr %423, align 8
  %425 = fsub double %418, %424
  br label %426

426:                                              ; preds = %411, %420
  %427 = phi double [ %425, %420 ], [ 0.000000e+00, %411 ]
  %428 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31, i64 %88
  %429 = load i64, ptr %428, align 8
  %430 = icmp sgt i64 %429, 0
  br i1 %430, label %431, label %478

431:                                              ; preds = %426
  %432 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %88
  %433 = load ptr, ptr %432, align 8
  %434 = icmp sgt i64 %414, 0
  %435 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %88
  %436 = fcmp oeq double %418, 0x7FF0000000000000
  br label %437

437:                                              ; preds = %471, %431
  %438 = phi i64 [ 0, %431 ], [ %473, %471 ]
  %439 = phi i64 [ 0, %431 ], [ %474, %471 ]
  %440 = phi double [ 0x7FF0000000000000, %431 ], [ %472, %471 ]
  %441 = mul nsw i64 %439, %414
  %442 = getelementptr inbounds double, ptr %433, i64 %441
  br i1 %434, label %446, label %443

443:                                              ; preds = %446, %437
  %444 = phi double [ 0.000000e+00, %437 ], [ %455, %446 ]
  %445 = fcmp olt double %444, %440
  br i1 %445, label %458, label %471

446:                                              ; preds = %437, %446
  %447 = phi i64 [ %456, %446 ], [ 0, %437 ]
  %448 = phi double [ %455, %446 ], [ 0.000000e+00, %437 ]
  %449 = getelementptr inbounds double, ptr %5, i64 %447
  %450 = load double, ptr %449, align 8
  %451 = getelementptr inbounds double, ptr %442, i64 %447
  %452 = load double, ptr %451, align 8
  %453 = fsub double %450, %452
  %454 = fmul double %453, %453
  %455 = fadd double %448, %454
  %456 = add nuw nsw i64 %447, 1
  %457 = icmp eq i64 %456, %414
  br i1 %457, label %443, label %446

458:                                              ; preds = %443
  %459 = icmp eq i64 %439, 0
  %460 = select i1 %459, i1 true, i1 %436
  br i1 %460, label %470, label %461

461:                                              ; preds = %458
  %462 = load ptr, ptr %435, align 8
  %463 = getelementptr inbounds double, ptr %462, i64 %439
  %464 = load double, ptr %463, align 8
  %465 = load double, ptr %24, align 8
  %466 = call double @llvm.sqrt.f64(double %444)
  %467 = fmul double %466, %465
  %468 = fadd double %464, %467
  %469 = fcmp ugt double %468, %427
  br i1 %469, label %471, label %470

470:                                              ; preds = %461, %458
  br label %471

471:                                              ; preds = %470, %461, %443
  %472 = phi double [ %444, %470 ], [ %440, %461 ], [ %440, %443 ]
  %473 = phi i64 [ %439, %470 ], [ %438, %461 ], [ %438, %443 ]
  %474 = add nuw nsw i64 %439, 1
  %475 = icmp eq i64 %474, %429
  br i1 %475, label %476, label %437

476:                                              ; preds = %471
  %477 = icmp sgt i64 %473, -1
  br i1 %477, label %478, label %559

478:                                              ; preds = %426, %476
  %479 = phi i64 [ %473, %476 ], [ 0, %426 ]
  %480 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %88
  br label %481

481:                                              ; preds = %478, %556
  %482 = phi i64 [ %479, %478 ], [ %557, %556 ]
  %483 = load ptr, ptr %480, align 8
  %484 = load i64, ptr %0, align 8
  %485 = mul nsw i64 %484, %482
  %486 = getelementptr inbounds double, ptr %483, i64 %485
  %487 = shl i64 %484, 3
  %488 = call i32 @bcmp(ptr %486, ptr nonnull %5, i64 %487)
  %489 = icmp eq i32 %488, 0
  br i1 %489, label %490, label %540

490:                                              ; preds = %481
  %491 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %87
  %492 = load ptr, ptr %491, align 8
  %493 = getelementptr inbounds %struct.Side, ptr %492, i64 %409
  %494 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %88
  %495 = load ptr, ptr %494, align 8
  %496 = getelementptr inbounds %struct.Side, ptr %495, i64 %482
  %497 = load double, ptr %23, align 8
  %498 = fcmp olt double %497, 0x7FF0000000000000
  br i1 %498, label %499, label %505

499:                                              ; preds = %490
  %500 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %88
  %501 = load ptr, ptr %500, align 8
  %502 = getelementptr inbounds double, ptr %501, i64 %482
  %503 = load double, ptr %502, align 8
  %504 = fcmp olt double %503, %427
  br i1 %504, label %505, label %559

505:                                              ; preds = %499, %490
  %506 = load i64, ptr %30, align 8
  %507 = icmp eq i64 %506, 0
  br i1 %507, label %537, label %508

508:                                              ; preds = %505
  %509 = getelementptr inbounds %struct.Side, ptr %492, i64 %409, i32 2
  %510 = load i64, ptr %509, align 8
  %511 = getelementptr inbounds %struct.Side, ptr %495, i64 %482, i32 2
  %512 = load i64, ptr %511, align 8
  %513 = add nsw i64 %512, %510
  %514 = load i8, ptr %493, align 8
  %515 = load i8, ptr %496, align 8
  %516 = xor i8 %515, %514
  %517 = getelementptr inbounds %struct.Side, ptr %492, i64 %409, i32 1
  %518 = load i8, ptr %517, align 1
  %519 = and i8 %516, %518
  %520 = getelementptr inbounds %struct.Side, ptr %495, i64 %482, i32 1
  %521 = load i8, ptr %520, align 1
  %522 = and i8 %519, %521
  %523 = icmp eq i8 %522, 0
  br i1 %523, label %531, label %524

524:                                              ; preds = %508, %524
  %525 = phi i32 [ %527, %524 ], [ 0, %508 ]
  %526 = phi i8 [ %529, %524 ], [ %522, %508 ]
  %527 = add nuw nsw i32 %525, 1
  %528 = add i8 %526, -1
  %529 = and i8 %528, %526
  %530 = icmp eq i8 %529, 0
  br i1 %530, label %531, label %524

531:                                              ; preds = %524, %508
  %532 = phi i32 [ 0, %508 ], [ %527, %524 ]
  %533 = sext i32 %532 to i64
  %534 = add nsw i64 %513, %533
  %535 = load i64, ptr %31, align 8
  %536 = icmp sgt i64 %534, %535
  br i1 %536, label %559, label %537

537:                                              ; preds = %531, %505
  %538 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 32, i64 %87
  store i64 %409, ptr %538, align 8
  %539 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 32, i64 %88
  store i64 %482, ptr %539, align 8
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #8
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %5) #8
  br label %567

540:                                              ; preds = %481
  %541 = load double, ptr %17, align 8
  %542 = call fastcc i64 @extend_by(ptr noundef nonnull %0, i64 noundef %88, i64 noundef %482, ptr noundef nonnull %5, double noundef %541)
  %543 = load ptr, ptr %18, align 8
  %544 = icmp ne ptr %543, null
  %545 = icmp slt i64 %542, 0
  %546 = select i1 %544, i1 %545, i1 false
  br i1 %546, label %547, label %556

547:                                              ; preds = %540, %547
  %548 = phi double [ %552, %547 ], [ 2.500000e-01, %540 ]
  %549 = load double, ptr %17, align 8
  %550 = fmul double %548, %549
  %551 = call fastcc i64 @extend_by(ptr noundef nonnull %0, i64 noundef %88, i64 noundef %482, ptr noundef nonnull %5, double noundef %550)
  %552 = fmul double %548, 2.500000e-01
  %553 = icmp slt i64 %551, 0
  %554 = fcmp oge double %552, 6.250000e-02
  %555 = select i1 %553, i1 %554, i1 false
  br i1 %555, label %547, label %556

556:                                              ; preds = %547, %540
  %557 = phi i64 [ %542, %540 ], [ %551, %547 ]
  %558 = icmp sgt i64 %557, -1
  br i1 %558, label %481, label %559

559:                                              ; preds = %556, %476, %531, %499
  %560 = load i64, ptr %19, align 8
  %561 = load i64, ptr %21, align 8
  %562 = icmp sgt i64 %560, %561
  %563 = zext i1 %562 to i64
  store i64 %563, ptr %22, align 8
  br label %564

564:                                              ; preds = %559, %408
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #8
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %5) #8
  %565 = load i64, ptr %7, align 8
  %566 = icmp slt i64 %565, %9
  br i1 %566, label %32, label %567

567:                                              ; preds = %82, %564, %55, %2, %537
  %568 = phi i32 [ 1, %537 ], [ 0, %2 ], [ 2, %82 ], [ 0, %564 ], [ 2, %55 ]
  ret i32 %568
}

define internal fastcc i32 @project(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr noundef %3, ptr nocapture noundef %4) unnamed_addr #0 {
  %6 = tail call fastcc i32 @keeps(ptr noundef %0, ptr noundef %3)
  %7 = icmp eq i32 %6, 0
  br i1 %7, label %8, label %258

8:                                                ; preds = %5
  %9 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 7
  %10 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 8
  %11 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 2
  %12 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 4
  %13 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 1
  %14 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 5
  %15 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 3
  %16 = load ptr, ptr %10, align 8
  %17 = load i64, ptr %0, align 8
  %18 = load i64, ptr %11, align 8
  br label %19

19:                                               ; preds = %8, %250
  %20 = phi i64 [ %18, %8 ], [ %51, %250 ]
  %21 = phi i64 [ %17, %8 ], [ %182, %250 ]
  %22 = phi ptr [ %16, %8 ], [ %93, %250 ]
  %23 = phi i1 [ false, %8 ], [ %252, %250 ]
  %24 = phi i32 [ 0, %8 ], [ %251, %250 ]
  %25 = phi double [ 0.000000e+00, %8 ], [ %86, %250 ]
  %26 = load ptr, ptr %9, align 8
  %27 = getelementptr inbounds double, ptr %22, i64 12
  %28 = mul nsw i64 %21, 6
  %29 = getelementptr inbounds double, ptr %27, i64 %28
  %30 = icmp eq i64 %20, 0
  br i1 %30, label %37, label %31

31:                                               ; preds = %19
  %32 = load ptr, ptr %12, align 8
  %33 = tail call i32 %32(ptr noundef %3, ptr noundef %22, i64 noundef 1) #8
  %34 = icmp eq i32 %33, 0
  br i1 %34, label %35, label %258

35:                                               ; preds = %31
  %36 = load i64, ptr %11, align 8
  br label %37

37:                                               ; preds = %35, %19
  %38 = phi i64 [ %36, %35 ], [ 0, %19 ]
  %39 = load i64, ptr %13, align 8
  %40 = icmp sgt i64 %39, %38
  br i1 %40, label %41, label %47

41:                                               ; preds = %37
  %42 = load ptr, ptr %14, align 8
  %43 = tail call i32 %42(ptr noundef %3, ptr noundef nonnull %29, i64 noundef 1) #8
  %44 = icmp eq i32 %43, 0
  br i1 %44, label %45, label %258

45:                                               ; preds = %41
  %46 = load i64, ptr %13, align 8
  br label %47

47:                                               ; preds = %45, %37
  %48 = phi i64 [ %46, %45 ], [ %39, %37 ]
  %49 = icmp sgt i64 %48, 0
  br i1 %49, label %50, label %258

50:                                               ; preds = %47
  %51 = load i64, ptr %11, align 8
  br label %52

52:                                               ; preds = %78, %50
  %53 = phi double [ %25, %50 ], [ %86, %78 ]
  %54 = phi i64 [ 0, %50 ], [ %88, %78 ]
  %55 = phi i64 [ -1, %50 ], [ %87, %78 ]
  %56 = icmp slt i64 %54, %51
  br i1 %56, label %57, label %74

57:                                               ; preds = %52
  %58 = load ptr, ptr %15, align 8
  %59 = mul nsw i64 %54, 13
  %60 = getelementptr inbounds double, ptr %58, i64 %59
  %61 = getelementptr inbounds double, ptr %60, i64 12
  %62 = load double, ptr %61, align 8
  br label %63

63:                                               ; preds = %63, %57
  %64 = phi i64 [ 0, %57 ], [ %72, %63 ]
  %65 = phi double [ %62, %57 ], [ %71, %63 ]
  %66 = getelementptr inbounds double, ptr %60, i64 %64
  %67 = load double, ptr %66, align 8
  %68 = getelementptr inbounds double, ptr %22, i64 %64
  %69 = load double, ptr %68, align 8
  %70 = fmul double %67, %69
  %71 = fadd double %65, %70
  %72 = add nuw nsw i64 %64, 1
  %73 = icmp eq i64 %72, 12
  br i1 %73, label %78, label %63

74:                                               ; preds = %52
  %75 = sub nsw i64 %54, %51
  %76 = getelementptr inbounds double, ptr %29, i64 %75
  %77 = load double, ptr %76, align 8
  br label %78

78:                                               ; preds = %63, %74
  %79 = phi double [ %77, %74 ], [ %71, %63 ]
  %80 = getelementptr inbounds double, ptr %26, i64 %54
  %81 = load double, ptr %80, align 8
  %82 = fsub double %79, %81
  %83 = icmp slt i64 %55, 0
  %84 = fcmp ult double %82, %53
  %85 = select i1 %83, i1 true, i1 %84
  %86 = select i1 %85, double %82, double %53
  %87 = select i1 %85, i64 %54, i64 %55
  %88 = add nuw nsw i64 %54, 1
  %89 = icmp eq i64 %88, %48
  br i1 %89, label %90, label %52

90:                                               ; preds = %78
  %91 = fcmp ult double %86, 0.000000e+00
  br i1 %91, label %92, label %254

92:                                               ; preds = %90
  %93 = load ptr, ptr %10, align 8
  %94 = getelementptr inbounds double, ptr %93, i64 12
  %95 = icmp slt i64 %87, %51
  br i1 %95, label %113, label %96

96:                                               ; preds = %92
  %97 = load i64, ptr %0, align 8
  %98 = mul nsw i64 %97, 6
  %99 = getelementptr inbounds double, ptr %94, i64 %98
  %100 = sub nsw i64 %48, %51
  %101 = getelementptr inbounds double, ptr %99, i64 %100
  %102 = sub nsw i64 %87, %51
  %103 = mul nsw i64 %97, %102
  %104 = getelementptr double, ptr %101, i64 %103
  %105 = icmp sgt i64 %97, 0
  br i1 %105, label %106, label %254

106:                                              ; preds = %96, %106
  %107 = phi i64 [ %111, %106 ], [ 0, %96 ]
  %108 = getelementptr inbounds double, ptr %104, i64 %107
  %109 = load double, ptr %108, align 8
  %110 = getelementptr inbounds double, ptr %4, i64 %107
  store double %109, ptr %110, align 8
  %111 = add nuw nsw i64 %107, 1
  %112 = icmp eq i64 %111, %97
  br i1 %112, label %181, label %106

113:                                              ; preds = %92
  %114 = load ptr, ptr %15, align 8
  %115 = mul nsw i64 %87, 13
  %116 = getelementptr inbounds double, ptr %114, i64 %115
  %117 = load i64, ptr %0, align 8
  %118 = icmp sgt i64 %117, 0
  br i1 %118, label %119, label %254

119:                                              ; preds = %113
  %120 = getelementptr inbounds double, ptr %116, i64 1
  %121 = getelementptr inbounds double, ptr %116, i64 2
  br label %122

122:                                              ; preds = %143, %119
  %123 = phi i64 [ 0, %119 ], [ %144, %143 ]
  %124 = mul nuw nsw i64 %123, 6
  %125 = getelementptr inbounds double, ptr %94, i64 %124
  %126 = getelementptr inbounds double, ptr %125, i64 3
  %127 = load double, ptr %116, align 8
  %128 = load double, ptr %125, align 8
  %129 = fmul double %127, %128
  %130 = load double, ptr %120, align 8
  %131 = getelementptr inbounds double, ptr %125, i64 1
  %132 = load double, ptr %131, align 8
  %133 = fmul double %130, %132
  %134 = fadd double %129, %133
  %135 = load double, ptr %121, align 8
  %136 = getelementptr inbounds double, ptr %125, i64 2
  %137 = load double, ptr %136, align 8
  %138 = fmul double %135, %137
  %139 = fadd double %134, %138
  %140 = getelementptr inbounds double, ptr %4, i64 %123
  store double %139, ptr %140, align 8
  %141 = getelementptr inbounds double, ptr %126, i64 1
  %142 = getelementptr inbounds double, ptr %126, i64 2
  br label %146

143:                                              ; preds = %146
  %144 = add nuw nsw i64 %123, 1
  %145 = icmp eq i64 %144, %117
  br i1 %145, label %181, label %122

146:                                              ; preds = %146, %122
  %147 = phi double [ %139, %122 ], [ %178, %146 ]
  %148 = phi i64 [ 3, %122 ], [ %179, %146 ]
  %149 = getelementptr inbounds double, ptr %93, i64 %148
  %150 = getelementptr inbounds double, ptr %116, i64 %148
  %151 = load double, ptr %150, align 8
  %152 = load double, ptr %141, align 8
  %153 = getelementptr inbounds double, ptr %149, i64 2
  %154 = load double, ptr %153, align 8
  %155 = fmul double %152, %154
  %156 = load double, ptr %142, align 8
  %157 = getelementptr inbounds double, ptr %149, i64 1
  %158 = load double, ptr %157, align 8
  %159 = fmul double %156, %158
  %160 = fsub double %155, %159
  %161 = fmul double %151, %160
  %162 = getelementptr inbounds double, ptr %150, i64 1
  %163 = load double, ptr %162, align 8
  %164 = load double, ptr %149, align 8
  %165 = fmul double %156, %164
  %166 = load double, ptr %126, align 8
  %167 = fmul double %154, %166
  %168 = fsub double %165, %167
  %169 = fmul double %163, %168
  %170 = fadd double %161, %169
  %171 = getelementptr inbounds double, ptr %150, i64 2
  %172 = load double, ptr %171, align 8
  %173 = fmul double %158, %166
  %174 = fmul double %152, %164
  %175 = fsub double %173, %174
  %176 = fmul double %172, %175
  %177 = fadd double %176, %170
  %178 = fadd double %147, %177
  store double %178, ptr %140, align 8
  %179 = add nuw nsw i64 %148, 3
  %180 = icmp ult i64 %148, 9
  br i1 %180, label %146, label %143

181:                                              ; preds = %106, %143
  %182 = phi i64 [ %117, %143 ], [ %97, %106 ]
  %183 = icmp sgt i64 %182, 0
  br i1 %183, label %189, label %254

184:                                              ; preds = %211
  %185 = fcmp ogt double %214, 0x3D719799812DEA11
  br i1 %185, label %186, label %254

186:                                              ; preds = %184
  br i1 %183, label %187, label %250

187:                                              ; preds = %186
  %188 = fneg double %86
  br label %223

189:                                              ; preds = %181, %211
  %190 = phi i64 [ %215, %211 ], [ 0, %181 ]
  %191 = phi double [ %214, %211 ], [ 0.000000e+00, %181 ]
  %192 = getelementptr inbounds double, ptr %3, i64 %190
  %193 = load double, ptr %192, align 8
  %194 = getelementptr inbounds double, ptr %1, i64 %190
  %195 = load double, ptr %194, align 8
  %196 = fcmp ugt double %193, %195
  br i1 %196, label %201, label %197

197:                                              ; preds = %189
  %198 = getelementptr inbounds double, ptr %4, i64 %190
  %199 = load double, ptr %198, align 8
  %200 = fcmp olt double %199, 0.000000e+00
  br i1 %200, label %209, label %201

201:                                              ; preds = %197, %189
  %202 = getelementptr inbounds double, ptr %2, i64 %190
  %203 = load double, ptr %202, align 8
  %204 = fcmp oge double %193, %203
  %205 = getelementptr inbounds double, ptr %4, i64 %190
  %206 = load double, ptr %205, align 8
  %207 = fcmp ogt double %206, 0.000000e+00
  %208 = select i1 %204, i1 %207, i1 false
  br i1 %208, label %209, label %211

209:                                              ; preds = %201, %197
  %210 = getelementptr inbounds double, ptr %4, i64 %190
  store double 0.000000e+00, ptr %210, align 8
  br label %211

211:                                              ; preds = %201, %209
  %212 = phi double [ 0.000000e+00, %209 ], [ %206, %201 ]
  %213 = fmul double %212, %212
  %214 = fadd double %191, %213
  %215 = add nuw nsw i64 %190, 1
  %216 = icmp eq i64 %215, %182
  br i1 %216, label %184, label %189

217:                                              ; preds = %223
  %218 = fcmp ogt double %231, 5.000000e-01
  %219 = fdiv double 5.000000e-01, %231
  %220 = select i1 %218, double %219, double 1.000000e+00
  %221 = fmul double %220, %188
  %222 = fdiv double %221, %214
  br i1 %183, label %234, label %250

223:                                              ; preds = %187, %223
  %224 = phi i64 [ 0, %187 ], [ %232, %223 ]
  %225 = phi double [ 0.000000e+00, %187 ], [ %231, %223 ]
  %226 = getelementptr inbounds double, ptr %4, i64 %224
  %227 = load double, ptr %226, align 8
  %228 = tail call double @llvm.fabs.f64(double %227)
  %229 = fmul double %228, %188
  %230 = fdiv double %229, %214
  %231 = tail call double @llvm.maxnum.f64(double %225, double %230)
  %232 = add nuw nsw i64 %224, 1
  %233 = icmp eq i64 %232, %182
  br i1 %233, label %217, label %223

234:                                              ; preds = %217, %234
  %235 = phi i64 [ %248, %234 ], [ 0, %217 ]
  %236 = getelementptr inbounds double, ptr %3, i64 %235
  %237 = load double, ptr %236, align 8
  %238 = getelementptr inbounds double, ptr %4, i64 %235
  %239 = load double, ptr %238, align 8
  %240 = fmul double %222, %239
  %241 = fadd double %237, %240
  %242 = getelementptr inbounds double, ptr %1, i64 %235
  %243 = load double, ptr %242, align 8
  %244 = tail call double @llvm.maxnum.f64(double %241, double %243)
  %245 = getelementptr inbounds double, ptr %2, i64 %235
  %246 = load double, ptr %245, align 8
  %247 = tail call double @llvm.minnum.f64(double %244, double %246)
  store double %247, ptr %236, align 8
  %248 = add nuw nsw i64 %235, 1
  %249 = icmp eq i64 %248, %182
  br i1 %249, label %250, label %234

250:                                              ; preds = %234, %186, %217
  %251 = add nuw nsw i32 %24, 1
  %252 = icmp ugt i32 %24, 38
  %253 = icmp eq i32 %251, 40
  br i1 %253, label %256, label %19

254:                                              ; preds = %113, %96, %181, %90, %184
  %255 = phi i32 [ 0, %184 ], [ 1, %90 ], [ 0, %181 ], [ 0, %96 ], [ 0, %113 ]
  br i1 %23, label %256, label %258

256:                                              ; preds = %250, %254
  %257 = tail call fastcc i32 @keeps(ptr noundef nonnull %0, ptr noundef %3)
  br label %258

258:                                              ; preds = %31, %41, %47, %5, %254, %256
  %259 = phi i32 [ %257, %256 ], [ %255, %254 ], [ 1, %5 ], [ 0, %47 ], [ 0, %41 ], [ 0, %31 ]
  ret i32 %259
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
  br i1 %16, label %17, label %31

17:                                               ; preds = %5
  %18 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25
  %19 = getelementptr inbounds double, ptr %9, i64 1
  %20 = getelementptr inbounds [2 x i64], ptr %11, i64 0, i64 1
  %21 = getelementptr inbounds [2 x [64 x double]], ptr %10, i64 0, i64 1
  %22 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %23 = getelementptr inbounds %struct.Side, ptr %7, i64 0, i32 2
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29
  %25 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 1
  br label %26

26:                                               ; preds = %247, %17
  %27 = phi i64 [ %3, %17 ], [ %248, %247 ]
  %28 = phi i64 [ 0, %17 ], [ %249, %247 ]
  %29 = load i64, ptr %0, align 8
  %30 = icmp sgt i64 %29, 0
  br label %62

31:                                               ; preds = %247, %5
  %32 = phi i64 [ %3, %5 ], [ %248, %247 ]
  ret i64 %32

33:                                               ; preds = %82
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %9) #8
  %34 = load i64, ptr %18, align 8
  %35 = add i64 %34, -7046029254386353131
  %36 = lshr i64 %35, 30
  %37 = xor i64 %36, %35
  %38 = mul i64 %37, -4658895280553007687
  %39 = lshr i64 %38, 27
  %40 = xor i64 %39, %38
  %41 = mul i64 %40, -7723592293110705685
  %42 = lshr i64 %41, 42
  %43 = lshr i64 %41, 11
  %44 = xor i64 %42, %43
  %45 = uitofp i64 %44 to double
  %46 = fmul double %45, 0x3CA0000000000000
  %47 = fmul double %85, %46
  store double %47, ptr %9, align 16
  %48 = add i64 %34, 4354685564936845354
  store i64 %48, ptr %18, align 8
  %49 = lshr i64 %48, 30
  %50 = xor i64 %49, %48
  %51 = mul i64 %50, -4658895280553007687
  %52 = lshr i64 %51, 27
  %53 = xor i64 %52, %51
  %54 = mul i64 %53, -7723592293110705685
  %55 = lshr i64 %54, 42
  %56 = lshr i64 %54, 11
  %57 = xor i64 %55, %56
  %58 = uitofp i64 %57 to double
  %59 = fmul double %58, 0x3CA0000000000000
  %60 = fmul double %85, %59
  store double %60, ptr %19, align 8
  call void @llvm.lifetime.start.p0(i64 1024, ptr nonnull %10) #8
  %61 = fcmp ogt double %47, %60
  br i1 %61, label %88, label %89

62:                                               ; preds = %26, %82
  %63 = phi i64 [ 1, %26 ], [ %86, %82 ]
  %64 = phi double [ 0.000000e+00, %26 ], [ %85, %82 ]
  %65 = phi i64 [ 0, %26 ], [ %63, %82 ]
  %66 = mul nsw i64 %29, %65
  %67 = getelementptr inbounds double, ptr %1, i64 %66
  %68 = mul nsw i64 %29, %63
  %69 = getelementptr inbounds double, ptr %1, i64 %68
  br i1 %30, label %70, label %82

70:                                               ; preds = %62, %70
  %71 = phi i64 [ %80, %70 ], [ 0, %62 ]
  %72 = phi double [ %79, %70 ], [ 0.000000e+00, %62 ]
  %73 = getelementptr inbounds double, ptr %69, i64 %71
  %74 = load double, ptr %73, align 8
  %75 = getelementptr inbounds double, ptr %67, i64 %71
  %76 = load double, ptr %75, align 8
  %77 = fsub double %74, %76
  %78 = fmul double %77, %77
  %79 = fadd double %72, %78
  %80 = add nuw nsw i64 %71, 1
  %81 = icmp eq i64 %80, %29
  br i1 %81, label %82, label %70

82:                                               ; preds = %70, %62
  %83 = phi double [ 0.000000e+00, %62 ], [ %79, %70 ]
  %84 = call double @llvm.sqrt.f64(double %83)
  %85 = fadd double %64, %84
  %86 = add nuw nsw i64 %63, 1
  %87 = icmp eq i64 %86, %27
  br i1 %87, label %33, label %62

88:                                               ; preds = %33
  store double %60, ptr %9, align 16
  store double %47, ptr %19, align 8
  br label %89

89:                                               ; preds = %33, %88
  %90 = phi double [ %47, %88 ], [ %60, %33 ]
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %11) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(16) %11, i8 -1, i64 16, i1 false)
  %91 = load i64, ptr %0, align 8
  %92 = icmp sgt i64 %91, 0
  br label %96

93:                                               ; preds = %122
  %94 = load i64, ptr %11, align 16
  %95 = icmp eq i64 %94, %125
  br i1 %95, label %247, label %159

96:                                               ; preds = %89, %122
  %97 = phi i64 [ 1, %89 ], [ %123, %122 ]
  %98 = phi i64 [ 0, %89 ], [ %97, %122 ]
  %99 = phi double [ 0.000000e+00, %89 ], [ %118, %122 ]
  %100 = mul nsw i64 %91, %98
  %101 = getelementptr inbounds double, ptr %1, i64 %100
  %102 = getelementptr inbounds double, ptr %101, i64 %91
  br i1 %92, label %103, label %115

103:                                              ; preds = %96, %103
  %104 = phi i64 [ %113, %103 ], [ 0, %96 ]
  %105 = phi double [ %112, %103 ], [ 0.000000e+00, %96 ]
  %106 = getelementptr inbounds double, ptr %102, i64 %104
  %107 = load double, ptr %106, align 8
  %108 = getelementptr inbounds double, ptr %101, i64 %104
  %109 = load double, ptr %108, align 8
  %110 = fsub double %107, %109
  %111 = fmul double %110, %110
  %112 = fadd double %105, %111
  %113 = add nuw nsw i64 %104, 1
  %114 = icmp eq i64 %113, %91
  br i1 %114, label %115, label %103

115:                                              ; preds = %103, %96
  %116 = phi double [ 0.000000e+00, %96 ], [ %112, %103 ]
  %117 = call double @llvm.sqrt.f64(double %116)
  %118 = fadd double %99, %117
  %119 = add nuw nsw i64 %98, 2
  %120 = icmp eq i64 %119, %27
  %121 = fcmp ogt double %117, 0.000000e+00
  br label %128

122:                                              ; preds = %158
  %123 = add nuw nsw i64 %97, 1
  %124 = icmp slt i64 %123, %27
  %125 = load i64, ptr %20, align 8
  %126 = icmp slt i64 %125, 0
  %127 = select i1 %124, i1 %126, i1 false
  br i1 %127, label %96, label %93

128:                                              ; preds = %115, %158
  %129 = phi i1 [ true, %115 ], [ false, %158 ]
  %130 = phi i64 [ 0, %115 ], [ 1, %158 ]
  %131 = getelementptr inbounds [2 x i64], ptr %11, i64 0, i64 %130
  %132 = load i64, ptr %131, align 8
  %133 = icmp slt i64 %132, 0
  br i1 %133, label %134, label %158

134:                                              ; preds = %128
  %135 = getelementptr inbounds [2 x double], ptr %9, i64 0, i64 %130
  %136 = load double, ptr %135, align 8
  %137 = fcmp olt double %136, %118
  %138 = select i1 %137, i1 true, i1 %120
  br i1 %138, label %139, label %158

139:                                              ; preds = %134
  %140 = fsub double %136, %99
  %141 = fdiv double %140, %117
  %142 = select i1 %121, double %141, double 0.000000e+00
  store i64 %98, ptr %131, align 8
  %143 = call double @llvm.maxnum.f64(double %142, double 0.000000e+00)
  %144 = call double @llvm.minnum.f64(double %143, double 1.000000e+00)
  %145 = getelementptr inbounds [2 x [64 x double]], ptr %10, i64 0, i64 %130
  br i1 %92, label %146, label %158

146:                                              ; preds = %139, %146
  %147 = phi i64 [ %156, %146 ], [ 0, %139 ]
  %148 = getelementptr inbounds double, ptr %101, i64 %147
  %149 = load double, ptr %148, align 8
  %150 = getelementptr inbounds double, ptr %102, i64 %147
  %151 = load double, ptr %150, align 8
  %152 = fsub double %151, %149
  %153 = fmul double %144, %152
  %154 = fadd double %149, %153
  %155 = getelementptr inbounds double, ptr %145, i64 %147
  store double %154, ptr %155, align 8
  %156 = add nuw nsw i64 %147, 1
  %157 = icmp eq i64 %156, %91
  br i1 %157, label %158, label %146

158:                                              ; preds = %146, %139, %134, %128
  br i1 %129, label %128, label %122

159:                                              ; preds = %93
  %160 = load double, ptr %9, align 16
  %161 = fsub double %90, %160
  %162 = load i64, ptr %0, align 8
  %163 = icmp sgt i64 %162, 0
  br i1 %163, label %164, label %176

164:                                              ; preds = %159, %164
  %165 = phi i64 [ %174, %164 ], [ 0, %159 ]
  %166 = phi double [ %173, %164 ], [ 0.000000e+00, %159 ]
  %167 = getelementptr inbounds double, ptr %21, i64 %165
  %168 = load double, ptr %167, align 8
  %169 = getelementptr inbounds double, ptr %10, i64 %165
  %170 = load double, ptr %169, align 8
  %171 = fsub double %168, %170
  %172 = fmul double %171, %171
  %173 = fadd double %166, %172
  %174 = add nuw nsw i64 %165, 1
  %175 = icmp eq i64 %174, %162
  br i1 %175, label %176, label %164

176:                                              ; preds = %164, %159
  %177 = phi double [ 0.000000e+00, %159 ], [ %173, %164 ]
  %178 = call double @llvm.sqrt.f64(double %177)
  %179 = fsub double %161, %178
  %180 = fmul double %85, 1.000000e-02
  %181 = fcmp olt double %179, %180
  br i1 %181, label %247, label %182

182:                                              ; preds = %176
  %183 = add nsw i64 %94, 1
  %184 = mul i64 %183, %13
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %2, ptr align 8 %1, i64 %184, i1 false)
  %185 = add nsw i64 %94, 2
  %186 = load i64, ptr %0, align 8
  %187 = mul nsw i64 %186, %183
  %188 = getelementptr inbounds double, ptr %2, i64 %187
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %188, ptr nonnull align 16 %10, i64 %13, i1 false)
  %189 = add nsw i64 %94, 3
  %190 = load i64, ptr %0, align 8
  %191 = mul nsw i64 %190, %185
  %192 = getelementptr inbounds double, ptr %2, i64 %191
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %192, ptr nonnull align 16 %21, i64 %13, i1 false)
  %193 = load i64, ptr %0, align 8
  %194 = mul nsw i64 %193, %189
  %195 = getelementptr inbounds double, ptr %2, i64 %194
  %196 = add nsw i64 %125, 1
  %197 = mul nsw i64 %193, %196
  %198 = getelementptr inbounds double, ptr %1, i64 %197
  %199 = xor i64 %125, -1
  %200 = add i64 %27, %199
  %201 = mul i64 %200, %13
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %195, ptr align 8 %198, i64 %201, i1 false)
  %202 = add nsw i64 %189, %200
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %7) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %7, i8 0, i64 16, i1 false)
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %8, i8 0, i64 16, i1 false)
  %203 = load i64, ptr %22, align 8
  %204 = icmp eq i64 %203, 0
  br i1 %204, label %205, label %206

205:                                              ; preds = %182
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  br label %239

206:                                              ; preds = %182
  %207 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef nonnull %10, ptr noundef nonnull %10, ptr noundef nonnull %7, ptr noundef nonnull %8)
  %208 = icmp eq i32 %207, 0
  br i1 %208, label %212, label %209

209:                                              ; preds = %206
  %210 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef nonnull %10, ptr noundef nonnull %21, ptr noundef nonnull %7, ptr noundef nonnull %8)
  %211 = icmp eq i32 %210, 0
  br i1 %211, label %212, label %213

212:                                              ; preds = %209, %206
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  br label %216

213:                                              ; preds = %209
  %214 = load i64, ptr %23, align 8
  %215 = icmp eq i64 %214, 0
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  br i1 %215, label %239, label %216

216:                                              ; preds = %212, %213
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %6) #8
  %217 = load ptr, ptr %24, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %6, ptr noundef nonnull align 8 dereferenceable(16) %217, i64 16, i1 false)
  %218 = load i64, ptr %22, align 8
  %219 = icmp eq i64 %218, 0
  br i1 %219, label %220, label %221

220:                                              ; preds = %216
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %6) #8
  br label %239

221:                                              ; preds = %216
  %222 = call i64 @llvm.smax.i64(i64 %202, i64 1)
  %223 = add nsw i64 %222, -1
  br label %224

224:                                              ; preds = %228, %221
  %225 = phi i64 [ %226, %228 ], [ 0, %221 ]
  %226 = add nuw nsw i64 %225, 1
  %227 = icmp eq i64 %225, %223
  br i1 %227, label %237, label %228

228:                                              ; preds = %224
  %229 = load i64, ptr %0, align 8
  %230 = mul nsw i64 %229, %225
  %231 = getelementptr inbounds double, ptr %2, i64 %230
  %232 = mul nsw i64 %229, %226
  %233 = getelementptr inbounds double, ptr %2, i64 %232
  %234 = load ptr, ptr %25, align 8
  %235 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %231, ptr noundef %233, ptr noundef nonnull %6, ptr noundef %234)
  %236 = icmp eq i32 %235, 0
  br i1 %236, label %237, label %224

237:                                              ; preds = %224, %228
  %238 = icmp slt i64 %226, %202
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %6) #8
  br i1 %238, label %247, label %239

239:                                              ; preds = %220, %205, %237, %213
  %240 = call fastcc i32 @is_free(ptr noundef nonnull %0, ptr noundef nonnull %10)
  %241 = icmp eq i32 %240, 0
  br i1 %241, label %247, label %242

242:                                              ; preds = %239
  %243 = call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef nonnull %10, ptr noundef nonnull %21)
  %244 = icmp eq i32 %243, 0
  br i1 %244, label %247, label %245

245:                                              ; preds = %242
  %246 = mul i64 %202, %13
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1, ptr align 8 %2, i64 %246, i1 false)
  br label %247

247:                                              ; preds = %245, %237, %242, %239, %93, %176
  %248 = phi i64 [ %27, %176 ], [ %27, %93 ], [ %202, %245 ], [ %27, %237 ], [ %27, %242 ], [ %27, %239 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %11) #8
  call void @llvm.lifetime.end.p0(i64 1024, ptr nonnull %10) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %9) #8
  %249 = add nuw nsw i64 %28, 1
  %250 = icmp slt i64 %249, %4
  %251 = icmp sgt i64 %248, 2
  %252 = select i1 %250, i1 %251, i1 false
  br i1 %252, label %26, label %31
}

declare double @llvm.maxnum.f64(double, double) #4

declare double @llvm.minnum.f64(double, double) #4

declare double @llvm.fabs.f64(double) #4

declare double @llvm.ceil.f64(double) #4

define internal fastcc i32 @keeps(ptr nocapture noundef readonly %0, ptr noundef %1) unnamed_addr #0 {
  %3 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 6
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 8
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds double, ptr %6, i64 12
  %8 = load i64, ptr %0, align 8
  %9 = mul nsw i64 %8, 6
  %10 = getelementptr inbounds double, ptr %7, i64 %9
  %11 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 2
  %12 = load i64, ptr %11, align 8
  %13 = icmp eq i64 %12, 0
  br i1 %13, label %21, label %14

14:                                               ; preds = %2
  %15 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 4
  %16 = load ptr, ptr %15, align 8
  %17 = tail call i32 %16(ptr noundef %1, ptr noundef %6, i64 noundef 1) #8
  %18 = icmp eq i32 %17, 0
  br i1 %18, label %19, label %82

19:                                               ; preds = %14
  %20 = load i64, ptr %11, align 8
  br label %21

21:                                               ; preds = %19, %2
  %22 = phi i64 [ %20, %19 ], [ 0, %2 ]
  %23 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 1
  %24 = load i64, ptr %23, align 8
  %25 = icmp sgt i64 %24, %22
  br i1 %25, label %26, label %33

26:                                               ; preds = %21
  %27 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 5
  %28 = load ptr, ptr %27, align 8
  %29 = tail call i32 %28(ptr noundef %1, ptr noundef nonnull %10, i64 noundef 1) #8
  %30 = icmp eq i32 %29, 0
  br i1 %30, label %31, label %82

31:                                               ; preds = %26
  %32 = load i64, ptr %23, align 8
  br label %33

33:                                               ; preds = %31, %21
  %34 = phi i64 [ %32, %31 ], [ %24, %21 ]
  %35 = icmp sgt i64 %34, 0
  br i1 %35, label %36, label %82

36:                                               ; preds = %33
  %37 = load i64, ptr %11, align 8
  %38 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 3
  br label %39

39:                                               ; preds = %65, %36
  %40 = phi double [ 0.000000e+00, %36 ], [ %73, %65 ]
  %41 = phi i64 [ 0, %36 ], [ %75, %65 ]
  %42 = phi i64 [ -1, %36 ], [ %74, %65 ]
  %43 = icmp slt i64 %41, %37
  br i1 %43, label %44, label %61

44:                                               ; preds = %39
  %45 = load ptr, ptr %38, align 8
  %46 = mul nsw i64 %41, 13
  %47 = getelementptr inbounds double, ptr %45, i64 %46
  %48 = getelementptr inbounds double, ptr %47, i64 12
  %49 = load double, ptr %48, align 8
  br label %50

50:                                               ; preds = %50, %44
  %51 = phi i64 [ 0, %44 ], [ %59, %50 ]
  %52 = phi double [ %49, %44 ], [ %58, %50 ]
  %53 = getelementptr inbounds double, ptr %47, i64 %51
  %54 = load double, ptr %53, align 8
  %55 = getelementptr inbounds double, ptr %6, i64 %51
  %56 = load double, ptr %55, align 8
  %57 = fmul double %54, %56
  %58 = fadd double %52, %57
  %59 = add nuw nsw i64 %51, 1
  %60 = icmp eq i64 %59, 12
  br i1 %60, label %65, label %50

61:                                               ; preds = %39
  %62 = sub nsw i64 %41, %37
  %63 = getelementptr inbounds double, ptr %10, i64 %62
  %64 = load double, ptr %63, align 8
  br label %65

65:                                               ; preds = %50, %61
  %66 = phi double [ %64, %61 ], [ %58, %50 ]
  %67 = getelementptr inbounds double, ptr %4, i64 %41
  %68 = load double, ptr %67, align 8
  %69 = fsub double %66, %68
  %70 = icmp slt i64 %42, 0
  %71 = fcmp ult double %69, %40
  %72 = select i1 %70, i1 true, i1 %71
  %73 = select i1 %72, double %69, double %40
  %74 = select i1 %72, i64 %41, i64 %42
  %75 = add nuw nsw i64 %41, 1
  %76 = icmp eq i64 %75, %34
  br i1 %76, label %77, label %39

77:                                               ; preds = %65
  %78 = icmp sgt i64 %74, -1
  %79 = fcmp oge double %73, 0.000000e+00
  %80 = select i1 %78, i1 %79, i1 false
  %81 = zext i1 %80 to i32
  br label %82

82:                                               ; preds = %77, %14, %26, %33
  %83 = phi i32 [ 0, %33 ], [ 0, %26 ], [ 0, %14 ], [ %81, %77 ]
  ret i32 %83
}

declare double @llvm.sqrt.f64(double) #4

define internal fastcc i64 @extend_by(ptr nocapture noundef %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3, double noundef %4) unnamed_addr #0 {
  %6 = alloca [64 x double], align 16
  %7 = alloca %struct.Side, align 8
  %8 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %1
  %9 = load ptr, ptr %8, align 8
  %10 = load i64, ptr %0, align 8
  %11 = mul nsw i64 %10, %2
  %12 = getelementptr inbounds double, ptr %9, i64 %11
  %13 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31, i64 %1
  %14 = load i64, ptr %13, align 8
  %15 = mul nsw i64 %14, %10
  %16 = getelementptr inbounds double, ptr %9, i64 %15
  %17 = icmp sgt i64 %10, 0
  br i1 %17, label %18, label %33

18:                                               ; preds = %5, %18
  %19 = phi i64 [ %28, %18 ], [ 0, %5 ]
  %20 = phi double [ %27, %18 ], [ 0.000000e+00, %5 ]
  %21 = getelementptr inbounds double, ptr %3, i64 %19
  %22 = load double, ptr %21, align 8
  %23 = getelementptr inbounds double, ptr %12, i64 %19
  %24 = load double, ptr %23, align 8
  %25 = fsub double %22, %24
  %26 = fmul double %25, %25
  %27 = fadd double %20, %26
  %28 = add nuw nsw i64 %19, 1
  %29 = icmp eq i64 %28, %10
  br i1 %29, label %30, label %18

30:                                               ; preds = %18
  %31 = tail call double @llvm.sqrt.f64(double %27)
  %32 = fcmp ogt double %31, %4
  br i1 %32, label %35, label %49

33:                                               ; preds = %5
  %34 = fcmp olt double %4, 0.000000e+00
  br i1 %34, label %52, label %49

35:                                               ; preds = %30
  %36 = fdiv double %4, %31
  br label %37

37:                                               ; preds = %35, %37
  %38 = phi i64 [ %47, %37 ], [ 0, %35 ]
  %39 = getelementptr inbounds double, ptr %12, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = getelementptr inbounds double, ptr %3, i64 %38
  %42 = load double, ptr %41, align 8
  %43 = fsub double %42, %40
  %44 = fmul double %36, %43
  %45 = fadd double %40, %44
  %46 = getelementptr inbounds double, ptr %16, i64 %38
  store double %45, ptr %46, align 8
  %47 = add nuw nsw i64 %38, 1
  %48 = icmp eq i64 %47, %10
  br i1 %48, label %52, label %37

49:                                               ; preds = %33, %30
  %50 = phi double [ 0.000000e+00, %33 ], [ %31, %30 ]
  %51 = shl i64 %10, 3
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %16, ptr align 8 %3, i64 %51, i1 false)
  br label %52

52:                                               ; preds = %37, %33, %49
  %53 = phi double [ %50, %49 ], [ 0.000000e+00, %33 ], [ %31, %37 ]
  %54 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 35
  %55 = load ptr, ptr %54, align 8
  %56 = icmp eq ptr %55, null
  br i1 %56, label %86, label %57

57:                                               ; preds = %52
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %6) #8
  %58 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %59 = load ptr, ptr %58, align 8
  %60 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %61 = load ptr, ptr %60, align 8
  %62 = call fastcc i32 @project(ptr noundef nonnull %55, ptr noundef %59, ptr noundef %61, ptr noundef %16, ptr noundef nonnull %6)
  %63 = icmp eq i32 %62, 0
  br i1 %63, label %155, label %64

64:                                               ; preds = %57
  %65 = load i64, ptr %0, align 8
  %66 = icmp sgt i64 %65, 0
  br i1 %66, label %67, label %79

67:                                               ; preds = %64, %67
  %68 = phi i64 [ %77, %67 ], [ 0, %64 ]
  %69 = phi double [ %76, %67 ], [ 0.000000e+00, %64 ]
  %70 = getelementptr inbounds double, ptr %3, i64 %68
  %71 = load double, ptr %70, align 8
  %72 = getelementptr inbounds double, ptr %16, i64 %68
  %73 = load double, ptr %72, align 8
  %74 = fsub double %71, %73
  %75 = fmul double %74, %74
  %76 = fadd double %69, %75
  %77 = add nuw nsw i64 %68, 1
  %78 = icmp eq i64 %77, %65
  br i1 %78, label %79, label %67

79:                                               ; preds = %67, %64
  %80 = phi double [ 0.000000e+00, %64 ], [ %76, %67 ]
  %81 = tail call double @llvm.sqrt.f64(double %80)
  %82 = fsub double %53, %81
  %83 = tail call double @llvm.minnum.f64(double %53, double %4)
  %84 = fmul double %83, 2.500000e-01
  %85 = fcmp ult double %82, %84
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #8
  br i1 %85, label %156, label %86

86:                                               ; preds = %79, %52
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %7) #8
  %87 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %1
  %88 = load ptr, ptr %87, align 8
  %89 = getelementptr inbounds %struct.Side, ptr %88, i64 %2
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %7, ptr noundef nonnull align 8 dereferenceable(16) %89, i64 16, i1 false)
  %90 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21
  %91 = load double, ptr %90, align 8
  %92 = fcmp olt double %91, 0x7FF0000000000000
  br i1 %92, label %93, label %132

93:                                               ; preds = %86
  %94 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %1
  %95 = load ptr, ptr %94, align 8
  %96 = getelementptr inbounds double, ptr %95, i64 %2
  %97 = load double, ptr %96, align 8
  %98 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23
  %99 = load ptr, ptr %98, align 8
  %100 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24
  %101 = load ptr, ptr %100, align 8
  %102 = tail call double %99(ptr noundef %101, ptr noundef %12, ptr noundef %16) #8
  %103 = fadd double %97, %102
  %104 = load ptr, ptr %94, align 8
  %105 = getelementptr inbounds double, ptr %104, i64 %14
  store double %103, ptr %105, align 8
  %106 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22
  %107 = load double, ptr %106, align 8
  %108 = sub nsw i64 1, %1
  %109 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %108
  %110 = load ptr, ptr %109, align 8
  %111 = load i64, ptr %0, align 8
  %112 = icmp sgt i64 %111, 0
  br i1 %112, label %113, label %125

113:                                              ; preds = %93, %113
  %114 = phi i64 [ %123, %113 ], [ 0, %93 ]
  %115 = phi double [ %122, %113 ], [ 0.000000e+00, %93 ]
  %116 = getelementptr inbounds double, ptr %110, i64 %114
  %117 = load double, ptr %116, align 8
  %118 = getelementptr inbounds double, ptr %16, i64 %114
  %119 = load double, ptr %118, align 8
  %120 = fsub double %117, %119
  %121 = fmul double %120, %120
  %122 = fadd double %115, %121
  %123 = add nuw nsw i64 %114, 1
  %124 = icmp eq i64 %123, %111
  br i1 %124, label %125, label %113

125:                                              ; preds = %113, %93
  %126 = phi double [ 0.000000e+00, %93 ], [ %122, %113 ]
  %127 = tail call double @llvm.sqrt.f64(double %126)
  %128 = fmul double %107, %127
  %129 = fadd double %103, %128
  %130 = load double, ptr %90, align 8
  %131 = fcmp olt double %129, %130
  br i1 %131, label %132, label %153

132:                                              ; preds = %125, %86
  %133 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %134 = load i64, ptr %133, align 8
  %135 = icmp eq i64 %134, 0
  br i1 %135, label %142, label %136

136:                                              ; preds = %132
  %137 = sub nsw i64 1, %1
  %138 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %137
  %139 = load ptr, ptr %138, align 8
  %140 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %12, ptr noundef %16, ptr noundef nonnull %7, ptr noundef %139)
  %141 = icmp eq i32 %140, 0
  br i1 %141, label %153, label %142

142:                                              ; preds = %136, %132
  %143 = tail call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef %12, ptr noundef %16)
  %144 = icmp eq i32 %143, 0
  br i1 %144, label %153, label %145

145:                                              ; preds = %142
  %146 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 28, i64 %1
  %147 = load ptr, ptr %146, align 8
  %148 = getelementptr inbounds i64, ptr %147, i64 %14
  store i64 %2, ptr %148, align 8
  %149 = load ptr, ptr %87, align 8
  %150 = getelementptr inbounds %struct.Side, ptr %149, i64 %14
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %150, ptr noundef nonnull align 8 dereferenceable(16) %7, i64 16, i1 false)
  %151 = load i64, ptr %13, align 8
  %152 = add nsw i64 %151, 1
  store i64 %152, ptr %13, align 8
  br label %153

153:                                              ; preds = %142, %136, %125, %145
  %154 = phi i64 [ %14, %145 ], [ -1, %125 ], [ -1, %136 ], [ -1, %142 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  br label %156

155:                                              ; preds = %57
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #8
  br label %156

156:                                              ; preds = %155, %79, %153
  %157 = phi i64 [ %154, %153 ], [ -1, %79 ], [ -1, %155 ]
  ret i64 %157
}

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


