; connect.c 0f21ea27dbd4b8ee95c21e1531517912f490058f19aab1bc69bf815cf49599ee: written by make kernel

%struct.Side = type { i8, i8, i64 }
%struct.Search = type { i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, double, double, [2 x double], double, double, double, i64, ptr, ptr, i64, i64, i64, [2 x ptr], [2 x ptr], [2 x ptr], [2 x i64], [2 x i64], i64, i64 }

define dso_local i32 @manipplan_state(ptr nocapture noundef %0, ptr noundef %1) local_unnamed_addr #0 {
  %3 = alloca %struct.Side, align 8
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %3) #8
  %4 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22
  %5 = load ptr, ptr %4, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %3, ptr noundef nonnull align 8 dereferenceable(16) %5, i64 16, i1 false)
  %6 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %7 = load i64, ptr %6, align 8
  %8 = icmp eq i64 %7, 0
  br i1 %8, label %18, label %9

9:                                                ; preds = %2
  %10 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22, i64 1
  %11 = load ptr, ptr %10, align 8
  %12 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %1, ptr noundef %1, ptr noundef nonnull %3, ptr noundef %11)
  %13 = icmp eq i32 %12, 0
  br i1 %13, label %14, label %18

14:                                               ; preds = %9
  %15 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26
  %16 = load i64, ptr %15, align 8
  %17 = add nsw i64 %16, 1
  store i64 %17, ptr %15, align 8
  br label %78

18:                                               ; preds = %9, %2
  %19 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  %20 = load double, ptr %19, align 8
  %21 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  br label %35

22:                                               ; preds = %66
  %23 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26
  %24 = load i64, ptr %23, align 8
  %25 = add nsw i64 %24, 1
  store i64 %25, ptr %23, align 8
  %26 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %27 = load ptr, ptr %26, align 8
  %28 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %29 = load ptr, ptr %28, align 8
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %31 = load double, ptr %30, align 8
  %32 = fadd double %67, %31
  %33 = tail call i32 %27(ptr noundef %29, ptr noundef %1, double noundef %32) #8
  %34 = icmp eq i32 %33, 2
  br i1 %34, label %68, label %74

35:                                               ; preds = %66, %18
  %36 = phi i1 [ true, %18 ], [ false, %66 ]
  %37 = phi i64 [ 0, %18 ], [ 1, %66 ]
  %38 = phi double [ %20, %18 ], [ %67, %66 ]
  %39 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10, i64 %37
  %40 = load double, ptr %39, align 8
  %41 = fcmp ogt double %38, %40
  br i1 %41, label %42, label %66

42:                                               ; preds = %35
  %43 = load double, ptr %21, align 8
  %44 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20, i64 %37
  %45 = load ptr, ptr %44, align 8
  %46 = load i64, ptr %0, align 8
  %47 = icmp sgt i64 %46, 0
  br i1 %47, label %48, label %60

48:                                               ; preds = %42, %48
  %49 = phi i64 [ %58, %48 ], [ 0, %42 ]
  %50 = phi double [ %57, %48 ], [ 0.000000e+00, %42 ]
  %51 = getelementptr inbounds double, ptr %45, i64 %49
  %52 = load double, ptr %51, align 8
  %53 = getelementptr inbounds double, ptr %1, i64 %49
  %54 = load double, ptr %53, align 8
  %55 = fsub double %52, %54
  %56 = fmul double %55, %55
  %57 = fadd double %50, %56
  %58 = add nuw nsw i64 %49, 1
  %59 = icmp eq i64 %58, %46
  br i1 %59, label %60, label %48

60:                                               ; preds = %48, %42
  %61 = phi double [ 0.000000e+00, %42 ], [ %57, %48 ]
  %62 = tail call double @llvm.sqrt.f64(double %61)
  %63 = fmul double %43, %62
  %64 = fadd double %40, %63
  %65 = tail call double @llvm.minnum.f64(double %38, double %64)
  br label %66

66:                                               ; preds = %60, %35
  %67 = phi double [ %65, %60 ], [ %38, %35 ]
  br i1 %36, label %35, label %22

68:                                               ; preds = %22
  %69 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %70 = load ptr, ptr %69, align 8
  %71 = load double, ptr %30, align 8
  %72 = fadd double %67, %71
  %73 = tail call i32 %70(ptr noundef %1, double noundef %72) #8
  br label %74

74:                                               ; preds = %22, %68
  %75 = phi i32 [ %73, %68 ], [ %33, %22 ]
  %76 = icmp eq i32 %75, 0
  %77 = zext i1 %76 to i32
  br label %78

78:                                               ; preds = %74, %14
  %79 = phi i32 [ %77, %74 ], [ 0, %14 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %3) #8
  ret i32 %79
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
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 12
  %25 = load double, ptr %24, align 8
  %26 = fdiv double %23, %25
  %27 = tail call double @llvm.ceil.f64(double %26)
  %28 = fptosi double %27 to i64
  %29 = tail call i64 @llvm.smax.i64(i64 %28, i64 1)
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 15
  %31 = add nuw nsw i64 %29, 1
  %32 = sitofp i64 %29 to double
  %33 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %34 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 16
  %35 = getelementptr inbounds %struct.Side, ptr %3, i64 0, i32 1
  %36 = getelementptr inbounds %struct.Side, ptr %3, i64 0, i32 2
  %37 = getelementptr inbounds %struct.Side, ptr %4, i64 0, i32 1
  %38 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  br label %43

39:                                               ; preds = %110
  %40 = add nuw nsw i64 %45, 64
  %41 = icmp ugt i64 %40, %29
  %42 = add nsw i64 %44, -64
  br i1 %41, label %154, label %43

43:                                               ; preds = %22, %39
  %44 = phi i64 [ %29, %22 ], [ %42, %39 ]
  %45 = phi i64 [ 1, %22 ], [ %40, %39 ]
  %46 = call i64 @llvm.smin.i64(i64 %44, i64 64)
  %47 = call i64 @llvm.smax.i64(i64 %46, i64 1)
  %48 = sub nsw i64 %31, %45
  %49 = call i64 @llvm.smin.i64(i64 %48, i64 64)
  %50 = icmp sgt i64 %48, 0
  br i1 %50, label %51, label %58

51:                                               ; preds = %43
  %52 = load i64, ptr %0, align 8
  %53 = icmp sgt i64 %52, 0
  br label %66

54:                                               ; preds = %85
  %55 = load ptr, ptr %30, align 8
  %56 = call i32 %55(ptr noundef nonnull %6, ptr noundef nonnull %7, i64 noundef %49) #8
  %57 = icmp eq i32 %56, 0
  br i1 %57, label %62, label %154

58:                                               ; preds = %43
  %59 = load ptr, ptr %30, align 8
  %60 = call i32 %59(ptr noundef nonnull %6, ptr noundef nonnull %7, i64 noundef %49) #8
  %61 = icmp eq i32 %60, 0
  br i1 %61, label %93, label %154

62:                                               ; preds = %54
  br i1 %50, label %63, label %93

63:                                               ; preds = %62
  %64 = load i64, ptr %33, align 8
  %65 = icmp sgt i64 %64, 0
  br label %88

