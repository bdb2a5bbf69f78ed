; connect.c ea19f3eeb08c252a93913cde041873eadb011f8a09bcc4daf7e71d363ee37f48: written by make kernel

%struct.Side = type { i8, i8, i64 }
%struct.Search = type { i64, ptr, ptr, double, double, ptr, ptr, ptr, double, i64, ptr, ptr, [2 x double], double, ptr, i64, double, i64, ptr, ptr, i64, double, double, ptr, ptr, i64, i64, [2 x ptr], [2 x ptr], [2 x ptr], [2 x ptr], [2 x i64], [2 x i64], i64, i64, ptr }
%struct.Constraints = type { i64, i64, i64, ptr, ptr, ptr, ptr, ptr }

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
  %6 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 34
  %7 = load i64, ptr %6, align 8
  %8 = add nsw i64 %7, %1
  %9 = icmp sgt i64 %1, 0
  br i1 %9, label %10, label %555

10:                                               ; preds = %2
  %11 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %12 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  %13 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %14 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %15 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %16 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 16
  %17 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 35
  %18 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31
  %19 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26
  %20 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31, i64 1
  %21 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 33
  %22 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21
  %23 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25
  %25 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %26 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %27 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27
  %28 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 1
  %29 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20
  br label %31

31:                                               ; preds = %10, %552
  %32 = phi i64 [ %7, %10 ], [ %553, %552 ]
  %33 = load i64, ptr %12, align 8
  %34 = load i64, ptr %11, align 8
  %35 = add nsw i64 %34, 1
  %36 = icmp slt i64 %35, %33
  br i1 %36, label %37, label %48

37:                                               ; preds = %31
  %38 = load ptr, ptr %13, align 8
  br label %39

39:                                               ; preds = %45, %37
  %40 = phi i64 [ %35, %37 ], [ %46, %45 ]
  %41 = phi i64 [ %34, %37 ], [ %40, %45 ]
  %42 = getelementptr inbounds i64, ptr %38, i64 %41
  %43 = load i64, ptr %42, align 8
  %44 = icmp slt i64 %32, %43
  br i1 %44, label %48, label %45

45:                                               ; preds = %39
  store i64 %40, ptr %11, align 8
  %46 = add i64 %40, 1
  %47 = icmp eq i64 %46, %33
  br i1 %47, label %48, label %39

48:                                               ; preds = %39, %45, %31
  %49 = load i64, ptr %0, align 8
  %50 = icmp sgt i64 %49, 0
  br i1 %50, label %51, label %54

51:                                               ; preds = %48
  %52 = load ptr, ptr %14, align 8
  %53 = load ptr, ptr %15, align 8
  br label %69

54:                                               ; preds = %69, %48
  %55 = phi double [ 0.000000e+00, %48 ], [ %78, %69 ]
  %56 = tail call double @llvm.sqrt.f64(double %55)
  %57 = load double, ptr %16, align 8
  %58 = load ptr, ptr %17, align 8
  %59 = icmp eq ptr %58, null
  %60 = select i1 %59, double 1.000000e+00, double 1.562500e-02
  %61 = fmul double %57, %60
  %62 = fdiv double %56, %61
  %63 = fptosi double %62 to i64
  %64 = add nsw i64 %63, 3
  %65 = load i64, ptr %18, align 8
  %66 = add nsw i64 %64, %65
  %67 = load i64, ptr %19, align 8
  %68 = icmp sgt i64 %66, %67
  br i1 %68, label %555, label %81

69:                                               ; preds = %69, %51
  %70 = phi double [ 0.000000e+00, %51 ], [ %78, %69 ]
  %71 = phi i64 [ 0, %51 ], [ %79, %69 ]
  %72 = getelementptr inbounds double, ptr %52, i64 %71
  %73 = load double, ptr %72, align 8
  %74 = getelementptr inbounds double, ptr %53, i64 %71
  %75 = load double, ptr %74, align 8
  %76 = fsub double %73, %75
  %77 = fmul double %76, %76
  %78 = fadd double %70, %77
  %79 = add nuw nsw i64 %71, 1
  %80 = icmp eq i64 %79, %49
  br i1 %80, label %54, label %69

81:                                               ; preds = %54
  %82 = load i64, ptr %20, align 8
  %83 = add nsw i64 %82, %64
  %84 = icmp sgt i64 %83, %67
  br i1 %84, label %555, label %85

85:                                               ; preds = %81
  %86 = load i64, ptr %21, align 8
  %87 = sub nsw i64 1, %86
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %5) #8
  %88 = load double, ptr %22, align 8
  %89 = fcmp olt double %88, 0x7FF0000000000000
  br i1 %89, label %90, label %239

90:                                               ; preds = %85
  %91 = load double, ptr %23, align 8
  %92 = fcmp ogt double %91, 0.000000e+00
  br i1 %92, label %93, label %239

93:                                               ; preds = %90
  %94 = load i64, ptr %24, align 8
  %95 = add i64 %94, -7046029254386353131
  store i64 %95, ptr %24, align 8
  %96 = lshr i64 %95, 30
  %97 = xor i64 %96, %95
  %98 = mul i64 %97, -4658895280553007687
  %99 = lshr i64 %98, 27
  %100 = xor i64 %99, %98
  %101 = mul i64 %100, -7723592293110705685
  %102 = lshr i64 %101, 42
  %103 = lshr i64 %101, 11
  %104 = xor i64 %102, %103
  %105 = uitofp i64 %104 to double
  %106 = fmul double %105, 0x3CA0000000000000
  %107 = load double, ptr %25, align 8
  %108 = fcmp olt double %106, %107
  br i1 %108, label %109, label %239

109:                                              ; preds = %93
  %110 = fdiv double %88, %91
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %3) #8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %4) #8
  %111 = load ptr, ptr %27, align 8
  %112 = load ptr, ptr %28, align 8
  br i1 %50, label %113, label %129

113:                                              ; preds = %109, %113
  %114 = phi i64 [ %123, %113 ], [ 0, %109 ]
  %115 = phi double [ %122, %113 ], [ 0.000000e+00, %109 ]
  %116 = getelementptr inbounds double, ptr %112, i64 %114
  %117 = load double, ptr %116, align 8
  %118 = getelementptr inbounds double, ptr %111, i64 %114
  %119 = load double, ptr %118, align 8
  %120 = fsub double %117, %119
  %121 = fmul double %120, %120
  %122 = fadd double %115, %121
  %123 = add nuw nsw i64 %114, 1
  %124 = icmp eq i64 %123, %49
  br i1 %124, label %125, label %113

125:                                              ; preds = %113, %144
  %126 = phi i64 [ %153, %144 ], [ %95, %113 ]
  %127 = phi i32 [ %145, %144 ], [ 0, %113 ]
  br label %149

128:                                              ; preds = %144
  store i64 %153, ptr %24, align 8
  br label %129

129:                                              ; preds = %128, %109
  %130 = phi i64 [ %153, %128 ], [ %95, %109 ]
  %131 = phi double [ %122, %128 ], [ 0.000000e+00, %109 ]
  %132 = phi i1 [ %146, %128 ], [ false, %109 ]
  %133 = phi double [ %170, %128 ], [ 0.000000e+00, %109 ]
  %134 = tail call double @llvm.sqrt.f64(double %131)
  %135 = fmul double %110, %110
  %136 = fmul double %134, %134
  %137 = fsub double %135, %136
  %138 = tail call double @llvm.maxnum.f64(double %137, double 0.000000e+00)
  %139 = tail call double @llvm.sqrt.f64(double %138)
  %140 = tail call double @llvm.sqrt.f64(double %133)
  %141 = fdiv double 1.000000e+00, %140
  %142 = freeze i1 %132
  %143 = select i1 %142, double %141, double 1.000000e+00
  br i1 %50, label %173, label %238

144:                                              ; preds = %149
  %145 = add nuw nsw i32 %127, 1
  %146 = fcmp ogt double %170, 1.000000e+00
  %147 = icmp ult i32 %127, 999
  %148 = select i1 %146, i1 %147, i1 false
  br i1 %148, label %125, label %128

149:                                              ; preds = %149, %125
  %150 = phi i64 [ %126, %125 ], [ %153, %149 ]
  %151 = phi double [ 0.000000e+00, %125 ], [ %170, %149 ]
  %152 = phi i64 [ 0, %125 ], [ %171, %149 ]
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
  %172 = icmp eq i64 %171, %49
  br i1 %172, label %144, label %149

173:                                              ; preds = %129, %173
  %174 = phi i64 [ %194, %173 ], [ 0, %129 ]
  %175 = phi double [ %193, %173 ], [ 0.000000e+00, %129 ]
  %176 = icmp eq i64 %174, 0
  %177 = select i1 %176, double %110, double %139
  %178 = fmul double %177, 5.000000e-01
  %179 = fmul double %143, %178
  %180 = getelementptr inbounds [64 x double], ptr %3, i64 0, i64 %174
  %181 = load double, ptr %180, align 8
  %182 = fmul double %181, %179
  store double %182, ptr %180, align 8
  %183 = getelementptr inbounds double, ptr %112, i64 %174
  %184 = load double, ptr %183, align 8
  %185 = getelementptr inbounds double, ptr %111, i64 %174
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
  %195 = icmp eq i64 %194, %49
  br i1 %195, label %202, label %173

196:                                              ; preds = %202
  %197 = fmul double %193, 2.000000e+00
  %198 = fcmp ogt double %208, 0.000000e+00
  %199 = fdiv double %197, %208
  %200 = load ptr, ptr %15, align 8
  %201 = load ptr, ptr %14, align 8
  br label %211

202:                                              ; preds = %173, %202
  %203 = phi i64 [ %209, %202 ], [ 0, %173 ]
  %204 = phi double [ %208, %202 ], [ 0.000000e+00, %173 ]
  %205 = getelementptr inbounds [64 x double], ptr %4, i64 0, i64 %203
  %206 = load double, ptr %205, align 8
  %207 = fmul double %206, %206
  %208 = fadd double %204, %207
  %209 = add nuw nsw i64 %203, 1
  %210 = icmp eq i64 %209, %49
  br i1 %210, label %196, label %202

211:                                              ; preds = %226, %196
  %212 = phi i64 [ 0, %196 ], [ %236, %226 ]
  %213 = getelementptr inbounds double, ptr %111, i64 %212
  %214 = load double, ptr %213, align 8
  %215 = getelementptr inbounds double, ptr %112, i64 %212
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
  %230 = getelementptr inbounds double, ptr %200, i64 %212
  %231 = load double, ptr %230, align 8
  %232 = tail call double @llvm.maxnum.f64(double %228, double %231)
  %233 = getelementptr inbounds double, ptr %201, i64 %212
  %234 = load double, ptr %233, align 8
  %235 = tail call double @llvm.minnum.f64(double %232, double %234)
  store double %235, ptr %229, align 8
  %236 = add nuw nsw i64 %212, 1
  %237 = icmp eq i64 %236, %49
  br i1 %237, label %238, label %211

238:                                              ; preds = %226, %129
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %4) #8
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %3) #8
  br label %314

239:                                              ; preds = %93, %90, %85
  %240 = load i64, ptr %24, align 8
  %241 = add i64 %240, -7046029254386353131
  store i64 %241, ptr %24, align 8
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
  %253 = load double, ptr %25, align 8
  %254 = fcmp olt double %252, %253
  br i1 %254, label %255, label %270

255:                                              ; preds = %239
  %256 = load double, ptr %26, align 8
  %257 = add i64 %240, 4354685564936845354
  store i64 %257, ptr %24, align 8
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
  br i1 %50, label %273, label %314

273:                                              ; preds = %270
  %274 = load ptr, ptr %27, align 8
  %275 = load ptr, ptr %28, align 8
  %276 = load ptr, ptr %15, align 8
  %277 = load ptr, ptr %14, align 8
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
  %287 = tail call double @llvm.minnum.f64(double %282, double %284)
  %288 = fsub double %287, %272
  %289 = tail call double @llvm.maxnum.f64(double %286, double %288)
  %290 = getelementptr inbounds double, ptr %277, i64 %280
  %291 = load double, ptr %290, align 8
  %292 = tail call double @llvm.maxnum.f64(double %282, double %284)
  %293 = fadd double %272, %292
  %294 = tail call double @llvm.minnum.f64(double %291, double %293)
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
  %312 = icmp eq i64 %311, %49
  br i1 %312, label %313, label %278

313:                                              ; preds = %278
  store i64 %295, ptr %24, align 8
  br label %314

314:                                              ; preds = %238, %270, %313
  %315 = phi i64 [ %130, %238 ], [ %271, %270 ], [ %295, %313 ]
  br i1 %89, label %316, label %330

316:                                              ; preds = %314
  %317 = add i64 %315, -7046029254386353131
  store i64 %317, ptr %24, align 8
  %318 = lshr i64 %317, 30
  %319 = xor i64 %318, %317
  %320 = mul i64 %319, -4658895280553007687
  %321 = lshr i64 %320, 27
  %322 = xor i64 %321, %320
  %323 = mul i64 %322, -7723592293110705685
  %324 = lshr i64 %323, 42
  %325 = lshr i64 %323, 11
  %326 = xor i64 %324, %325
  %327 = uitofp i64 %326 to double
  %328 = fmul double %327, 0x3CA0000000000000
  %329 = fmul double %88, %328
  br label %330