66:                                               ; preds = %51, %85
  %67 = phi i64 [ 0, %51 ], [ %86, %85 ]
  %68 = add nuw nsw i64 %67, %45
  %69 = sitofp i64 %68 to double
  %70 = fdiv double %69, %32
  %71 = mul nsw i64 %52, %67
  %72 = getelementptr inbounds double, ptr %6, i64 %71
  br i1 %53, label %73, label %85

73:                                               ; preds = %66, %73
  %74 = phi i64 [ %83, %73 ], [ 0, %66 ]
  %75 = getelementptr inbounds double, ptr %1, i64 %74
  %76 = load double, ptr %75, align 8
  %77 = getelementptr inbounds double, ptr %2, i64 %74
  %78 = load double, ptr %77, align 8
  %79 = fsub double %78, %76
  %80 = fmul double %70, %79
  %81 = fadd double %76, %80
  %82 = getelementptr inbounds double, ptr %72, i64 %74
  store double %81, ptr %82, align 8
  %83 = add nuw nsw i64 %74, 1
  %84 = icmp eq i64 %83, %52
  br i1 %84, label %85, label %73

85:                                               ; preds = %73, %66
  %86 = add nuw nsw i64 %67, 1
  %87 = icmp eq i64 %86, %47
  br i1 %87, label %54, label %66

88:                                               ; preds = %63, %116
  %89 = phi i64 [ 0, %63 ], [ %117, %116 ]
  br i1 %65, label %90, label %116

90:                                               ; preds = %88
  %91 = mul nsw i64 %64, %89
  %92 = load ptr, ptr %34, align 8
  br label %119

93:                                               ; preds = %116, %58, %62
  %94 = load i64, ptr %36, align 8
  %95 = load i8, ptr %3, align 8
  %96 = load i8, ptr %4, align 8
  %97 = xor i8 %96, %95
  %98 = load i8, ptr %35, align 1
  %99 = and i8 %97, %98
  %100 = load i8, ptr %37, align 1
  %101 = and i8 %99, %100
  %102 = icmp eq i8 %101, 0
  br i1 %102, label %110, label %103

103:                                              ; preds = %93, %103
  %104 = phi i32 [ %106, %103 ], [ 0, %93 ]
  %105 = phi i8 [ %108, %103 ], [ %101, %93 ]
  %106 = add nuw nsw i32 %104, 1
  %107 = add i8 %105, -1
  %108 = and i8 %107, %105
  %109 = icmp eq i8 %108, 0
  br i1 %109, label %110, label %103

110:                                              ; preds = %103, %93
  %111 = phi i32 [ 0, %93 ], [ %106, %103 ]
  %112 = sext i32 %111 to i64
  %113 = add nsw i64 %94, %112
  %114 = load i64, ptr %38, align 8
  %115 = icmp sgt i64 %113, %114
  br i1 %115, label %154, label %39

116:                                              ; preds = %151, %88
  %117 = add nuw nsw i64 %89, 1
  %118 = icmp eq i64 %117, %47
  br i1 %118, label %93, label %88

119:                                              ; preds = %90, %151
  %120 = phi i64 [ 0, %90 ], [ %152, %151 ]
  %121 = add nsw i64 %91, %120
  %122 = getelementptr inbounds [512 x double], ptr %7, i64 0, i64 %121
  %123 = load double, ptr %122, align 8
  %124 = call double @llvm.fabs.f64(double %123)
  %125 = getelementptr inbounds double, ptr %92, i64 %120
  %126 = load double, ptr %125, align 8
  %127 = fcmp olt double %124, %126
  br i1 %127, label %151, label %128

128:                                              ; preds = %119
  %129 = fcmp oge double %123, 0.000000e+00
  %130 = trunc i64 %120 to i32
  %131 = shl nuw i32 1, %130
  %132 = trunc i32 %131 to i8
  %133 = select i1 %129, i8 %132, i8 0
  %134 = load i8, ptr %35, align 1
  %135 = zext i8 %134 to i32
  %136 = and i32 %131, %135
  %137 = icmp ne i32 %136, 0
  %138 = load i8, ptr %3, align 8
  %139 = zext i8 %138 to i32
  %140 = and i32 %131, %139
  %141 = zext i8 %133 to i32
  %142 = icmp ne i32 %140, %141
  %143 = select i1 %137, i1 %142, i1 false
  %144 = zext i1 %143 to i64
  %145 = load i64, ptr %36, align 8
  %146 = add nsw i64 %145, %144
  store i64 %146, ptr %36, align 8
  %147 = xor i8 %132, -1
  %148 = and i8 %138, %147
  %149 = or i8 %148, %133
  store i8 %149, ptr %3, align 8
  %150 = or i8 %134, %132
  store i8 %150, ptr %35, align 1
  br label %151

151:                                              ; preds = %119, %128
  %152 = add nuw nsw i64 %120, 1
  %153 = icmp eq i64 %152, %64
  br i1 %153, label %116, label %119

154:                                              ; preds = %58, %54, %39, %110
  %155 = phi i32 [ 0, %54 ], [ 1, %39 ], [ 0, %110 ], [ 0, %58 ]
  call void @llvm.lifetime.end.p0(i64 4096, ptr nonnull %7) #8
  call void @llvm.lifetime.end.p0(i64 32768, ptr nonnull %6) #8
  ret i32 %155
}

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

define dso_local i32 @manipplan_motion(ptr nocapture noundef %0, ptr nocapture noundef readonly %1, ptr noundef %2) local_unnamed_addr #0 {
  %4 = alloca %struct.Side, align 8
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %4) #8
  %5 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22
  %6 = load ptr, ptr %5, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %4, ptr noundef nonnull align 8 dereferenceable(16) %6, i64 16, i1 false)
  %7 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %8 = load i64, ptr %7, align 8
  %9 = icmp eq i64 %8, 0
  br i1 %9, label %19, label %10

10:                                               ; preds = %3
  %11 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22, i64 1
  %12 = load ptr, ptr %11, align 8
  %13 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %1, ptr noundef %2, ptr noundef nonnull %4, ptr noundef %12)
  %14 = icmp eq i32 %13, 0
  br i1 %14, label %15, label %19

15:                                               ; preds = %10
  %16 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26
  %17 = load i64, ptr %16, align 8
  %18 = add nsw i64 %17, 1
  store i64 %18, ptr %16, align 8
  br label %21

19:                                               ; preds = %10, %3
  %20 = tail call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef %1, ptr noundef %2)
  br label %21

21:                                               ; preds = %19, %15
  %22 = phi i32 [ %20, %19 ], [ 0, %15 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %4) #8
  ret i32 %22
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
  %21 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 12
  %22 = load double, ptr %21, align 8
  %23 = fdiv double %20, %22
  %24 = tail call double @llvm.ceil.f64(double %23)
  %25 = fptosi double %24 to i64
  %26 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  %27 = load double, ptr %26, align 8
  %28 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  br label %43

29:                                               ; preds = %72
  %30 = tail call i64 @llvm.smax.i64(i64 %25, i64 1)
  %31 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26
  %32 = load i64, ptr %31, align 8
  %33 = add nsw i64 %32, 1
  store i64 %33, ptr %31, align 8
  %34 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %35 = load ptr, ptr %34, align 8
  %36 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %37 = load ptr, ptr %36, align 8
  %38 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %39 = load double, ptr %38, align 8
  %40 = fadd double %73, %39
  %41 = tail call i32 %35(ptr noundef %37, ptr noundef %2, double noundef %40) #8
  %42 = icmp eq i32 %41, 2
  br i1 %42, label %74, label %80