330:                                              ; preds = %314, %316
  %331 = phi double [ %329, %316 ], [ 0.000000e+00, %314 ]
  %332 = add nsw i64 %32, 1
  store i64 %332, ptr %6, align 8
  %333 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31, i64 %86
  %334 = load i64, ptr %333, align 8
  %335 = icmp sgt i64 %334, 0
  br i1 %335, label %336, label %380

336:                                              ; preds = %330
  %337 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %86
  %338 = load ptr, ptr %337, align 8
  %339 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %86
  %340 = fcmp oeq double %88, 0x7FF0000000000000
  br label %341

341:                                              ; preds = %375, %336
  %342 = phi i64 [ 0, %336 ], [ %377, %375 ]
  %343 = phi i64 [ 0, %336 ], [ %378, %375 ]
  %344 = phi double [ 0x7FF0000000000000, %336 ], [ %376, %375 ]
  %345 = mul nsw i64 %343, %49
  %346 = getelementptr inbounds double, ptr %338, i64 %345
  br i1 %50, label %350, label %347

347:                                              ; preds = %350, %341
  %348 = phi double [ 0.000000e+00, %341 ], [ %359, %350 ]
  %349 = fcmp olt double %348, %344
  br i1 %349, label %362, label %375

350:                                              ; preds = %341, %350
  %351 = phi i64 [ %360, %350 ], [ 0, %341 ]
  %352 = phi double [ %359, %350 ], [ 0.000000e+00, %341 ]
  %353 = getelementptr inbounds double, ptr %5, i64 %351
  %354 = load double, ptr %353, align 8
  %355 = getelementptr inbounds double, ptr %346, i64 %351
  %356 = load double, ptr %355, align 8
  %357 = fsub double %354, %356
  %358 = fmul double %357, %357
  %359 = fadd double %352, %358
  %360 = add nuw nsw i64 %351, 1
  %361 = icmp eq i64 %360, %49
  br i1 %361, label %347, label %350

362:                                              ; preds = %347
  %363 = icmp eq i64 %343, 0
  %364 = select i1 %363, i1 true, i1 %340
  br i1 %364, label %374, label %365

365:                                              ; preds = %362
  %366 = load ptr, ptr %339, align 8
  %367 = getelementptr inbounds double, ptr %366, i64 %343
  %368 = load double, ptr %367, align 8
  %369 = load double, ptr %23, align 8
  %370 = tail call double @llvm.sqrt.f64(double %348)
  %371 = fmul double %370, %369
  %372 = fadd double %368, %371
  %373 = fcmp ugt double %372, %331
  br i1 %373, label %375, label %374

374:                                              ; preds = %365, %362
  br label %375

375:                                              ; preds = %374, %365, %347
  %376 = phi double [ %348, %374 ], [ %344, %365 ], [ %344, %347 ]
  %377 = phi i64 [ %343, %374 ], [ %342, %365 ], [ %342, %347 ]
  %378 = add nuw nsw i64 %343, 1
  %379 = icmp eq i64 %378, %334
  br i1 %379, label %380, label %341

380:                                              ; preds = %375, %330
  %381 = phi i64 [ 0, %330 ], [ %377, %375 ]
  %382 = call fastcc i64 @extend_by(ptr noundef %0, i64 noundef %86, i64 noundef %381, ptr noundef nonnull %5, double noundef %57)
  %383 = load ptr, ptr %17, align 8
  %384 = icmp ne ptr %383, null
  %385 = icmp slt i64 %382, 0
  %386 = select i1 %384, i1 %385, i1 false
  br i1 %386, label %387, label %396

387:                                              ; preds = %380, %387
  %388 = phi double [ %392, %387 ], [ 2.500000e-01, %380 ]
  %389 = load double, ptr %16, align 8
  %390 = fmul double %388, %389
  %391 = call fastcc i64 @extend_by(ptr noundef nonnull %0, i64 noundef %86, i64 noundef %381, ptr noundef nonnull %5, double noundef %390)
  %392 = fmul double %388, 2.500000e-01
  %393 = icmp slt i64 %391, 0
  %394 = fcmp oge double %392, 6.250000e-02
  %395 = select i1 %393, i1 %394, i1 false
  br i1 %395, label %387, label %396

396:                                              ; preds = %387, %380
  %397 = phi i64 [ %382, %380 ], [ %391, %387 ]
  %398 = icmp slt i64 %397, 0
  br i1 %398, label %552, label %399

399:                                              ; preds = %396
  %400 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %86
  %401 = load ptr, ptr %400, align 8
  %402 = load i64, ptr %0, align 8
  %403 = mul nsw i64 %402, %397
  %404 = getelementptr inbounds double, ptr %401, i64 %403
  %405 = shl i64 %402, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 16 %5, ptr align 8 %404, i64 %405, i1 false)
  %406 = load double, ptr %22, align 8
  %407 = fcmp olt double %406, 0x7FF0000000000000
  br i1 %407, label %408, label %414

408:                                              ; preds = %399
  %409 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %86
  %410 = load ptr, ptr %409, align 8
  %411 = getelementptr inbounds double, ptr %410, i64 %397
  %412 = load double, ptr %411, align 8
  %413 = fsub double %406, %412
  br label %414

414:                                              ; preds = %399, %408
  %415 = phi double [ %413, %408 ], [ 0.000000e+00, %399 ]
  %416 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 31, i64 %87
  %417 = load i64, ptr %416, align 8
  %418 = icmp sgt i64 %417, 0
  br i1 %418, label %419, label %466

419:                                              ; preds = %414
  %420 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %87
  %421 = load ptr, ptr %420, align 8
  %422 = icmp sgt i64 %402, 0
  %423 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %87
  %424 = fcmp oeq double %406, 0x7FF0000000000000
  br label %425

425:                                              ; preds = %459, %419
  %426 = phi i64 [ 0, %419 ], [ %461, %459 ]
  %427 = phi i64 [ 0, %419 ], [ %462, %459 ]
  %428 = phi double [ 0x7FF0000000000000, %419 ], [ %460, %459 ]
  %429 = mul nsw i64 %427, %402
  %430 = getelementptr inbounds double, ptr %421, i64 %429
  br i1 %422, label %434, label %431

431:                                              ; preds = %434, %425
  %432 = phi double [ 0.000000e+00, %425 ], [ %443, %434 ]
  %433 = fcmp olt double %432, %428
  br i1 %433, label %446, label %459

434:                                              ; preds = %425, %434
  %435 = phi i64 [ %444, %434 ], [ 0, %425 ]
  %436 = phi double [ %443, %434 ], [ 0.000000e+00, %425 ]
  %437 = getelementptr inbounds double, ptr %5, i64 %435
  %438 = load double, ptr %437, align 8
  %439 = getelementptr inbounds double, ptr %430, i64 %435
  %440 = load double, ptr %439, align 8
  %441 = fsub double %438, %440
  %442 = fmul double %441, %441
  %443 = fadd double %436, %442
  %444 = add nuw nsw i64 %435, 1
  %445 = icmp eq i64 %444, %402
  br i1 %445, label %431, label %434

446:                                              ; preds = %431
  %447 = icmp eq i64 %427, 0
  %448 = select i1 %447, i1 true, i1 %424
  br i1 %448, label %458, label %449

449:                                              ; preds = %446
  %450 = load ptr, ptr %423, align 8
  %451 = getelementptr inbounds double, ptr %450, i64 %427
  %452 = load double, ptr %451, align 8
  %453 = load double, ptr %23, align 8
  %454 = tail call double @llvm.sqrt.f64(double %432)
  %455 = fmul double %454, %453
  %456 = fadd double %452, %455
  %457 = fcmp ugt double %456, %415
  br i1 %457, label %459, label %458

458:                                              ; preds = %449, %446
  br label %459

459:                                              ; preds = %458, %449, %431
  %460 = phi double [ %432, %458 ], [ %428, %449 ], [ %428, %431 ]
  %461 = phi i64 [ %427, %458 ], [ %426, %449 ], [ %426, %431 ]
  %462 = add nuw nsw i64 %427, 1
  %463 = icmp eq i64 %462, %417
  br i1 %463, label %464, label %425

464:                                              ; preds = %459
  %465 = icmp sgt i64 %461, -1
  br i1 %465, label %466, label %547

466:                                              ; preds = %414, %464
  %467 = phi i64 [ %461, %464 ], [ 0, %414 ]
  %468 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %87
  br label %469

469:                                              ; preds = %466, %544
  %470 = phi i64 [ %467, %466 ], [ %545, %544 ]
  %471 = load ptr, ptr %468, align 8
  %472 = load i64, ptr %0, align 8
  %473 = mul nsw i64 %472, %470
  %474 = getelementptr inbounds double, ptr %471, i64 %473
  %475 = shl i64 %472, 3
  %476 = call i32 @bcmp(ptr %474, ptr nonnull %5, i64 %475)
  %477 = icmp eq i32 %476, 0
  br i1 %477, label %478, label %528

478:                                              ; preds = %469
  %479 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %86
  %480 = load ptr, ptr %479, align 8
  %481 = getelementptr inbounds %struct.Side, ptr %480, i64 %397
  %482 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %87
  %483 = load ptr, ptr %482, align 8
  %484 = getelementptr inbounds %struct.Side, ptr %483, i64 %470
  %485 = load double, ptr %22, align 8
  %486 = fcmp olt double %485, 0x7FF0000000000000
  br i1 %486, label %487, label %493

487:                                              ; preds = %478
  %488 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %87
  %489 = load ptr, ptr %488, align 8
  %490 = getelementptr inbounds double, ptr %489, i64 %470
  %491 = load double, ptr %490, align 8
  %492 = fcmp olt double %491, %415
  br i1 %492, label %493, label %547

493:                                              ; preds = %487, %478
  %494 = load i64, ptr %29, align 8
  %495 = icmp eq i64 %494, 0
  br i1 %495, label %525, label %496

496:                                              ; preds = %493
  %497 = getelementptr inbounds %struct.Side, ptr %480, i64 %397, i32 2
  %498 = load i64, ptr %497, align 8
  %499 = getelementptr inbounds %struct.Side, ptr %483, i64 %470, i32 2
  %500 = load i64, ptr %499, align 8
  %501 = add nsw i64 %500, %498
  %502 = load i8, ptr %481, align 8
  %503 = load i8, ptr %484, align 8
  %504 = xor i8 %503, %502
  %505 = getelementptr inbounds %struct.Side, ptr %480, i64 %397, i32 1
  %506 = load i8, ptr %505, align 1
  %507 = and i8 %504, %506
  %508 = getelementptr inbounds %struct.Side, ptr %483, i64 %470, i32 1
  %509 = load i8, ptr %508, align 1
  %510 = and i8 %507, %509
  %511 = icmp eq i8 %510, 0
  br i1 %511, label %519, label %512

512:                                              ; preds = %496, %512
  %513 = phi i32 [ %515, %512 ], [ 0, %496 ]
  %514 = phi i8 [ %517, %512 ], [ %510, %496 ]
  %515 = add nuw nsw i32 %513, 1
  %516 = add i8 %514, -1
  %517 = and i8 %516, %514
  %518 = icmp eq i8 %517, 0
  br i1 %518, label %519, label %512

519:                                              ; preds = %512, %496
  %520 = phi i32 [ 0, %496 ], [ %515, %512 ]
  %521 = sext i32 %520 to i64
  %522 = add nsw i64 %501, %521
  %523 = load i64, ptr %30, align 8
  %524 = icmp sgt i64 %522, %523
  br i1 %524, label %547, label %525

525:                                              ; preds = %519, %493
  %526 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 32, i64 %86
  store i64 %397, ptr %526, align 8
  %527 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 32, i64 %87
  store i64 %470, ptr %527, align 8
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %5) #8
  br label %555

528:                                              ; preds = %469
  %529 = load double, ptr %16, align 8
  %530 = call fastcc i64 @extend_by(ptr noundef nonnull %0, i64 noundef %87, i64 noundef %470, ptr noundef nonnull %5, double noundef %529)
  %531 = load ptr, ptr %17, align 8
  %532 = icmp ne ptr %531, null
  %533 = icmp slt i64 %530, 0
  %534 = select i1 %532, i1 %533, i1 false
  br i1 %534, label %535, label %544

535:                                              ; preds = %528, %535
  %536 = phi double [ %540, %535 ], [ 2.500000e-01, %528 ]
  %537 = load double, ptr %16, align 8
  %538 = fmul double %536, %537
  %539 = call fastcc i64 @extend_by(ptr noundef nonnull %0, i64 noundef %87, i64 noundef %470, ptr noundef nonnull %5, double noundef %538)
  %540 = fmul double %536, 2.500000e-01
  %541 = icmp slt i64 %539, 0
  %542 = fcmp oge double %540, 6.250000e-02
  %543 = select i1 %541, i1 %542, i1 false
  br i1 %543, label %535, label %544