43:                                               ; preds = %72, %19
  %44 = phi i1 [ true, %19 ], [ false, %72 ]
  %45 = phi i64 [ 0, %19 ], [ 1, %72 ]
  %46 = phi double [ %27, %19 ], [ %73, %72 ]
  %47 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10, i64 %45
  %48 = load double, ptr %47, align 8
  %49 = fcmp ogt double %46, %48
  br i1 %49, label %50, label %72

50:                                               ; preds = %43
  %51 = load double, ptr %28, align 8
  %52 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20, i64 %45
  %53 = load ptr, ptr %52, align 8
  br i1 %6, label %54, label %66

54:                                               ; preds = %50, %54
  %55 = phi i64 [ %64, %54 ], [ 0, %50 ]
  %56 = phi double [ %63, %54 ], [ 0.000000e+00, %50 ]
  %57 = getelementptr inbounds double, ptr %53, i64 %55
  %58 = load double, ptr %57, align 8
  %59 = getelementptr inbounds double, ptr %2, i64 %55
  %60 = load double, ptr %59, align 8
  %61 = fsub double %58, %60
  %62 = fmul double %61, %61
  %63 = fadd double %56, %62
  %64 = add nuw nsw i64 %55, 1
  %65 = icmp eq i64 %64, %5
  br i1 %65, label %66, label %54

66:                                               ; preds = %54, %50
  %67 = phi double [ 0.000000e+00, %50 ], [ %63, %54 ]
  %68 = tail call double @llvm.sqrt.f64(double %67)
  %69 = fmul double %51, %68
  %70 = fadd double %48, %69
  %71 = tail call double @llvm.minnum.f64(double %46, double %70)
  br label %72

72:                                               ; preds = %66, %43
  %73 = phi double [ %71, %66 ], [ %46, %43 ]
  br i1 %44, label %43, label %29

74:                                               ; preds = %29
  %75 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %76 = load ptr, ptr %75, align 8
  %77 = load double, ptr %38, align 8
  %78 = fadd double %73, %77
  %79 = tail call i32 %76(ptr noundef %2, double noundef %78) #8
  br label %80

80:                                               ; preds = %29, %74
  %81 = phi i32 [ %79, %74 ], [ %41, %29 ]
  %82 = icmp eq i32 %81, 0
  br i1 %82, label %83, label %173

83:                                               ; preds = %80, %83
  %84 = phi i64 [ %85, %83 ], [ 1, %80 ]
  %85 = shl nsw i64 %84, 1
  %86 = icmp slt i64 %85, %30
  br i1 %86, label %83, label %87

87:                                               ; preds = %83
  %88 = icmp ugt i64 %30, 1
  %89 = icmp sgt i64 %84, 0
  %90 = select i1 %89, i1 %88, i1 false
  br i1 %90, label %91, label %173

91:                                               ; preds = %87
  %92 = sitofp i64 %30 to double
  %93 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  br label %94

94:                                               ; preds = %91, %170
  %95 = phi i64 [ %84, %91 ], [ %171, %170 ]
  %96 = icmp slt i64 %95, %30
  br i1 %96, label %97, label %170

97:                                               ; preds = %94
  %98 = shl nuw nsw i64 %95, 1
  br label %99

99:                                               ; preds = %97, %167
  %100 = phi i64 [ %95, %97 ], [ %168, %167 ]
  %101 = sitofp i64 %100 to double
  %102 = fdiv double %101, %92
  %103 = load i64, ptr %0, align 8
  %104 = icmp sgt i64 %103, 0
  br i1 %104, label %105, label %117

105:                                              ; preds = %99, %105
  %106 = phi i64 [ %115, %105 ], [ 0, %99 ]
  %107 = getelementptr inbounds double, ptr %1, i64 %106
  %108 = load double, ptr %107, align 8
  %109 = getelementptr inbounds double, ptr %2, i64 %106
  %110 = load double, ptr %109, align 8
  %111 = fsub double %110, %108
  %112 = fmul double %102, %111
  %113 = fadd double %108, %112
  %114 = getelementptr inbounds double, ptr %4, i64 %106
  store double %113, ptr %114, align 8
  %115 = add nuw nsw i64 %106, 1
  %116 = icmp eq i64 %115, %103
  br i1 %116, label %117, label %105

117:                                              ; preds = %105, %99
  %118 = load double, ptr %26, align 8
  br label %128

119:                                              ; preds = %157
  %120 = load i64, ptr %31, align 8
  %121 = add nsw i64 %120, 1
  store i64 %121, ptr %31, align 8
  %122 = load ptr, ptr %34, align 8
  %123 = load ptr, ptr %36, align 8
  %124 = load double, ptr %38, align 8
  %125 = fadd double %158, %124
  %126 = call i32 %122(ptr noundef %123, ptr noundef nonnull %4, double noundef %125) #8
  %127 = icmp eq i32 %126, 2
  br i1 %127, label %159, label %164

128:                                              ; preds = %157, %117
  %129 = phi i1 [ true, %117 ], [ false, %157 ]
  %130 = phi i64 [ 0, %117 ], [ 1, %157 ]
  %131 = phi double [ %118, %117 ], [ %158, %157 ]
  %132 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10, i64 %130
  %133 = load double, ptr %132, align 8
  %134 = fcmp ogt double %131, %133
  br i1 %134, label %135, label %157

135:                                              ; preds = %128
  %136 = load double, ptr %28, align 8
  %137 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20, i64 %130
  %138 = load ptr, ptr %137, align 8
  br i1 %104, label %139, label %151

139:                                              ; preds = %135, %139
  %140 = phi i64 [ %149, %139 ], [ 0, %135 ]
  %141 = phi double [ %148, %139 ], [ 0.000000e+00, %135 ]
  %142 = getelementptr inbounds double, ptr %138, i64 %140
  %143 = load double, ptr %142, align 8
  %144 = getelementptr inbounds double, ptr %4, i64 %140
  %145 = load double, ptr %144, align 8
  %146 = fsub double %143, %145
  %147 = fmul double %146, %146
  %148 = fadd double %141, %147
  %149 = add nuw nsw i64 %140, 1
  %150 = icmp eq i64 %149, %103
  br i1 %150, label %151, label %139

151:                                              ; preds = %139, %135
  %152 = phi double [ 0.000000e+00, %135 ], [ %148, %139 ]
  %153 = call double @llvm.sqrt.f64(double %152)
  %154 = fmul double %136, %153
  %155 = fadd double %133, %154
  %156 = call double @llvm.minnum.f64(double %131, double %155)
  br label %157

157:                                              ; preds = %151, %128
  %158 = phi double [ %156, %151 ], [ %131, %128 ]
  br i1 %129, label %128, label %119

159:                                              ; preds = %119
  %160 = load ptr, ptr %93, align 8
  %161 = load double, ptr %38, align 8
  %162 = fadd double %158, %161
  %163 = call i32 %160(ptr noundef nonnull %4, double noundef %162) #8
  br label %164

164:                                              ; preds = %119, %159
  %165 = phi i32 [ %163, %159 ], [ %126, %119 ]
  %166 = icmp eq i32 %165, 0
  br i1 %166, label %167, label %173

167:                                              ; preds = %164
  %168 = add nsw i64 %100, %98
  %169 = icmp slt i64 %168, %30
  br i1 %169, label %99, label %170

170:                                              ; preds = %167, %94
  %171 = lshr i64 %95, 1
  %172 = icmp ugt i64 %95, 1
  br i1 %172, label %94, label %173

173:                                              ; preds = %170, %164, %87, %80
  %174 = phi i32 [ 0, %80 ], [ 1, %87 ], [ 0, %164 ], [ 1, %170 ]
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %4) #8
  ret i32 %174
}

define dso_local i32 @manipplan_connect(ptr nocapture noundef %0, i64 noundef %1) local_unnamed_addr #0 {
  %3 = alloca [64 x double], align 16
  %4 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26
  %5 = load i64, ptr %4, align 8
  %6 = add nsw i64 %5, %1
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %8, label %221

8:                                                ; preds = %2
  %9 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 25
  %10 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 18
  %11 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 3
  %12 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 1
  %13 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 4
  %14 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 2
  %15 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23
  %16 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 19
  %17 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %18 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 17
  %19 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 1
  br label %20

20:                                               ; preds = %8, %218
  %21 = phi i64 [ %5, %8 ], [ %219, %218 ]
  %22 = load i64, ptr %9, align 8
  %23 = sub nsw i64 1, %22
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %3) #8
  %24 = load i64, ptr %10, align 8
  %25 = add i64 %24, -7046029254386353131
  store i64 %25, ptr %10, align 8
  %26 = lshr i64 %25, 30
  %27 = xor i64 %26, %25
  %28 = mul i64 %27, -4658895280553007687
  %29 = lshr i64 %28, 27
  %30 = xor i64 %29, %28
  %31 = mul i64 %30, -7723592293110705685
  %32 = lshr i64 %31, 42
  %33 = lshr i64 %31, 11
  %34 = xor i64 %32, %33
  %35 = uitofp i64 %34 to double
  %36 = fmul double %35, 0x3CA0000000000000
  %37 = fcmp olt double %36, 5.000000e-01
  %38 = select i1 %37, ptr %11, ptr %12
  %39 = load ptr, ptr %38, align 8
  %40 = select i1 %37, ptr %13, ptr %14
  %41 = load ptr, ptr %40, align 8
  %42 = load i64, ptr %0, align 8
  %43 = icmp sgt i64 %42, 0
  br i1 %43, label %51, label %45

44:                                               ; preds = %51
  store i64 %56, ptr %10, align 8
  br label %45

45:                                               ; preds = %44, %20
  %46 = add nsw i64 %21, 1
  store i64 %46, ptr %4, align 8
  %47 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %22
  %48 = load i64, ptr %47, align 8
  %49 = load i64, ptr %16, align 8
  %50 = icmp slt i64 %48, %49
  br i1 %50, label %76, label %216

51:                                               ; preds = %20, %51
  %52 = phi i64 [ %56, %51 ], [ %25, %20 ]
  %53 = phi i64 [ %74, %51 ], [ 0, %20 ]
  %54 = getelementptr inbounds double, ptr %39, i64 %53
  %55 = load double, ptr %54, align 8
  %56 = add i64 %52, -7046029254386353131
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
  %68 = getelementptr inbounds double, ptr %41, i64 %53
  %69 = load double, ptr %68, align 8
  %70 = fsub double %69, %55
  %71 = fmul double %70, %67
  %72 = fadd double %55, %71
  %73 = getelementptr inbounds [64 x double], ptr %3, i64 0, i64 %53
  store double %72, ptr %73, align 8
  %74 = add nuw nsw i64 %53, 1
  %75 = icmp eq i64 %74, %42
  br i1 %75, label %44, label %51

76:                                               ; preds = %45
  %77 = icmp sgt i64 %48, 0
  br i1 %77, label %78, label %106

78:                                               ; preds = %76
  %79 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20, i64 %22
  %80 = load ptr, ptr %79, align 8
  br label %81

81:                                               ; preds = %87, %78
  %82 = phi i64 [ 0, %78 ], [ %91, %87 ]
  %83 = phi i64 [ 0, %78 ], [ %92, %87 ]
  %84 = phi double [ 0x7FF0000000000000, %78 ], [ %90, %87 ]
  %85 = mul nsw i64 %83, %42
  %86 = getelementptr inbounds double, ptr %80, i64 %85
  br i1 %43, label %94, label %87

87:                                               ; preds = %94, %81
  %88 = phi double [ 0.000000e+00, %81 ], [ %103, %94 ]
  %89 = fcmp olt double %88, %84
  %90 = select i1 %89, double %88, double %84
  %91 = select i1 %89, i64 %83, i64 %82
  %92 = add nuw nsw i64 %83, 1
  %93 = icmp eq i64 %92, %48
  br i1 %93, label %106, label %81

94:                                               ; preds = %81, %94
  %95 = phi i64 [ %104, %94 ], [ 0, %81 ]
  %96 = phi double [ %103, %94 ], [ 0.000000e+00, %81 ]
  %97 = getelementptr inbounds double, ptr %3, i64 %95
  %98 = load double, ptr %97, align 8
  %99 = getelementptr inbounds double, ptr %86, i64 %95
  %100 = load double, ptr %99, align 8
  %101 = fsub double %98, %100
  %102 = fmul double %101, %101
  %103 = fadd double %96, %102
  %104 = add nuw nsw i64 %95, 1
  %105 = icmp eq i64 %104, %42
  br i1 %105, label %87, label %94

106:                                              ; preds = %87, %76
  %107 = phi i64 [ 0, %76 ], [ %91, %87 ]
  %108 = call fastcc i64 @extend(ptr noundef nonnull %0, i64 noundef %22, i64 noundef %107, ptr noundef nonnull %3)
  %109 = icmp slt i64 %108, 0
  br i1 %109, label %218, label %110

110:                                              ; preds = %106
  %111 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20, i64 %22
  %112 = load ptr, ptr %111, align 8
  %113 = load i64, ptr %0, align 8
  %114 = mul nsw i64 %113, %108
  %115 = getelementptr inbounds double, ptr %112, i64 %114
  %116 = shl i64 %113, 3
  call void @llvm.memcpy.p0.p0.i64(ptr nonnull align 16 %3, ptr align 8 %115, i64 %116, i1 false)
  %117 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %23
  %118 = load i64, ptr %117, align 8
  %119 = icmp sgt i64 %118, 0
  br i1 %119, label %120, label %151

120:                                              ; preds = %110
  %121 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20, i64 %23
  %122 = load ptr, ptr %121, align 8
  %123 = icmp sgt i64 %113, 0
  br label %124

124:                                              ; preds = %130, %120
  %125 = phi i64 [ 0, %120 ], [ %134, %130 ]
  %126 = phi i64 [ 0, %120 ], [ %135, %130 ]
  %127 = phi double [ 0x7FF0000000000000, %120 ], [ %133, %130 ]
  %128 = mul nsw i64 %126, %113
  %129 = getelementptr inbounds double, ptr %122, i64 %128
  br i1 %123, label %137, label %130

130:                                              ; preds = %137, %124
  %131 = phi double [ 0.000000e+00, %124 ], [ %146, %137 ]
  %132 = fcmp olt double %131, %127
  %133 = select i1 %132, double %131, double %127
  %134 = select i1 %132, i64 %126, i64 %125
  %135 = add nuw nsw i64 %126, 1
  %136 = icmp eq i64 %135, %118
  br i1 %136, label %149, label %124