544:                                              ; preds = %535, %528
  %545 = phi i64 [ %530, %528 ], [ %539, %535 ]
  %546 = icmp sgt i64 %545, -1
  br i1 %546, label %469, label %547

547:                                              ; preds = %544, %464, %519, %487
  %548 = load i64, ptr %18, align 8
  %549 = load i64, ptr %20, align 8
  %550 = icmp sgt i64 %548, %549
  %551 = zext i1 %550 to i64
  store i64 %551, ptr %21, align 8
  br label %552

552:                                              ; preds = %547, %396
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %5) #8
  %553 = load i64, ptr %6, align 8
  %554 = icmp slt i64 %553, %8
  br i1 %554, label %31, label %555

555:                                              ; preds = %81, %552, %54, %2, %525
  %556 = phi i32 [ 1, %525 ], [ 0, %2 ], [ 2, %81 ], [ 0, %552 ], [ 2, %54 ]
  ret i32 %556
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
  %3 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 7
  %4 = load ptr, ptr %3, align 8
  %5 = getelementptr inbounds double, ptr %4, i64 12
  %6 = load i64, ptr %0, align 8
  %7 = mul nsw i64 %6, 6
  %8 = getelementptr inbounds double, ptr %5, i64 %7
  %9 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 2
  %10 = load i64, ptr %9, align 8
  %11 = icmp eq i64 %10, 0
  br i1 %11, label %19, label %12

12:                                               ; preds = %2
  %13 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 4
  %14 = load ptr, ptr %13, align 8
  %15 = tail call i32 %14(ptr noundef %1, ptr noundef %4, i64 noundef 1) #8
  %16 = icmp eq i32 %15, 0
  br i1 %16, label %17, label %77

17:                                               ; preds = %12
  %18 = load i64, ptr %9, align 8
  br label %19

19:                                               ; preds = %17, %2
  %20 = phi i64 [ %18, %17 ], [ 0, %2 ]
  %21 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 1
  %22 = load i64, ptr %21, align 8
  %23 = icmp sgt i64 %22, %20
  br i1 %23, label %24, label %31

24:                                               ; preds = %19
  %25 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 5
  %26 = load ptr, ptr %25, align 8
  %27 = tail call i32 %26(ptr noundef %1, ptr noundef nonnull %8, i64 noundef 1) #8
  %28 = icmp eq i32 %27, 0
  br i1 %28, label %29, label %77

29:                                               ; preds = %24
  %30 = load i64, ptr %21, align 8
  br label %31

31:                                               ; preds = %29, %19
  %32 = phi i64 [ %30, %29 ], [ %22, %19 ]
  %33 = icmp sgt i64 %32, 0
  br i1 %33, label %34, label %77

34:                                               ; preds = %31
  %35 = load i64, ptr %9, align 8
  %36 = getelementptr inbounds %struct.Constraints, ptr %0, i64 0, i32 3
  br label %37

37:                                               ; preds = %63, %34
  %38 = phi double [ 0.000000e+00, %34 ], [ %68, %63 ]
  %39 = phi i64 [ 0, %34 ], [ %70, %63 ]
  %40 = phi i64 [ -1, %34 ], [ %69, %63 ]
  %41 = icmp slt i64 %39, %35
  br i1 %41, label %42, label %59

42:                                               ; preds = %37
  %43 = load ptr, ptr %36, align 8
  %44 = mul nsw i64 %39, 13
  %45 = getelementptr inbounds double, ptr %43, i64 %44
  %46 = getelementptr inbounds double, ptr %45, i64 12
  %47 = load double, ptr %46, align 8
  br label %48

48:                                               ; preds = %48, %42
  %49 = phi i64 [ 0, %42 ], [ %57, %48 ]
  %50 = phi double [ %47, %42 ], [ %56, %48 ]
  %51 = getelementptr inbounds double, ptr %45, i64 %49
  %52 = load double, ptr %51, align 8
  %53 = getelementptr inbounds double, ptr %4, i64 %49
  %54 = load double, ptr %53, align 8
  %55 = fmul double %52, %54
  %56 = fadd double %50, %55
  %57 = add nuw nsw i64 %49, 1
  %58 = icmp eq i64 %57, 12
  br i1 %58, label %63, label %48

59:                                               ; preds = %37
  %60 = sub nsw i64 %39, %35
  %61 = getelementptr inbounds double, ptr %8, i64 %60
  %62 = load double, ptr %61, align 8
  br label %63

63:                                               ; preds = %48, %59
  %64 = phi double [ %62, %59 ], [ %56, %48 ]
  %65 = icmp slt i64 %40, 0
  %66 = fcmp ult double %64, %38
  %67 = select i1 %65, i1 true, i1 %66
  %68 = select i1 %67, double %64, double %38
  %69 = select i1 %67, i64 %39, i64 %40
  %70 = add nuw nsw i64 %39, 1
  %71 = icmp eq i64 %70, %32
  br i1 %71, label %72, label %37

72:                                               ; preds = %63
  %73 = icmp sgt i64 %69, -1
  %74 = fcmp oge double %68, 0.000000e+00
  %75 = select i1 %73, i1 %74, i1 false
  %76 = zext i1 %75 to i32
  br label %77

77:                                               ; preds = %72, %12, %24, %31
  %78 = phi i32 [ 0, %31 ], [ 0, %24 ], [ 0, %12 ], [ %76, %72 ]
  ret i32 %78
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
  br i1 %56, label %336, label %57

57:                                               ; preds = %52
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %6) #8
  %58 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %59 = load ptr, ptr %58, align 8
  %60 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %61 = load ptr, ptr %60, align 8
  %62 = tail call fastcc i32 @keeps(ptr noundef nonnull %55, ptr noundef %16)
  %63 = icmp eq i32 %62, 0
  br i1 %63, label %64, label %314

64:                                               ; preds = %57
  %65 = getelementptr inbounds %struct.Constraints, ptr %55, i64 0, i32 6
  %66 = getelementptr inbounds %struct.Constraints, ptr %55, i64 0, i32 7
  %67 = getelementptr inbounds %struct.Constraints, ptr %55, i64 0, i32 2
  %68 = getelementptr inbounds %struct.Constraints, ptr %55, i64 0, i32 4
  %69 = getelementptr inbounds %struct.Constraints, ptr %55, i64 0, i32 1
  %70 = getelementptr inbounds %struct.Constraints, ptr %55, i64 0, i32 5
  %71 = getelementptr inbounds %struct.Constraints, ptr %55, i64 0, i32 3
  %72 = load ptr, ptr %66, align 8
  %73 = load i64, ptr %55, align 8
  %74 = load i64, ptr %67, align 8
  br label %75