137:                                              ; preds = %124, %137
  %138 = phi i64 [ %147, %137 ], [ 0, %124 ]
  %139 = phi double [ %146, %137 ], [ 0.000000e+00, %124 ]
  %140 = getelementptr inbounds double, ptr %3, i64 %138
  %141 = load double, ptr %140, align 8
  %142 = getelementptr inbounds double, ptr %129, i64 %138
  %143 = load double, ptr %142, align 8
  %144 = fsub double %141, %143
  %145 = fmul double %144, %144
  %146 = fadd double %139, %145
  %147 = add nuw nsw i64 %138, 1
  %148 = icmp eq i64 %147, %113
  br i1 %148, label %130, label %137

149:                                              ; preds = %130
  %150 = icmp sgt i64 %134, -1
  br i1 %150, label %151, label %211

151:                                              ; preds = %110, %149
  %152 = phi i64 [ %134, %149 ], [ 0, %110 ]
  %153 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20, i64 %23
  br label %154

154:                                              ; preds = %151, %208
  %155 = phi i64 [ %152, %151 ], [ %209, %208 ]
  %156 = load ptr, ptr %153, align 8
  %157 = load i64, ptr %0, align 8
  %158 = mul nsw i64 %157, %155
  %159 = getelementptr inbounds double, ptr %156, i64 %158
  %160 = shl i64 %157, 3
  %161 = call i32 @bcmp(ptr %159, ptr nonnull %3, i64 %160)
  %162 = icmp eq i32 %161, 0
  br i1 %162, label %163, label %204

163:                                              ; preds = %154
  %164 = load i64, ptr %17, align 8
  %165 = icmp eq i64 %164, 0
  br i1 %165, label %201, label %166

166:                                              ; preds = %163
  %167 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22, i64 %23
  %168 = load ptr, ptr %167, align 8
  %169 = getelementptr inbounds %struct.Side, ptr %168, i64 %155
  %170 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22, i64 %22
  %171 = load ptr, ptr %170, align 8
  %172 = getelementptr inbounds %struct.Side, ptr %171, i64 %108
  %173 = getelementptr inbounds %struct.Side, ptr %171, i64 %108, i32 2
  %174 = load i64, ptr %173, align 8
  %175 = getelementptr inbounds %struct.Side, ptr %168, i64 %155, i32 2
  %176 = load i64, ptr %175, align 8
  %177 = add nsw i64 %176, %174
  %178 = load i8, ptr %172, align 8
  %179 = load i8, ptr %169, align 8
  %180 = xor i8 %179, %178
  %181 = getelementptr inbounds %struct.Side, ptr %171, i64 %108, i32 1
  %182 = load i8, ptr %181, align 1
  %183 = and i8 %180, %182
  %184 = getelementptr inbounds %struct.Side, ptr %168, i64 %155, i32 1
  %185 = load i8, ptr %184, align 1
  %186 = and i8 %183, %185
  %187 = icmp eq i8 %186, 0
  br i1 %187, label %195, label %188

188:                                              ; preds = %166, %188
  %189 = phi i32 [ %191, %188 ], [ 0, %166 ]
  %190 = phi i8 [ %193, %188 ], [ %186, %166 ]
  %191 = add nuw nsw i32 %189, 1
  %192 = add i8 %190, -1
  %193 = and i8 %192, %190
  %194 = icmp eq i8 %193, 0
  br i1 %194, label %195, label %188

195:                                              ; preds = %188, %166
  %196 = phi i32 [ 0, %166 ], [ %191, %188 ]
  %197 = sext i32 %196 to i64
  %198 = add nsw i64 %177, %197
  %199 = load i64, ptr %18, align 8
  %200 = icmp sgt i64 %198, %199
  br i1 %200, label %211, label %201

201:                                              ; preds = %195, %163
  %202 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24, i64 %22
  store i64 %108, ptr %202, align 8
  %203 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24, i64 %23
  store i64 %155, ptr %203, align 8
  br label %216

204:                                              ; preds = %154
  %205 = load i64, ptr %117, align 8
  %206 = load i64, ptr %16, align 8
  %207 = icmp slt i64 %205, %206
  br i1 %207, label %208, label %216

208:                                              ; preds = %204
  %209 = call fastcc i64 @extend(ptr noundef nonnull %0, i64 noundef %23, i64 noundef %155, ptr noundef nonnull %3)
  %210 = icmp sgt i64 %209, -1
  br i1 %210, label %154, label %211

211:                                              ; preds = %208, %149, %195
  %212 = load i64, ptr %15, align 8
  %213 = load i64, ptr %19, align 8
  %214 = icmp sgt i64 %212, %213
  %215 = zext i1 %214 to i64
  store i64 %215, ptr %9, align 8
  br label %218

216:                                              ; preds = %45, %204, %201
  %217 = phi i32 [ 1, %201 ], [ 2, %204 ], [ 2, %45 ]
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %3) #8
  br label %221

218:                                              ; preds = %211, %106
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %3) #8
  %219 = load i64, ptr %4, align 8
  %220 = icmp slt i64 %219, %6
  br i1 %220, label %20, label %221

221:                                              ; preds = %218, %2, %216
  %222 = phi i32 [ %217, %216 ], [ 0, %2 ], [ 0, %218 ]
  ret i32 %222
}

define internal fastcc i64 @extend(ptr nocapture noundef %0, i64 noundef %1, i64 noundef %2, ptr nocapture noundef readonly %3) unnamed_addr #0 {
  %5 = alloca %struct.Side, align 8
  %6 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20, i64 %1
  %7 = load ptr, ptr %6, align 8
  %8 = load i64, ptr %0, align 8
  %9 = mul nsw i64 %8, %2
  %10 = getelementptr inbounds double, ptr %7, i64 %9
  %11 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 23, i64 %1
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
  %30 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 13
  %31 = load double, ptr %30, align 8
  %32 = fcmp ogt double %29, %31
  br i1 %32, label %37, label %51

33:                                               ; preds = %4
  %34 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 13
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
  %54 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22, i64 %1
  %55 = load ptr, ptr %54, align 8
  %56 = getelementptr inbounds %struct.Side, ptr %55, i64 %2
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %5, ptr noundef nonnull align 8 dereferenceable(16) %56, i64 16, i1 false)
  %57 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %58 = load i64, ptr %57, align 8
  %59 = icmp eq i64 %58, 0
  br i1 %59, label %66, label %60

60:                                               ; preds = %53
  %61 = sub nsw i64 1, %1
  %62 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22, i64 %61
  %63 = load ptr, ptr %62, align 8
  %64 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %10, ptr noundef %14, ptr noundef nonnull %5, ptr noundef %63)
  %65 = icmp eq i32 %64, 0
  br i1 %65, label %77, label %66

66:                                               ; preds = %60, %53
  %67 = tail call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef %10, ptr noundef %14)
  %68 = icmp eq i32 %67, 0
  br i1 %68, label %77, label %69

69:                                               ; preds = %66
  %70 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21, i64 %1
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
  %13 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24, i64 %11
  %14 = load i64, ptr %13, align 8
  %15 = icmp sgt i64 %14, -1
  br i1 %15, label %16, label %20

16:                                               ; preds = %9
  %17 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21, i64 %11
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
  %29 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24
  %30 = load i64, ptr %29, align 8
  %31 = icmp sgt i64 %30, -1
  br i1 %31, label %32, label %35

32:                                               ; preds = %28
  %33 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20
  %34 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21
  br label %45

35:                                               ; preds = %45, %28
  %36 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 21, i64 1
  %37 = load ptr, ptr %36, align 8
  %38 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 24, i64 1
  %39 = load i64, ptr %38, align 8
  %40 = getelementptr inbounds i64, ptr %37, i64 %39
  %41 = load i64, ptr %40, align 8
  %42 = icmp sgt i64 %41, -1
  br i1 %42, label %43, label %75

43:                                               ; preds = %35
  %44 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20, i64 1
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
  %6 = load i64, ptr %0, align 8
  %7 = shl i64 %6, 3
  %8 = icmp sgt i64 %3, 2
  br i1 %8, label %9, label %21

9:                                                ; preds = %4
  %10 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22
  %11 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %12 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22, i64 1
  br label %13

13:                                               ; preds = %9, %70
  %14 = phi i64 [ 0, %9 ], [ %16, %70 ]
  %15 = phi i64 [ %3, %9 ], [ %71, %70 ]
  %16 = add nuw nsw i64 %14, 1
  %17 = add nsw i64 %15, -1
  %18 = icmp sgt i64 %17, %16
  br i1 %18, label %19, label %70

19:                                               ; preds = %13
  %20 = mul i64 %16, %7
  br label %23

21:                                               ; preds = %70, %4
  %22 = phi i64 [ %3, %4 ], [ %71, %70 ]
  ret i64 %22

23:                                               ; preds = %19, %67
  %24 = phi i64 [ %17, %19 ], [ %68, %67 ]
  %25 = load i64, ptr %0, align 8
  %26 = mul nsw i64 %25, %14
  %27 = getelementptr inbounds double, ptr %1, i64 %26
  %28 = mul nsw i64 %25, %24
  %29 = getelementptr inbounds double, ptr %1, i64 %28
  %30 = tail call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef %27, ptr noundef %29)
  %31 = icmp eq i32 %30, 0
  br i1 %31, label %67, label %32

32:                                               ; preds = %23
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %2, ptr align 8 %1, i64 %20, i1 false)
  %33 = load i64, ptr %0, align 8
  %34 = mul nsw i64 %33, %16
  %35 = getelementptr inbounds double, ptr %2, i64 %34
  %36 = mul nsw i64 %33, %24
  %37 = getelementptr inbounds double, ptr %1, i64 %36
  %38 = sub nsw i64 %15, %24
  %39 = mul i64 %38, %7
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %35, ptr align 8 %37, i64 %39, i1 false)
  %40 = add nuw nsw i64 %38, %14
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %5) #8
  %41 = load ptr, ptr %10, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %5, ptr noundef nonnull align 8 dereferenceable(16) %41, i64 16, i1 false)
  %42 = load i64, ptr %11, align 8
  %43 = icmp eq i64 %42, 0
  br i1 %43, label %44, label %45

44:                                               ; preds = %32
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %5) #8
  br label %63

45:                                               ; preds = %32
  %46 = tail call i64 @llvm.smax.i64(i64 %40, i64 0)
  br label %47

47:                                               ; preds = %51, %45
  %48 = phi i64 [ %52, %51 ], [ 0, %45 ]
  %49 = icmp eq i64 %48, %46
  br i1 %49, label %50, label %51

50:                                               ; preds = %47
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %5) #8
  br label %63

51:                                               ; preds = %47
  %52 = add nuw nsw i64 %48, 1
  %53 = load i64, ptr %0, align 8
  %54 = mul nsw i64 %53, %48
  %55 = getelementptr inbounds double, ptr %2, i64 %54
  %56 = mul nsw i64 %53, %52
  %57 = getelementptr inbounds double, ptr %2, i64 %56
  %58 = load ptr, ptr %12, align 8
  %59 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %55, ptr noundef %57, ptr noundef nonnull %5, ptr noundef %58)
  %60 = icmp eq i32 %59, 0
  br i1 %60, label %61, label %47

61:                                               ; preds = %51
  %62 = icmp slt i64 %48, %40
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %5) #8
  br i1 %62, label %67, label %63

63:                                               ; preds = %61, %50, %44
  %64 = add i64 %16, %15
  %65 = sub i64 %64, %24
  %66 = mul i64 %65, %7
  tail call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1, ptr align 8 %2, i64 %66, i1 false)
  br label %70

67:                                               ; preds = %61, %23
  %68 = add nsw i64 %24, -1
  %69 = icmp sgt i64 %68, %16
  br i1 %69, label %23, label %70

70:                                               ; preds = %67, %13, %63
  %71 = phi i64 [ %65, %63 ], [ %15, %13 ], [ %15, %67 ]
  %72 = add nuw nsw i64 %14, 3
  %73 = icmp slt i64 %72, %71
  br i1 %73, label %13, label %21
}

define dso_local i64 @manipplan_shorten(ptr nocapture noundef %0, ptr nocapture noundef %1, ptr nocapture noundef %2, i64 noundef %3, i64 noundef %4) local_unnamed_addr #0 {
  %6 = alloca %struct.Side, align 8
  %7 = alloca [2 x double], align 16
  %8 = alloca [2 x [64 x double]], align 16
  %9 = alloca [2 x i64], align 16
  %10 = load i64, ptr %0, align 8
  %11 = shl i64 %10, 3
  %12 = icmp sgt i64 %4, 0
  %13 = icmp sgt i64 %3, 2
  %14 = and i1 %12, %13
  br i1 %14, label %15, label %35

15:                                               ; preds = %5
  %16 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 18
  %17 = getelementptr inbounds double, ptr %7, i64 1
  %18 = getelementptr inbounds [2 x i64], ptr %9, i64 0, i64 1
  %19 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 9
  %20 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 11
  %21 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 26
  %22 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 6
  %23 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 5
  %24 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 8
  %25 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 7
  %26 = getelementptr inbounds [2 x [64 x double]], ptr %8, i64 0, i64 1
  %27 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22
  %28 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 14
  %29 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 22, i64 1
  br label %30

30:                                               ; preds = %262, %15
  %31 = phi i64 [ %3, %15 ], [ %263, %262 ]
  %32 = phi i64 [ 0, %15 ], [ %264, %262 ]
  %33 = load i64, ptr %0, align 8
  %34 = icmp sgt i64 %33, 0
  br label %66

35:                                               ; preds = %262, %5
  %36 = phi i64 [ %3, %5 ], [ %263, %262 ]
  ret i64 %36

37:                                               ; preds = %86
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %7) #8
  %38 = load i64, ptr %16, align 8
  %39 = add i64 %38, -7046029254386353131
  %40 = lshr i64 %39, 30
  %41 = xor i64 %40, %39
  %42 = mul i64 %41, -4658895280553007687
  %43 = lshr i64 %42, 27
  %44 = xor i64 %43, %42
  %45 = mul i64 %44, -7723592293110705685
  %46 = lshr i64 %45, 42
  %47 = lshr i64 %45, 11
  %48 = xor i64 %46, %47
  %49 = uitofp i64 %48 to double
  %50 = fmul double %49, 0x3CA0000000000000
  %51 = fmul double %89, %50
  store double %51, ptr %7, align 16
  %52 = add i64 %38, 4354685564936845354
  store i64 %52, ptr %16, align 8
  %53 = lshr i64 %52, 30
  %54 = xor i64 %53, %52
  %55 = mul i64 %54, -4658895280553007687
  %56 = lshr i64 %55, 27
  %57 = xor i64 %56, %55
  %58 = mul i64 %57, -7723592293110705685
  %59 = lshr i64 %58, 42
  %60 = lshr i64 %58, 11
  %61 = xor i64 %59, %60
  %62 = uitofp i64 %61 to double
  %63 = fmul double %62, 0x3CA0000000000000
  %64 = fmul double %89, %63
  store double %64, ptr %17, align 8
  call void @llvm.lifetime.start.p0(i64 1024, ptr nonnull %8) #8
  %65 = fcmp ogt double %51, %64
  br i1 %65, label %92, label %93