75:                                               ; preds = %303, %64
  %76 = phi i64 [ %74, %64 ], [ %107, %303 ]
  %77 = phi i64 [ %73, %64 ], [ %239, %303 ]
  %78 = phi ptr [ %72, %64 ], [ %153, %303 ]
  %79 = phi i1 [ false, %64 ], [ %305, %303 ]
  %80 = phi i32 [ 0, %64 ], [ %304, %303 ]
  %81 = phi double [ 0.000000e+00, %64 ], [ %146, %303 ]
  %82 = load ptr, ptr %65, align 8
  %83 = getelementptr inbounds double, ptr %78, i64 12
  %84 = mul nsw i64 %77, 6
  %85 = getelementptr inbounds double, ptr %83, i64 %84
  %86 = icmp eq i64 %76, 0
  br i1 %86, label %93, label %87

87:                                               ; preds = %75
  %88 = load ptr, ptr %68, align 8
  %89 = tail call i32 %88(ptr noundef %16, ptr noundef %78, i64 noundef 1) #8
  %90 = icmp eq i32 %89, 0
  br i1 %90, label %91, label %405

91:                                               ; preds = %87
  %92 = load i64, ptr %67, align 8
  br label %93

93:                                               ; preds = %91, %75
  %94 = phi i64 [ %92, %91 ], [ 0, %75 ]
  %95 = load i64, ptr %69, align 8
  %96 = icmp sgt i64 %95, %94
  br i1 %96, label %97, label %103

97:                                               ; preds = %93
  %98 = load ptr, ptr %70, align 8
  %99 = tail call i32 %98(ptr noundef %16, ptr noundef nonnull %85, i64 noundef 1) #8
  %100 = icmp eq i32 %99, 0
  br i1 %100, label %101, label %405

101:                                              ; preds = %97
  %102 = load i64, ptr %69, align 8
  br label %103

103:                                              ; preds = %101, %93
  %104 = phi i64 [ %102, %101 ], [ %95, %93 ]
  %105 = icmp sgt i64 %104, 0
  br i1 %105, label %106, label %405

106:                                              ; preds = %103
  %107 = load i64, ptr %67, align 8
  %108 = icmp eq ptr %82, null
  br label %109

109:                                              ; preds = %141, %106
  %110 = phi double [ %81, %106 ], [ %146, %141 ]
  %111 = phi i64 [ 0, %106 ], [ %148, %141 ]
  %112 = phi i64 [ -1, %106 ], [ %147, %141 ]
  %113 = icmp slt i64 %111, %107
  br i1 %113, label %114, label %131

114:                                              ; preds = %109
  %115 = load ptr, ptr %71, align 8
  %116 = mul nsw i64 %111, 13
  %117 = getelementptr inbounds double, ptr %115, i64 %116
  %118 = getelementptr inbounds double, ptr %117, i64 12
  %119 = load double, ptr %118, align 8
  br label %120

120:                                              ; preds = %120, %114
  %121 = phi i64 [ 0, %114 ], [ %129, %120 ]
  %122 = phi double [ %119, %114 ], [ %128, %120 ]
  %123 = getelementptr inbounds double, ptr %117, i64 %121
  %124 = load double, ptr %123, align 8
  %125 = getelementptr inbounds double, ptr %78, i64 %121
  %126 = load double, ptr %125, align 8
  %127 = fmul double %124, %126
  %128 = fadd double %122, %127
  %129 = add nuw nsw i64 %121, 1
  %130 = icmp eq i64 %129, 12
  br i1 %130, label %135, label %120

131:                                              ; preds = %109
  %132 = sub nsw i64 %111, %107
  %133 = getelementptr inbounds double, ptr %85, i64 %132
  %134 = load double, ptr %133, align 8
  br label %135

135:                                              ; preds = %120, %131
  %136 = phi double [ %134, %131 ], [ %128, %120 ]
  br i1 %108, label %141, label %137

137:                                              ; preds = %135
  %138 = getelementptr inbounds double, ptr %82, i64 %111
  %139 = load double, ptr %138, align 8
  %140 = fsub double %136, %139
  br label %141

141:                                              ; preds = %137, %135
  %142 = phi double [ %140, %137 ], [ %136, %135 ]
  %143 = icmp slt i64 %112, 0
  %144 = fcmp ult double %142, %110
  %145 = select i1 %143, i1 true, i1 %144
  %146 = select i1 %145, double %142, double %110
  %147 = select i1 %145, i64 %111, i64 %112
  %148 = add nuw nsw i64 %111, 1
  %149 = icmp eq i64 %148, %104
  br i1 %149, label %150, label %109

150:                                              ; preds = %141
  %151 = fcmp ult double %146, 0.000000e+00
  br i1 %151, label %152, label %307

152:                                              ; preds = %150
  %153 = load ptr, ptr %66, align 8
  %154 = getelementptr inbounds double, ptr %153, i64 12
  %155 = icmp slt i64 %147, %107
  br i1 %155, label %168, label %156

156:                                              ; preds = %152
  %157 = load i64, ptr %55, align 8
  %158 = icmp sgt i64 %157, 0
  br i1 %158, label %159, label %307

159:                                              ; preds = %156
  %160 = mul nsw i64 %157, 6
  %161 = getelementptr inbounds double, ptr %154, i64 %160
  %162 = sub nsw i64 %104, %107
  %163 = getelementptr inbounds double, ptr %161, i64 %162
  %164 = sub nsw i64 %147, %107
  %165 = mul nsw i64 %157, %164
  %166 = getelementptr double, ptr %163, i64 %165
  %167 = shl nuw i64 %157, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 16 %6, ptr align 8 %166, i64 %167, i1 false)
  br label %238

168:                                              ; preds = %152
  %169 = load ptr, ptr %71, align 8
  %170 = mul nsw i64 %147, 13
  %171 = getelementptr inbounds double, ptr %169, i64 %170
  %172 = load i64, ptr %55, align 8
  %173 = icmp sgt i64 %172, 0
  br i1 %173, label %174, label %307

174:                                              ; preds = %168
  %175 = getelementptr inbounds double, ptr %171, i64 1
  %176 = getelementptr inbounds double, ptr %171, i64 2
  %177 = load double, ptr %171, align 8
  %178 = load double, ptr %175, align 8
  %179 = load double, ptr %176, align 8
  br label %180