66:                                               ; preds = %30, %86
  %67 = phi i64 [ 1, %30 ], [ %90, %86 ]
  %68 = phi double [ 0.000000e+00, %30 ], [ %89, %86 ]
  %69 = phi i64 [ 0, %30 ], [ %67, %86 ]
  %70 = mul nsw i64 %33, %69
  %71 = getelementptr inbounds double, ptr %1, i64 %70
  %72 = mul nsw i64 %33, %67
  %73 = getelementptr inbounds double, ptr %1, i64 %72
  br i1 %34, label %74, label %86

74:                                               ; preds = %66, %74
  %75 = phi i64 [ %84, %74 ], [ 0, %66 ]
  %76 = phi double [ %83, %74 ], [ 0.000000e+00, %66 ]
  %77 = getelementptr inbounds double, ptr %73, i64 %75
  %78 = load double, ptr %77, align 8
  %79 = getelementptr inbounds double, ptr %71, i64 %75
  %80 = load double, ptr %79, align 8
  %81 = fsub double %78, %80
  %82 = fmul double %81, %81
  %83 = fadd double %76, %82
  %84 = add nuw nsw i64 %75, 1
  %85 = icmp eq i64 %84, %33
  br i1 %85, label %86, label %74

86:                                               ; preds = %74, %66
  %87 = phi double [ 0.000000e+00, %66 ], [ %83, %74 ]
  %88 = call double @llvm.sqrt.f64(double %87)
  %89 = fadd double %68, %88
  %90 = add nuw nsw i64 %67, 1
  %91 = icmp eq i64 %90, %31
  br i1 %91, label %37, label %66

92:                                               ; preds = %37
  store double %64, ptr %7, align 16
  store double %51, ptr %17, align 8
  br label %93

93:                                               ; preds = %37, %92
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %9) #8
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(16) %9, i8 -1, i64 16, i1 false)
  %94 = load i64, ptr %0, align 8
  %95 = icmp sgt i64 %94, 0
  br label %99

96:                                               ; preds = %125
  %97 = load i64, ptr %9, align 16
  %98 = icmp eq i64 %97, %128
  br i1 %98, label %262, label %162

99:                                               ; preds = %93, %125
  %100 = phi i64 [ 1, %93 ], [ %126, %125 ]
  %101 = phi i64 [ 0, %93 ], [ %100, %125 ]
  %102 = phi double [ 0.000000e+00, %93 ], [ %121, %125 ]
  %103 = mul nsw i64 %94, %101
  %104 = getelementptr inbounds double, ptr %1, i64 %103
  %105 = getelementptr inbounds double, ptr %104, i64 %94
  br i1 %95, label %106, label %118

106:                                              ; preds = %99, %106
  %107 = phi i64 [ %116, %106 ], [ 0, %99 ]
  %108 = phi double [ %115, %106 ], [ 0.000000e+00, %99 ]
  %109 = getelementptr inbounds double, ptr %105, i64 %107
  %110 = load double, ptr %109, align 8
  %111 = getelementptr inbounds double, ptr %104, i64 %107
  %112 = load double, ptr %111, align 8
  %113 = fsub double %110, %112
  %114 = fmul double %113, %113
  %115 = fadd double %108, %114
  %116 = add nuw nsw i64 %107, 1
  %117 = icmp eq i64 %116, %94
  br i1 %117, label %118, label %106

118:                                              ; preds = %106, %99
  %119 = phi double [ 0.000000e+00, %99 ], [ %115, %106 ]
  %120 = call double @llvm.sqrt.f64(double %119)
  %121 = fadd double %102, %120
  %122 = add nuw nsw i64 %101, 2
  %123 = icmp eq i64 %122, %31
  %124 = fcmp ogt double %120, 0.000000e+00
  br label %131

125:                                              ; preds = %161
  %126 = add nuw nsw i64 %100, 1
  %127 = icmp slt i64 %126, %31
  %128 = load i64, ptr %18, align 8
  %129 = icmp slt i64 %128, 0
  %130 = select i1 %127, i1 %129, i1 false
  br i1 %130, label %99, label %96

131:                                              ; preds = %118, %161
  %132 = phi i1 [ true, %118 ], [ false, %161 ]
  %133 = phi i64 [ 0, %118 ], [ 1, %161 ]
  %134 = getelementptr inbounds [2 x i64], ptr %9, i64 0, i64 %133
  %135 = load i64, ptr %134, align 8
  %136 = icmp slt i64 %135, 0
  br i1 %136, label %137, label %161

137:                                              ; preds = %131
  %138 = getelementptr inbounds [2 x double], ptr %7, i64 0, i64 %133
  %139 = load double, ptr %138, align 8
  %140 = fcmp olt double %139, %121
  %141 = select i1 %140, i1 true, i1 %123
  br i1 %141, label %142, label %161

142:                                              ; preds = %137
  %143 = fsub double %139, %102
  %144 = fdiv double %143, %120
  %145 = select i1 %124, double %144, double 0.000000e+00
  store i64 %101, ptr %134, align 8
  %146 = call double @llvm.maxnum.f64(double %145, double 0.000000e+00)
  %147 = call double @llvm.minnum.f64(double %146, double 1.000000e+00)
  %148 = getelementptr inbounds [2 x [64 x double]], ptr %8, i64 0, i64 %133
  br i1 %95, label %149, label %161

149:                                              ; preds = %142, %149
  %150 = phi i64 [ %159, %149 ], [ 0, %142 ]
  %151 = getelementptr inbounds double, ptr %104, i64 %150
  %152 = load double, ptr %151, align 8
  %153 = getelementptr inbounds double, ptr %105, i64 %150
  %154 = load double, ptr %153, align 8
  %155 = fsub double %154, %152
  %156 = fmul double %147, %155
  %157 = fadd double %152, %156
  %158 = getelementptr inbounds double, ptr %148, i64 %150
  store double %157, ptr %158, align 8
  %159 = add nuw nsw i64 %150, 1
  %160 = icmp eq i64 %159, %94
  br i1 %160, label %161, label %149

161:                                              ; preds = %149, %142, %137, %131
  br i1 %132, label %131, label %125

162:                                              ; preds = %96
  %163 = load double, ptr %19, align 8
  br label %173

164:                                              ; preds = %204
  %165 = load i64, ptr %21, align 8
  %166 = add nsw i64 %165, 1
  store i64 %166, ptr %21, align 8
  %167 = load ptr, ptr %22, align 8
  %168 = load ptr, ptr %23, align 8
  %169 = load double, ptr %24, align 8
  %170 = fadd double %205, %169
  %171 = call i32 %167(ptr noundef %168, ptr noundef nonnull %8, double noundef %170) #8
  %172 = icmp eq i32 %171, 2
  br i1 %172, label %206, label %211

173:                                              ; preds = %204, %162
  %174 = phi i1 [ true, %162 ], [ false, %204 ]
  %175 = phi i64 [ 0, %162 ], [ 1, %204 ]
  %176 = phi double [ %163, %162 ], [ %205, %204 ]
  %177 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 10, i64 %175
  %178 = load double, ptr %177, align 8
  %179 = fcmp ogt double %176, %178
  br i1 %179, label %180, label %204

180:                                              ; preds = %173
  %181 = load double, ptr %20, align 8
  %182 = getelementptr inbounds %struct.Search, ptr %0, i64 0, i32 20, i64 %175
  %183 = load ptr, ptr %182, align 8
  %184 = load i64, ptr %0, align 8
  %185 = icmp sgt i64 %184, 0
  br i1 %185, label %186, label %198

186:                                              ; preds = %180, %186
  %187 = phi i64 [ %196, %186 ], [ 0, %180 ]
  %188 = phi double [ %195, %186 ], [ 0.000000e+00, %180 ]
  %189 = getelementptr inbounds double, ptr %183, i64 %187
  %190 = load double, ptr %189, align 8
  %191 = getelementptr inbounds double, ptr %8, i64 %187
  %192 = load double, ptr %191, align 8
  %193 = fsub double %190, %192
  %194 = fmul double %193, %193
  %195 = fadd double %188, %194
  %196 = add nuw nsw i64 %187, 1
  %197 = icmp eq i64 %196, %184
  br i1 %197, label %198, label %186

198:                                              ; preds = %186, %180
  %199 = phi double [ 0.000000e+00, %180 ], [ %195, %186 ]
  %200 = call double @llvm.sqrt.f64(double %199)
  %201 = fmul double %181, %200
  %202 = fadd double %178, %201
  %203 = call double @llvm.minnum.f64(double %176, double %202)
  br label %204

204:                                              ; preds = %198, %173
  %205 = phi double [ %203, %198 ], [ %176, %173 ]
  br i1 %174, label %173, label %164

206:                                              ; preds = %164
  %207 = load ptr, ptr %25, align 8
  %208 = load double, ptr %24, align 8
  %209 = fadd double %205, %208
  %210 = call i32 %207(ptr noundef nonnull %8, double noundef %209) #8
  br label %211

211:                                              ; preds = %164, %206
  %212 = phi i32 [ %210, %206 ], [ %171, %164 ]
  %213 = icmp eq i32 %212, 0
  br i1 %213, label %214, label %262

214:                                              ; preds = %211
  %215 = call fastcc i32 @motion_is_free(ptr noundef nonnull %0, ptr noundef nonnull %8, ptr noundef nonnull %26)
  %216 = icmp eq i32 %215, 0
  br i1 %216, label %262, label %217

217:                                              ; preds = %214
  %218 = add nsw i64 %97, 1
  %219 = mul i64 %218, %11
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %2, ptr align 8 %1, i64 %219, i1 false)
  %220 = add nsw i64 %97, 2
  %221 = load i64, ptr %0, align 8
  %222 = mul nsw i64 %221, %218
  %223 = getelementptr inbounds double, ptr %2, i64 %222
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %223, ptr nonnull align 16 %8, i64 %11, i1 false)
  %224 = add nsw i64 %97, 3
  %225 = load i64, ptr %0, align 8
  %226 = mul nsw i64 %225, %220
  %227 = getelementptr inbounds double, ptr %2, i64 %226
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %227, ptr nonnull align 16 %26, i64 %11, i1 false)
  %228 = load i64, ptr %0, align 8
  %229 = mul nsw i64 %228, %224
  %230 = getelementptr inbounds double, ptr %2, i64 %229
  %231 = add nsw i64 %128, 1
  %232 = mul nsw i64 %228, %231
  %233 = getelementptr inbounds double, ptr %1, i64 %232
  %234 = xor i64 %128, -1
  %235 = add i64 %31, %234
  %236 = mul i64 %235, %11
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %230, ptr align 8 %233, i64 %236, i1 false)
  %237 = add nsw i64 %224, %235
  call void @llvm.lifetime.start.p0(i64 16, ptr nonnull %6) #8
  %238 = load ptr, ptr %27, align 8
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %6, ptr noundef nonnull align 8 dereferenceable(16) %238, i64 16, i1 false)
  %239 = load i64, ptr %28, align 8
  %240 = icmp eq i64 %239, 0
  br i1 %240, label %241, label %242

241:                                              ; preds = %217
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %6) #8
  br label %260

242:                                              ; preds = %217
  %243 = call i64 @llvm.smax.i64(i64 %237, i64 1)
  %244 = add nsw i64 %243, -1
  br label %245

245:                                              ; preds = %249, %242
  %246 = phi i64 [ %247, %249 ], [ 0, %242 ]
  %247 = add nuw nsw i64 %246, 1
  %248 = icmp eq i64 %246, %244
  br i1 %248, label %258, label %249

249:                                              ; preds = %245
  %250 = load i64, ptr %0, align 8
  %251 = mul nsw i64 %250, %246
  %252 = getelementptr inbounds double, ptr %2, i64 %251
  %253 = mul nsw i64 %250, %247
  %254 = getelementptr inbounds double, ptr %2, i64 %253
  %255 = load ptr, ptr %29, align 8
  %256 = call fastcc i32 @carry(ptr noundef nonnull %0, ptr noundef %252, ptr noundef %254, ptr noundef nonnull %6, ptr noundef %255)
  %257 = icmp eq i32 %256, 0
  br i1 %257, label %258, label %245

258:                                              ; preds = %245, %249
  %259 = icmp slt i64 %247, %237
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %6) #8
  br i1 %259, label %262, label %260

260:                                              ; preds = %241, %258
  %261 = mul i64 %237, %11
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1, ptr align 8 %2, i64 %261, i1 false)
  br label %262

262:                                              ; preds = %260, %258, %211, %214, %96
  %263 = phi i64 [ %31, %96 ], [ %31, %214 ], [ %31, %211 ], [ %237, %260 ], [ %31, %258 ]
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %9) #8
  call void @llvm.lifetime.end.p0(i64 1024, ptr nonnull %8) #8
  call void @llvm.lifetime.end.p0(i64 16, ptr nonnull %7) #8
  %264 = add nuw nsw i64 %32, 1
  %265 = icmp slt i64 %264, %4
  %266 = icmp sgt i64 %263, 2
  %267 = select i1 %265, i1 %266, i1 false
  br i1 %267, label %30, label %35
}

declare double @llvm.maxnum.f64(double, double) #4

declare double @llvm.minnum.f64(double, double) #4

declare double @llvm.fabs.f64(double) #4

declare double @llvm.ceil.f64(double) #4

declare double @llvm.sqrt.f64(double) #4

declare i64 @llvm.smin.i64(i64, i64) #5

declare i32 @bcmp(ptr nocapture, ptr nocapture, i64) local_unnamed_addr #6

declare i64 @llvm.smax.i64(i64, i64) #5

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #7

attributes #0 = { nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #3 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #5 = { nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #6 = { nofree nounwind willreturn memory(argmem: read) }
attributes #7 = { nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #8 = { nounwind }