180:                                              ; preds = %201, %174
  %181 = phi i64 [ 0, %174 ], [ %202, %201 ]
  %182 = mul nuw nsw i64 %181, 6
  %183 = getelementptr inbounds double, ptr %154, i64 %182
  %184 = getelementptr inbounds double, ptr %183, i64 3
  %185 = load double, ptr %183, align 8
  %186 = fmul double %177, %185
  %187 = getelementptr inbounds double, ptr %183, i64 1
  %188 = load double, ptr %187, align 8
  %189 = fmul double %178, %188
  %190 = fadd double %186, %189
  %191 = getelementptr inbounds double, ptr %183, i64 2
  %192 = load double, ptr %191, align 8
  %193 = fmul double %179, %192
  %194 = fadd double %190, %193
  %195 = getelementptr inbounds double, ptr %6, i64 %181
  %196 = getelementptr inbounds double, ptr %184, i64 1
  %197 = getelementptr inbounds double, ptr %184, i64 2
  %198 = load double, ptr %196, align 8
  %199 = load double, ptr %197, align 8
  %200 = load double, ptr %184, align 8
  br label %204

201:                                              ; preds = %204
  store double %233, ptr %195, align 8
  %202 = add nuw nsw i64 %181, 1
  %203 = icmp eq i64 %202, %172
  br i1 %203, label %236, label %180

204:                                              ; preds = %204, %180
  %205 = phi double [ %194, %180 ], [ %233, %204 ]
  %206 = phi i64 [ 3, %180 ], [ %234, %204 ]
  %207 = getelementptr inbounds double, ptr %153, i64 %206
  %208 = getelementptr inbounds double, ptr %171, i64 %206
  %209 = load double, ptr %208, align 8
  %210 = getelementptr inbounds double, ptr %207, i64 2
  %211 = load double, ptr %210, align 8
  %212 = fmul double %198, %211
  %213 = getelementptr inbounds double, ptr %207, i64 1
  %214 = load double, ptr %213, align 8
  %215 = fmul double %199, %214
  %216 = fsub double %212, %215
  %217 = fmul double %209, %216
  %218 = getelementptr inbounds double, ptr %208, i64 1
  %219 = load double, ptr %218, align 8
  %220 = load double, ptr %207, align 8
  %221 = fmul double %199, %220
  %222 = fmul double %211, %200
  %223 = fsub double %221, %222
  %224 = fmul double %219, %223
  %225 = fadd double %217, %224
  %226 = getelementptr inbounds double, ptr %208, i64 2
  %227 = load double, ptr %226, align 8
  %228 = fmul double %214, %200
  %229 = fmul double %198, %220
  %230 = fsub double %228, %229
  %231 = fmul double %227, %230
  %232 = fadd double %231, %225
  %233 = fadd double %205, %232
  %234 = add nuw nsw i64 %206, 3
  %235 = icmp ult i64 %206, 9
  br i1 %235, label %204, label %201

236:                                              ; preds = %201
  %237 = icmp sgt i64 %172, 0
  br i1 %237, label %238, label %307

238:                                              ; preds = %159, %236
  %239 = phi i64 [ %157, %159 ], [ %172, %236 ]
  br label %244

240:                                              ; preds = %264
  %241 = fcmp ogt double %267, 0x3D719799812DEA11
  br i1 %241, label %242, label %307

242:                                              ; preds = %240
  %243 = fneg double %146
  br label %276

244:                                              ; preds = %238, %264
  %245 = phi i64 [ %268, %264 ], [ 0, %238 ]
  %246 = phi double [ %267, %264 ], [ 0.000000e+00, %238 ]
  %247 = getelementptr inbounds double, ptr %16, i64 %245
  %248 = load double, ptr %247, align 8
  %249 = getelementptr inbounds double, ptr %59, i64 %245
  %250 = load double, ptr %249, align 8
  %251 = fcmp ole double %248, %250
  %252 = getelementptr inbounds double, ptr %6, i64 %245
  %253 = load double, ptr %252, align 8
  %254 = fcmp olt double %253, 0.000000e+00
  %255 = select i1 %251, i1 %254, i1 false
  br i1 %255, label %262, label %256

256:                                              ; preds = %244
  %257 = getelementptr inbounds double, ptr %61, i64 %245
  %258 = load double, ptr %257, align 8
  %259 = fcmp oge double %248, %258
  %260 = fcmp ogt double %253, 0.000000e+00
  %261 = select i1 %259, i1 %260, i1 false
  br i1 %261, label %262, label %264

262:                                              ; preds = %244, %256
  %263 = getelementptr inbounds double, ptr %6, i64 %245
  store double 0.000000e+00, ptr %263, align 8
  br label %264

264:                                              ; preds = %262, %256
  %265 = phi double [ 0.000000e+00, %262 ], [ %253, %256 ]
  %266 = fmul double %265, %265
  %267 = fadd double %246, %266
  %268 = add nuw nsw i64 %245, 1
  %269 = icmp eq i64 %268, %239
  br i1 %269, label %240, label %244

270:                                              ; preds = %276
  %271 = fcmp ogt double %284, 5.000000e-01
  %272 = fdiv double 5.000000e-01, %284
  %273 = select i1 %271, double %272, double 1.000000e+00
  %274 = fmul double %273, %243
  %275 = fdiv double %274, %267
  br label %287

276:                                              ; preds = %276, %242
  %277 = phi i64 [ 0, %242 ], [ %285, %276 ]
  %278 = phi double [ 0.000000e+00, %242 ], [ %284, %276 ]
  %279 = getelementptr inbounds double, ptr %6, i64 %277
  %280 = load double, ptr %279, align 8
  %281 = tail call double @llvm.fabs.f64(double %280)
  %282 = fmul double %281, %243
  %283 = fdiv double %282, %267
  %284 = tail call double @llvm.maxnum.f64(double %278, double %283)
  %285 = add nuw nsw i64 %277, 1
  %286 = icmp eq i64 %285, %239
  br i1 %286, label %270, label %276

287:                                              ; preds = %270, %287
  %288 = phi i64 [ %301, %287 ], [ 0, %270 ]
  %289 = getelementptr inbounds double, ptr %16, i64 %288
  %290 = load double, ptr %289, align 8
  %291 = getelementptr inbounds double, ptr %6, i64 %288
  %292 = load double, ptr %291, align 8
  %293 = fmul double %275, %292
  %294 = fadd double %290, %293
  %295 = getelementptr inbounds double, ptr %59, i64 %288
  %296 = load double, ptr %295, align 8
  %297 = tail call double @llvm.maxnum.f64(double %294, double %296)
  %298 = getelementptr inbounds double, ptr %61, i64 %288
  %299 = load double, ptr %298, align 8
  %300 = tail call double @llvm.minnum.f64(double %297, double %299)
  store double %300, ptr %289, align 8
  %301 = add nuw nsw i64 %288, 1
  %302 = icmp eq i64 %301, %239
  br i1 %302, label %303, label %287

303:                                              ; preds = %287
  %304 = add nuw nsw i32 %80, 1
  %305 = icmp ugt i32 %80, 38
  %306 = icmp eq i32 %304, 40
  br i1 %306, label %309, label %75

307:                                              ; preds = %240, %236, %168, %156, %150
  %308 = phi i32 [ 0, %240 ], [ 1, %150 ], [ 0, %236 ], [ 0, %156 ], [ 0, %168 ]
  br i1 %79, label %309, label %311

309:                                              ; preds = %303, %307
  %310 = tail call fastcc i32 @keeps(ptr noundef nonnull %55, ptr noundef %16)
  br label %311

311:                                              ; preds = %307, %309
  %312 = phi i32 [ %310, %309 ], [ %308, %307 ]
  %313 = icmp eq i32 %312, 0
  br i1 %313, label %405, label %314

314:                                              ; preds = %57, %311
  %315 = load i64, ptr %0, align 8
  %316 = icmp sgt i64 %315, 0
  br i1 %316, label %317, label %329

317:                                              ; preds = %314, %317
  %318 = phi i64 [ %327, %317 ], [ 0, %314 ]
  %319 = phi double [ %326, %317 ], [ 0.000000e+00, %314 ]
  %320 = getelementptr inbounds double, ptr %3, i64 %318
  %321 = load double, ptr %320, align 8
  %322 = getelementptr inbounds double, ptr %16, i64 %318
  %323 = load double, ptr %322, align 8
  %324 = fsub double %321, %323
  %325 = fmul double %324, %324
  %326 = fadd double %319, %325
  %327 = add nuw nsw i64 %318, 1
  %328 = icmp eq i64 %327, %315
  br i1 %328, label %329, label %317

329:                                              ; preds = %317, %314
  %330 = phi double [ 0.000000e+00, %314 ], [ %326, %317 ]
  %331 = tail call double @llvm.sqrt.f64(double %330)
  %332 = fsub double %53, %331
  %333 = tail call double @llvm.minnum.f64(double %53, double %4)
  %334 = fmul double %333, 2.500000e-01
  %335 = fcmp ult double %332, %334
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #8
  br i1 %335, label %406, label %336

336:                                              ; preds = %329, %52
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %7) #8
  %337 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %1
  %338 = load ptr, ptr %337, align 8
  %339 = getelementptr inbounds %struct.Side, ptr %338, i64 %2
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %7, ptr noundef nonnull align 8 dereferenceable(16) %339, i64 16, i1 false)
  %340 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21
  %341 = load double, ptr %340, align 8
  %342 = fcmp olt double %341, 0x7FF0000000000000
  br i1 %342, label %343, label %382

343:                                              ; preds = %336
  %344 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 30, i64 %1
  %345 = load ptr, ptr %344, align 8
  %346 = getelementptr inbounds double, ptr %345, i64 %2
  %347 = load double, ptr %346, align 8
  %348 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23
  %349 = load ptr, ptr %348, align 8
  %350 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24
  %351 = load ptr, ptr %350, align 8
  %352 = tail call double %349(ptr noundef %351, ptr noundef %12, ptr noundef %16) #8
  %353 = fadd double %347, %352
  %354 = load ptr, ptr %344, align 8
  %355 = getelementptr inbounds double, ptr %354, i64 %14
  store double %353, ptr %355, align 8
  %356 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22
  %357 = load double, ptr %356, align 8
  %358 = sub nsw i64 1, %1
  %359 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 27, i64 %358
  %360 = load ptr, ptr %359, align 8
  %361 = load i64, ptr %0, align 8
  %362 = icmp sgt i64 %361, 0
  br i1 %362, label %363, label %375

363:                                              ; preds = %343, %363
  %364 = phi i64 [ %373, %363 ], [ 0, %343 ]
  %365 = phi double [ %372, %363 ], [ 0.000000e+00, %343 ]
  %366 = getelementptr inbounds double, ptr %360, i64 %364
  %367 = load double, ptr %366, align 8
  %368 = getelementptr inbounds double, ptr %16, i64 %364
  %369 = load double, ptr %368, align 8
  %370 = fsub double %367, %369
  %371 = fmul double %370, %370
  %372 = fadd double %365, %371
  %373 = add nuw nsw i64 %364, 1
  %374 = icmp eq i64 %373, %361
  br i1 %374, label %375, label %363

375:                                              ; preds = %363, %343
  %376 = phi double [ 0.000000e+00, %343 ], [ %372, %363 ]
  %377 = tail call double @llvm.sqrt.f64(double %376)
  %378 = fmul double %357, %377
  %379 = fadd double %353, %378
  %380 = load double, ptr %340, align 8
  %381 = fcmp olt double %379, %380
  br i1 %381, label %382, label %403

382:                                              ; preds = %375, %336
  %383 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %384 = load i64, ptr %383, align 8
  %385 = icmp eq i64 %384, 0
  br i1 %385, label %392, label %386

386:                                              ; preds = %382
  %387 = sub nsw i64 1, %1
  %388 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 29, i64 %387
  %389 = load ptr, ptr %388, align 8
  %390 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %12, ptr noundef %16, ptr noundef nonnull %7, ptr noundef %389)
  %391 = icmp eq i32 %390, 0
  br i1 %391, label %403, label %392

392:                                              ; preds = %386, %382
  %393 = tail call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef %12, ptr noundef %16)
  %394 = icmp eq i32 %393, 0
  br i1 %394, label %403, label %395

395:                                              ; preds = %392
  %396 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 28, i64 %1
  %397 = load ptr, ptr %396, align 8
  %398 = getelementptr inbounds i64, ptr %397, i64 %14
  store i64 %2, ptr %398, align 8
  %399 = load ptr, ptr %337, align 8
  %400 = getelementptr inbounds %struct.Side, ptr %399, i64 %14
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %400, ptr noundef nonnull align 8 dereferenceable(16) %7, i64 16, i1 false)
  %401 = load i64, ptr %13, align 8
  %402 = add nsw i64 %401, 1
  store i64 %402, ptr %13, align 8
  br label %403

403:                                              ; preds = %392, %386, %375, %395
  %404 = phi i64 [ %14, %395 ], [ -1, %375 ], [ -1, %386 ], [ -1, %392 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  br label %406

405:                                              ; preds = %87, %97, %103, %311
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #8
  br label %406

406:                                              ; preds = %405, %329, %403
  %407 = phi i64 [ %404, %403 ], [ -1, %329 ], [ -1, %405 ]
  ret i64 %407
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


