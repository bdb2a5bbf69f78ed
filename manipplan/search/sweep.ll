; sweep.c 01246b27dcd55a7dfc41bcd3df13ee89db08993b278fe2b4e650e373c11b46dd: written by make kernel

%struct.Grid = type { i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr }
%struct.Cells = type { ptr, ptr, ptr, ptr }
%struct.Step = type { ptr, %struct.Cells, %struct.Values, %struct.Cells, %struct.Values, ptr, ptr, ptr }
%struct.Values = type { ptr, ptr }

@place_beside.by = internal unnamed_addr constant [3 x i64] [i64 0, i64 -1, i64 1], align 16

define dso_local i64 @manipplan_taking_part(ptr nocapture noundef readonly %0, i64 noundef %1, double noundef %2, double noundef %3, ptr nocapture noundef writeonly %4) local_unnamed_addr #0 {
  %6 = fcmp ult double %3, 1.000000e+00
  br i1 %6, label %21, label %7

7:                                                ; preds = %5
  %8 = icmp sgt i64 %1, 0
  br i1 %8, label %9, label %43

9:                                                ; preds = %7, %9
  %10 = phi i64 [ %18, %9 ], [ 0, %7 ]
  %11 = phi i64 [ %19, %9 ], [ 0, %7 ]
  %12 = trunc i64 %11 to i32
  %13 = getelementptr inbounds i32, ptr %4, i64 %10
  store i32 %12, ptr %13, align 4
  %14 = getelementptr inbounds double, ptr %0, i64 %11
  %15 = load double, ptr %14, align 8
  %16 = fcmp oge double %15, %2
  %17 = zext i1 %16 to i64
  %18 = add nuw nsw i64 %10, %17
  %19 = add nuw nsw i64 %11, 1
  %20 = icmp eq i64 %19, %1
  br i1 %20, label %43, label %9

21:                                               ; preds = %5
  %22 = fmul double %3, 0x41F0000000000000
  %23 = fptoui double %22 to i64
  %24 = icmp eq i64 %1, 0
  br i1 %24, label %43, label %25

25:                                               ; preds = %21, %25
  %26 = phi i64 [ %41, %25 ], [ 0, %21 ]
  %27 = phi i64 [ %40, %25 ], [ 0, %21 ]
  %28 = lshr i64 %26, 15
  %29 = xor i64 %28, %26
  %30 = mul i64 %29, -7046029254386353131
  %31 = trunc i64 %26 to i32
  %32 = getelementptr inbounds i32, ptr %4, i64 %27
  store i32 %31, ptr %32, align 4
  %33 = getelementptr inbounds double, ptr %0, i64 %26
  %34 = load double, ptr %33, align 8
  %35 = fcmp oge double %34, %2
  %36 = lshr i64 %30, 32
  %37 = icmp ult i64 %36, %23
  %38 = and i1 %37, %35
  %39 = zext i1 %38 to i64
  %40 = add nuw nsw i64 %27, %39
  %41 = add nuw i64 %26, 1
  %42 = icmp eq i64 %41, %1
  br i1 %42, label %43, label %25

43:                                               ; preds = %9, %25, %7, %21
  %44 = phi i64 [ 0, %21 ], [ 0, %7 ], [ %40, %25 ], [ %18, %9 ]
  ret i64 %44
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

define dso_local void @manipplan_sort_into_cells(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, i64 noundef %4, double noundef %5, ptr nocapture noundef %6, ptr nocapture noundef readonly %7) local_unnamed_addr #2 {
  %9 = load i64, ptr %0, align 8
  %10 = getelementptr inbounds %struct.Grid, ptr %0, i64 0, i32 4
  %11 = load ptr, ptr %10, align 8
  %12 = load i64, ptr %11, align 8
  %13 = getelementptr inbounds i64, ptr %11, i64 1
  %14 = load i64, ptr %13, align 8
  %15 = mul nsw i64 %14, %12
  %16 = getelementptr inbounds i64, ptr %11, i64 2
  %17 = load i64, ptr %16, align 8
  %18 = mul nsw i64 %15, %17
  %19 = icmp slt i64 %18, 0
  br i1 %19, label %27, label %20

20:                                               ; preds = %8
  %21 = getelementptr inbounds %struct.Cells, ptr %7, i64 0, i32 3
  %22 = load ptr, ptr %21, align 8
  %23 = mul i64 %14, %17
  %24 = mul i64 %23, %12
  %25 = shl i64 %24, 2
  %26 = add i64 %25, 4
  tail call void @llvm.memset.p0.i64(ptr align 4 %22, i8 0, i64 %26, i1 false)
  br label %27

27:                                               ; preds = %20, %8
  %28 = icmp sgt i64 %4, 0
  br i1 %28, label %29, label %36

29:                                               ; preds = %27
  %30 = getelementptr inbounds %struct.Cells, ptr %7, i64 0, i32 3
  %31 = load ptr, ptr %30, align 8
  %32 = getelementptr inbounds %struct.Grid, ptr %0, i64 0, i32 1
  %33 = getelementptr inbounds %struct.Grid, ptr %0, i64 0, i32 5
  %34 = getelementptr inbounds %struct.Grid, ptr %0, i64 0, i32 2
  %35 = getelementptr inbounds %struct.Grid, ptr %0, i64 0, i32 3
  br label %40

36:                                               ; preds = %94, %27
  br i1 %19, label %104, label %37

37:                                               ; preds = %36
  %38 = getelementptr inbounds %struct.Cells, ptr %7, i64 0, i32 3
  %39 = load ptr, ptr %38, align 8
  br label %114

40:                                               ; preds = %29, %94
  %41 = phi i64 [ 0, %29 ], [ %102, %94 ]
  %42 = getelementptr inbounds i32, ptr %3, i64 %41
  %43 = load i32, ptr %42, align 4
  %44 = sext i32 %43 to i64
  %45 = mul nsw i64 %9, %44
  %46 = getelementptr inbounds double, ptr %1, i64 %45
  br label %47

47:                                               ; preds = %90, %40
  %48 = phi i64 [ 0, %40 ], [ %91, %90 ]
  %49 = phi i64 [ 0, %40 ], [ %92, %90 ]
  %50 = getelementptr inbounds i64, ptr %11, i64 %49
  %51 = load i64, ptr %50, align 8
  %52 = icmp eq i64 %51, 1
  br i1 %52, label %90, label %53

53:                                               ; preds = %47
  %54 = load ptr, ptr %32, align 8
  %55 = getelementptr inbounds i64, ptr %54, i64 %49
  %56 = load i64, ptr %55, align 8
  %57 = getelementptr inbounds double, ptr %46, i64 %56
  %58 = load double, ptr %57, align 8
  %59 = load ptr, ptr %33, align 8
  %60 = getelementptr inbounds i8, ptr %59, i64 %49
  %61 = load i8, ptr %60, align 1
  %62 = icmp eq i8 %61, 0
  br i1 %62, label %69, label %63

63:                                               ; preds = %53
  %64 = fdiv double %58, 0x401921FB54442D18
  %65 = tail call double @llvm.floor.f64(double %64)
  %66 = fsub double %64, %65
  %67 = sitofp i64 %51 to double
  %68 = fmul double %66, %67
  br label %79

69:                                               ; preds = %53
  %70 = load ptr, ptr %34, align 8
  %71 = getelementptr inbounds double, ptr %70, i64 %49
  %72 = load double, ptr %71, align 8
  %73 = fsub double %58, %72
  %74 = load ptr, ptr %35, align 8
  %75 = getelementptr inbounds double, ptr %74, i64 %49
  %76 = load double, ptr %75, align 8
  %77 = fmul double %73, %76
  %78 = sitofp i64 %51 to double
  br label %79

79:                                               ; preds = %69, %63
  %80 = phi double [ %78, %69 ], [ %67, %63 ]
  %81 = phi double [ %77, %69 ], [ %68, %63 ]
  %82 = fcmp ogt double %81, 0.000000e+00
  %83 = select i1 %82, double %81, double 0.000000e+00
  %84 = fadd double %80, -1.000000e+00
  %85 = fcmp olt double %83, %84
  %86 = select i1 %85, double %83, double %84
  %87 = mul nsw i64 %51, %48
  %88 = fptosi double %86 to i64
  %89 = add nsw i64 %87, %88
  br label %90

90:                                               ; preds = %79, %47
  %91 = phi i64 [ %89, %79 ], [ %48, %47 ]
  %92 = add nuw nsw i64 %49, 1
  %93 = icmp eq i64 %92, 3
  br i1 %93, label %94, label %47

94:                                               ; preds = %90
  %95 = trunc i64 %91 to i32
  %96 = getelementptr inbounds i32, ptr %6, i64 %41
  store i32 %95, ptr %96, align 4
  %97 = shl i64 %91, 32
  %98 = ashr exact i64 %97, 32
  %99 = getelementptr inbounds i32, ptr %31, i64 %98
  %100 = load i32, ptr %99, align 4
  %101 = add nsw i32 %100, 1
  store i32 %101, ptr %99, align 4
  %102 = add nuw nsw i64 %41, 1
  %103 = icmp eq i64 %102, %4
  br i1 %103, label %36, label %40

104:                                              ; preds = %114, %36
  br i1 %28, label %105, label %126

105:                                              ; preds = %104
  %106 = getelementptr inbounds %struct.Cells, ptr %7, i64 0, i32 3
  %107 = load ptr, ptr %106, align 8
  %108 = load ptr, ptr %7, align 8
  %109 = getelementptr inbounds %struct.Cells, ptr %7, i64 0, i32 2
  %110 = load ptr, ptr %109, align 8
  %111 = icmp sgt i64 %9, 0
  %112 = getelementptr inbounds %struct.Grid, ptr %0, i64 0, i32 6
  %113 = getelementptr inbounds %struct.Cells, ptr %7, i64 0, i32 1
  br label %127

114:                                              ; preds = %37, %114
  %115 = phi i64 [ 0, %37 ], [ %120, %114 ]
  %116 = phi i64 [ 0, %37 ], [ %122, %114 ]
  %117 = getelementptr inbounds i32, ptr %39, i64 %116
  %118 = load i32, ptr %117, align 4
  %119 = zext i32 %118 to i64
  %120 = add i64 %115, %119
  %121 = trunc i64 %120 to i32
  store i32 %121, ptr %117, align 4
  %122 = add nuw i64 %116, 1
  %123 = icmp eq i64 %116, %18
  br i1 %123, label %104, label %114

124:                                              ; preds = %154, %127
  %125 = icmp sgt i64 %128, 1
  br i1 %125, label %127, label %126

126:                                              ; preds = %124, %104
  ret void

127:                                              ; preds = %105, %124
  %128 = phi i64 [ %4, %105 ], [ %129, %124 ]
  %129 = add nsw i64 %128, -1
  %130 = getelementptr inbounds i32, ptr %6, i64 %129
  %131 = load i32, ptr %130, align 4
  %132 = sext i32 %131 to i64
  %133 = getelementptr inbounds i32, ptr %107, i64 %132
  %134 = load i32, ptr %133, align 4
  %135 = add nsw i32 %134, -1
  store i32 %135, ptr %133, align 4
  %136 = sext i32 %135 to i64
  %137 = getelementptr inbounds i32, ptr %3, i64 %129
  %138 = load i32, ptr %137, align 4
  %139 = sext i32 %138 to i64
  %140 = mul nsw i64 %9, %139
  %141 = getelementptr inbounds double, ptr %1, i64 %140
  %142 = getelementptr inbounds i32, ptr %108, i64 %136
  store i32 %138, ptr %142, align 4
  %143 = load i32, ptr %137, align 4
  %144 = sext i32 %143 to i64
  %145 = getelementptr inbounds double, ptr %2, i64 %144
  %146 = load double, ptr %145, align 8
  %147 = fcmp olt double %146, %5
  %148 = select i1 %147, double %146, double %5
  %149 = getelementptr inbounds double, ptr %110, i64 %136
  store double %148, ptr %149, align 8
  br i1 %111, label %150, label %124

150:                                              ; preds = %127
  %151 = load ptr, ptr %112, align 8
  %152 = load ptr, ptr %113, align 8
  %153 = mul nsw i64 %9, %136
  br label %154

154:                                              ; preds = %150, %154
  %155 = phi i64 [ 0, %150 ], [ %162, %154 ]
  %156 = getelementptr inbounds i64, ptr %151, i64 %155
  %157 = load i64, ptr %156, align 8
  %158 = getelementptr inbounds double, ptr %141, i64 %157
  %159 = load double, ptr %158, align 8
  %160 = add nsw i64 %155, %153
  %161 = getelementptr inbounds double, ptr %152, i64 %160
  store double %159, ptr %161, align 8
  %162 = add nuw nsw i64 %155, 1
  %163 = icmp eq i64 %162, %9
  br i1 %163, label %124, label %154
}

define dso_local void @manipplan_largest_of_each(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef readonly %2, ptr nocapture noundef writeonly %3) local_unnamed_addr #0 {
  %5 = icmp sgt i64 %1, 0
  br i1 %5, label %6, label %8

6:                                                ; preds = %4
  %7 = load i32, ptr %0, align 4
  br label %9

8:                                                ; preds = %19, %4
  ret void

9:                                                ; preds = %6, %19
  %10 = phi i32 [ %14, %19 ], [ %7, %6 ]
  %11 = phi i64 [ %12, %19 ], [ 0, %6 ]
  %12 = add nuw nsw i64 %11, 1
  %13 = getelementptr inbounds i32, ptr %0, i64 %12
  %14 = load i32, ptr %13, align 4
  %15 = sext i32 %14 to i64
  %16 = icmp slt i32 %10, %14
  br i1 %16, label %17, label %19

17:                                               ; preds = %9
  %18 = sext i32 %10 to i64
  br label %23

19:                                               ; preds = %23, %9
  %20 = phi double [ 0xFFF0000000000000, %9 ], [ %29, %23 ]
  %21 = getelementptr inbounds double, ptr %3, i64 %11
  store double %20, ptr %21, align 8
  %22 = icmp eq i64 %12, %1
  br i1 %22, label %8, label %9

23:                                               ; preds = %17, %23
  %24 = phi i64 [ %30, %23 ], [ %18, %17 ]
  %25 = phi double [ %29, %23 ], [ 0xFFF0000000000000, %17 ]
  %26 = getelementptr inbounds double, ptr %2, i64 %24
  %27 = load double, ptr %26, align 8
  %28 = fcmp ogt double %27, %25
  %29 = select i1 %28, double %27, double %25
  %30 = add nsw i64 %24, 1
  %31 = icmp eq i64 %30, %15
  br i1 %31, label %19, label %23
}

define dso_local void @manipplan_widest(ptr nocapture noundef readonly %0, i64 noundef %1, i64 noundef %2) local_unnamed_addr #2 {
  %4 = alloca [27 x i64], align 16
  %5 = load ptr, ptr %0, align 8
  %6 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 2
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 2, i32 1
  %9 = load ptr, ptr %8, align 8
  call void @llvm.lifetime.start.p0(i64 216, ptr nonnull %4) #6
  %10 = load i64, ptr %5, align 8
  %11 = icmp slt i64 %1, %2
  br i1 %11, label %12, label %25

12:                                               ; preds = %3
  %13 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 3, i32 3
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 3, i32 2
  %16 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 3, i32 1
  %17 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 1, i32 3
  %18 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 1, i32 1
  %19 = getelementptr inbounds %struct.Grid, ptr %5, i64 0, i32 7
  %20 = getelementptr inbounds %struct.Grid, ptr %5, i64 0, i32 8
  %21 = icmp slt i64 %10, 1
  %22 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 4
  %23 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 5
  %24 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 4, i32 1
  br label %26

25:                                               ; preds = %50, %3
  call void @llvm.lifetime.end.p0(i64 216, ptr nonnull %4) #6
  ret void

26:                                               ; preds = %12, %50
  %27 = phi i64 [ %1, %12 ], [ %31, %50 ]
  %28 = getelementptr inbounds i32, ptr %14, i64 %27
  %29 = load i32, ptr %28, align 4
  %30 = sext i32 %29 to i64
  %31 = add nsw i64 %27, 1
  %32 = getelementptr inbounds i32, ptr %14, i64 %31
  %33 = load i32, ptr %32, align 4
  %34 = sext i32 %33 to i64
  %35 = icmp slt i32 %29, %33
  br i1 %35, label %36, label %50

36:                                               ; preds = %26
  %37 = call fastcc i64 @cells_around(ptr noundef nonnull %5, i64 noundef %27, ptr noundef %9, ptr noundef nonnull %4)
  %38 = icmp eq i64 %37, 0
  br i1 %38, label %43, label %39

39:                                               ; preds = %36
  %40 = load i64, ptr %4, align 16
  %41 = getelementptr inbounds double, ptr %9, i64 %40
  %42 = load double, ptr %41, align 8
  br label %43

43:                                               ; preds = %36, %39
  %44 = phi double [ 0xFFF0000000000000, %36 ], [ %42, %39 ]
  %45 = load ptr, ptr %15, align 8
  %46 = load ptr, ptr %16, align 8
  %47 = icmp sgt i64 %37, 0
  %48 = load ptr, ptr %22, align 8
  %49 = load ptr, ptr %23, align 8
  br label %55

50:                                               ; preds = %143, %26
  %51 = phi double [ 0xFFF0000000000000, %26 ], [ %152, %143 ]
  %52 = load ptr, ptr %24, align 8
  %53 = getelementptr inbounds double, ptr %52, i64 %27
  store double %51, ptr %53, align 8
  %54 = icmp eq i64 %31, %2
  br i1 %54, label %25, label %26

55:                                               ; preds = %43, %143
  %56 = phi double [ 0xFFF0000000000000, %43 ], [ %152, %143 ]
  %57 = phi i64 [ %30, %43 ], [ %153, %143 ]
  %58 = getelementptr inbounds double, ptr %45, i64 %57
  %59 = load double, ptr %58, align 8
  %60 = fcmp olt double %59, %44
  %61 = select i1 %60, double %59, double %44
  %62 = mul nsw i64 %57, %10
  %63 = getelementptr inbounds double, ptr %46, i64 %62
  br i1 %47, label %64, label %143

64:                                               ; preds = %55, %138
  %65 = phi i64 [ %141, %138 ], [ 0, %55 ]
  %66 = phi i64 [ %140, %138 ], [ -1, %55 ]
  %67 = phi double [ %139, %138 ], [ 0xFFF0000000000000, %55 ]
  %68 = getelementptr inbounds [27 x i64], ptr %4, i64 0, i64 %65
  %69 = load i64, ptr %68, align 8
  %70 = getelementptr inbounds double, ptr %9, i64 %69
  %71 = load double, ptr %70, align 8
  %72 = fcmp ugt double %71, %67
  br i1 %72, label %73, label %143

73:                                               ; preds = %64
  %74 = icmp slt i64 %66, 0
  %75 = fcmp ult double %67, %61
  %76 = select i1 %74, i1 true, i1 %75
  br i1 %76, label %77, label %143

77:                                               ; preds = %73
  %78 = load ptr, ptr %17, align 8
  %79 = getelementptr inbounds i32, ptr %78, i64 %69
  %80 = load i32, ptr %79, align 4
  %81 = add nsw i64 %69, 1
  %82 = getelementptr inbounds i32, ptr %78, i64 %81
  %83 = load i32, ptr %82, align 4
  %84 = sext i32 %83 to i64
  %85 = icmp slt i32 %80, %83
  br i1 %85, label %86, label %138

86:                                               ; preds = %77
  %87 = sext i32 %80 to i64
  br label %88

88:                                               ; preds = %86, %133
  %89 = phi i64 [ %136, %133 ], [ %87, %86 ]
  %90 = phi i64 [ %135, %133 ], [ %66, %86 ]
  %91 = phi double [ %134, %133 ], [ %67, %86 ]
  %92 = getelementptr inbounds double, ptr %7, i64 %89
  %93 = load double, ptr %92, align 8
  %94 = fcmp ogt double %93, %91
  br i1 %94, label %95, label %133

95:                                               ; preds = %88
  %96 = load ptr, ptr %18, align 8
  %97 = mul nsw i64 %89, %10
  %98 = getelementptr inbounds double, ptr %96, i64 %97
  %99 = load ptr, ptr %19, align 8
  %100 = load ptr, ptr %20, align 8
  br i1 %21, label %131, label %101

101:                                              ; preds = %95, %125
  %102 = phi i1 [ %127, %125 ], [ false, %95 ]
  %103 = phi i64 [ %126, %125 ], [ 0, %95 ]
  %104 = getelementptr inbounds double, ptr %63, i64 %103
  %105 = load double, ptr %104, align 8
  %106 = getelementptr inbounds double, ptr %98, i64 %103
  %107 = load double, ptr %106, align 8
  %108 = fsub double %105, %107
  %109 = tail call double @llvm.fabs.f64(double %108)
  %110 = getelementptr inbounds double, ptr %99, i64 %103
  %111 = load double, ptr %110, align 8
  %112 = fcmp olt double %109, %111
  br i1 %112, label %125, label %113

113:                                              ; preds = %101
  %114 = getelementptr inbounds i8, ptr %100, i64 %103
  %115 = load i8, ptr %114, align 1
  %116 = icmp eq i8 %115, 0
  br i1 %116, label %129, label %117

117:                                              ; preds = %113
  %118 = fdiv double %108, 0x401921FB54442D18
  %119 = fadd double %118, 5.000000e-01
  %120 = tail call double @llvm.floor.f64(double %119)
  %121 = fmul double %120, 0x401921FB54442D18
  %122 = fsub double %108, %121
  %123 = tail call double @llvm.fabs.f64(double %122)
  %124 = fcmp olt double %123, %111
  br i1 %124, label %125, label %129

125:                                              ; preds = %117, %101
  %126 = add nuw nsw i64 %103, 1
  %127 = icmp sge i64 %126, %10
  %128 = icmp eq i64 %126, %10
  br i1 %128, label %129, label %101

129:                                              ; preds = %113, %117, %125
  %130 = phi i1 [ %102, %117 ], [ %102, %113 ], [ %127, %125 ]
  br i1 %130, label %131, label %133

131:                                              ; preds = %95, %129
  %132 = fcmp ult double %93, %61
  br i1 %132, label %133, label %138

133:                                              ; preds = %88, %129, %131
  %134 = phi double [ %93, %131 ], [ %91, %129 ], [ %91, %88 ]
  %135 = phi i64 [ %89, %131 ], [ %90, %129 ], [ %90, %88 ]
  %136 = add nsw i64 %89, 1
  %137 = icmp eq i64 %136, %84
  br i1 %137, label %138, label %88

138:                                              ; preds = %133, %131, %77
  %139 = phi double [ %67, %77 ], [ %93, %131 ], [ %134, %133 ]
  %140 = phi i64 [ %66, %77 ], [ %89, %131 ], [ %135, %133 ]
  %141 = add nuw nsw i64 %65, 1
  %142 = icmp eq i64 %141, %37
  br i1 %142, label %143, label %64

143:                                              ; preds = %138, %73, %64, %55
  %144 = phi double [ 0xFFF0000000000000, %55 ], [ %67, %64 ], [ %67, %73 ], [ %139, %138 ]
  %145 = phi i64 [ -1, %55 ], [ %66, %64 ], [ %66, %73 ], [ %140, %138 ]
  %146 = fcmp olt double %59, %144
  %147 = select i1 %146, double %59, double %144
  %148 = getelementptr inbounds double, ptr %48, i64 %57
  store double %147, ptr %148, align 8
  %149 = trunc i64 %145 to i32
  %150 = getelementptr inbounds i32, ptr %49, i64 %57
  store i32 %149, ptr %150, align 4
  %151 = fcmp ogt double %147, %56
  %152 = select i1 %151, double %147, double %56
  %153 = add nsw i64 %57, 1
  %154 = icmp eq i64 %153, %34
  br i1 %154, label %50, label %55
}

define internal fastcc i64 @cells_around(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef readonly %2, ptr nocapture noundef %3) unnamed_addr #3 {
  %5 = getelementptr inbounds %struct.Grid, ptr %0, i64 0, i32 4
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds i64, ptr %6, i64 1
  %8 = load i64, ptr %7, align 8
  %9 = getelementptr inbounds i64, ptr %6, i64 2
  %10 = load i64, ptr %9, align 8
  %11 = mul nsw i64 %10, %8
  %12 = sdiv i64 %1, %11
  %13 = sdiv i64 %1, %10
  %14 = srem i64 %13, %8
  %15 = srem i64 %1, %10
  %16 = load i64, ptr %6, align 8
  %17 = icmp sgt i64 %16, 1
  %18 = icmp sgt i64 %8, 1
  %19 = icmp sgt i64 %10, 1
  %20 = getelementptr inbounds %struct.Grid, ptr %0, i64 0, i32 5
  br label %22

21:                                               ; preds = %43
  ret i64 %44

22:                                               ; preds = %4, %43
  %23 = phi i64 [ 0, %4 ], [ %44, %43 ]
  %24 = phi i64 [ 0, %4 ], [ %45, %43 ]
  %25 = load i64, ptr %6, align 8
  %26 = getelementptr inbounds [3 x i64], ptr @place_beside.by, i64 0, i64 %24
  %27 = load i64, ptr %26, align 8
  %28 = add nsw i64 %27, %12
  %29 = icmp sgt i64 %28, -1
  %30 = icmp slt i64 %28, %25
  %31 = select i1 %29, i1 %30, i1 false
  br i1 %31, label %40, label %32

32:                                               ; preds = %22
  %33 = load ptr, ptr %20, align 8
  %34 = load i8, ptr %33, align 1
  %35 = icmp eq i8 %34, 0
  br i1 %35, label %43, label %36

36:                                               ; preds = %32
  %37 = add nsw i64 %28, %25
  %38 = srem i64 %37, %25
  %39 = icmp sgt i64 %38, -1
  br i1 %39, label %40, label %43

40:                                               ; preds = %22, %36
  %41 = phi i64 [ %38, %36 ], [ %28, %22 ]
  %42 = mul nsw i64 %41, %8
  br label %48

43:                                               ; preds = %71, %32, %36
  %44 = phi i64 [ %23, %36 ], [ %23, %32 ], [ %72, %71 ]
  %45 = add nuw nsw i64 %24, 1
  %46 = icmp ult i64 %24, 2
  %47 = select i1 %17, i1 %46, i1 false
  br i1 %47, label %22, label %21

48:                                               ; preds = %40, %71
  %49 = phi i64 [ %23, %40 ], [ %72, %71 ]
  %50 = phi i64 [ 0, %40 ], [ %73, %71 ]
  %51 = load i64, ptr %7, align 8
  %52 = getelementptr inbounds [3 x i64], ptr @place_beside.by, i64 0, i64 %50
  %53 = load i64, ptr %52, align 8
  %54 = add nsw i64 %53, %14
  %55 = icmp sgt i64 %54, -1
  %56 = icmp slt i64 %54, %51
  %57 = select i1 %55, i1 %56, i1 false
  br i1 %57, label %67, label %58

58:                                               ; preds = %48
  %59 = load ptr, ptr %20, align 8
  %60 = getelementptr inbounds i8, ptr %59, i64 1
  %61 = load i8, ptr %60, align 1
  %62 = icmp eq i8 %61, 0
  br i1 %62, label %71, label %63

63:                                               ; preds = %58
  %64 = add nsw i64 %54, %51
  %65 = srem i64 %64, %51
  %66 = icmp sgt i64 %65, -1
  br i1 %66, label %67, label %71

67:                                               ; preds = %48, %63
  %68 = phi i64 [ %65, %63 ], [ %54, %48 ]
  %69 = add nsw i64 %68, %42
  %70 = mul nsw i64 %69, %10
  br label %76

71:                                               ; preds = %118, %58, %63
  %72 = phi i64 [ %49, %63 ], [ %49, %58 ], [ %119, %118 ]
  %73 = add nuw nsw i64 %50, 1
  %74 = icmp ult i64 %50, 2
  %75 = select i1 %18, i1 %74, i1 false
  br i1 %75, label %48, label %43

76:                                               ; preds = %67, %118
  %77 = phi i64 [ %49, %67 ], [ %119, %118 ]
  %78 = phi i64 [ 0, %67 ], [ %120, %118 ]
  %79 = load i64, ptr %9, align 8
  %80 = getelementptr inbounds [3 x i64], ptr @place_beside.by, i64 0, i64 %78
  %81 = load i64, ptr %80, align 8
  %82 = add nsw i64 %81, %15
  %83 = icmp sgt i64 %82, -1
  %84 = icmp slt i64 %82, %79
  %85 = select i1 %83, i1 %84, i1 false
  br i1 %85, label %95, label %86

86:                                               ; preds = %76
  %87 = load ptr, ptr %20, align 8
  %88 = getelementptr inbounds i8, ptr %87, i64 2
  %89 = load i8, ptr %88, align 1
  %90 = icmp eq i8 %89, 0
  br i1 %90, label %118, label %91

91:                                               ; preds = %86
  %92 = add nsw i64 %82, %79
  %93 = srem i64 %92, %79
  %94 = icmp slt i64 %93, 0
  br i1 %94, label %118, label %95

95:                                               ; preds = %76, %91
  %96 = phi i64 [ %93, %91 ], [ %82, %76 ]
  %97 = add nsw i64 %96, %70
  %98 = getelementptr inbounds double, ptr %2, i64 %97
  %99 = load double, ptr %98, align 8
  %100 = fcmp ogt double %99, 0xFFF0000000000000
  br i1 %100, label %101, label %118

101:                                              ; preds = %95
  %102 = icmp sgt i64 %77, 0
  br i1 %102, label %103, label %114

103:                                              ; preds = %101, %111
  %104 = phi i64 [ %105, %111 ], [ %77, %101 ]
  %105 = add nsw i64 %104, -1
  %106 = getelementptr inbounds i64, ptr %3, i64 %105
  %107 = load i64, ptr %106, align 8
  %108 = getelementptr inbounds double, ptr %2, i64 %107
  %109 = load double, ptr %108, align 8
  %110 = fcmp olt double %109, %99
  br i1 %110, label %111, label %114

111:                                              ; preds = %103
  %112 = getelementptr inbounds i64, ptr %3, i64 %104
  store i64 %107, ptr %112, align 8
  %113 = icmp ugt i64 %104, 1
  br i1 %113, label %103, label %114

114:                                              ; preds = %103, %111, %101
  %115 = phi i64 [ %77, %101 ], [ 0, %111 ], [ %104, %103 ]
  %116 = getelementptr inbounds i64, ptr %3, i64 %115
  store i64 %97, ptr %116, align 8
  %117 = add nsw i64 %77, 1
  br label %118

118:                                              ; preds = %86, %114, %95, %91
  %119 = phi i64 [ %77, %91 ], [ %117, %114 ], [ %77, %95 ], [ %77, %86 ]
  %120 = add nuw nsw i64 %78, 1
  %121 = icmp ult i64 %78, 2
  %122 = select i1 %19, i1 %121, i1 false
  br i1 %122, label %76, label %71
}

define dso_local void @manipplan_shortest(ptr nocapture noundef readonly %0, i64 noundef %1, i64 noundef %2) local_unnamed_addr #2 {
  %4 = alloca [27 x i64], align 16
  %5 = load ptr, ptr %0, align 8
  %6 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 2
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 2, i32 1
  %9 = load ptr, ptr %8, align 8
  %10 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 6
  %11 = load ptr, ptr %10, align 8
  call void @llvm.lifetime.start.p0(i64 216, ptr nonnull %4) #6
  %12 = load i64, ptr %5, align 8
  %13 = icmp slt i64 %1, %2
  br i1 %13, label %14, label %28

14:                                               ; preds = %3
  %15 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 3, i32 3
  %16 = load ptr, ptr %15, align 8
  %17 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 3, i32 1
  %18 = icmp eq ptr %11, null
  %19 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 1, i32 3
  %20 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 1, i32 1
  %21 = getelementptr inbounds %struct.Grid, ptr %5, i64 0, i32 7
  %22 = getelementptr inbounds %struct.Grid, ptr %5, i64 0, i32 8
  %23 = icmp slt i64 %12, 1
  %24 = icmp sgt i64 %12, 0
  %25 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 4
  %26 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 5
  %27 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 4, i32 1
  br label %29

28:                                               ; preds = %45, %3
  call void @llvm.lifetime.end.p0(i64 216, ptr nonnull %4) #6
  ret void

29:                                               ; preds = %14, %45
  %30 = phi i64 [ %1, %14 ], [ %33, %45 ]
  %31 = getelementptr inbounds i32, ptr %16, i64 %30
  %32 = load i32, ptr %31, align 4
  %33 = add nsw i64 %30, 1
  %34 = getelementptr inbounds i32, ptr %16, i64 %33
  %35 = load i32, ptr %34, align 4
  %36 = sext i32 %35 to i64
  %37 = icmp slt i32 %32, %35
  br i1 %37, label %38, label %45

38:                                               ; preds = %29
  %39 = sext i32 %32 to i64
  %40 = call fastcc i64 @cells_around(ptr noundef nonnull %5, i64 noundef %30, ptr noundef %9, ptr noundef nonnull %4)
  %41 = load ptr, ptr %17, align 8
  %42 = icmp sgt i64 %40, 0
  %43 = load ptr, ptr %25, align 8
  %44 = load ptr, ptr %26, align 8
  br label %50

45:                                               ; preds = %179, %29
  %46 = phi double [ 0xFFF0000000000000, %29 ], [ %186, %179 ]
  %47 = load ptr, ptr %27, align 8
  %48 = getelementptr inbounds double, ptr %47, i64 %30
  store double %46, ptr %48, align 8
  %49 = icmp eq i64 %33, %2
  br i1 %49, label %28, label %29

50:                                               ; preds = %38, %179
  %51 = phi double [ 0xFFF0000000000000, %38 ], [ %186, %179 ]
  %52 = phi i64 [ %39, %38 ], [ %187, %179 ]
  %53 = mul nsw i64 %52, %12
  %54 = getelementptr inbounds double, ptr %41, i64 %53
  br i1 %42, label %55, label %179

55:                                               ; preds = %50, %78
  %56 = phi i64 [ %82, %78 ], [ 0, %50 ]
  %57 = phi i64 [ %81, %78 ], [ -1, %50 ]
  %58 = phi i64 [ %80, %78 ], [ -1, %50 ]
  %59 = phi double [ %79, %78 ], [ 0xFFF0000000000000, %50 ]
  %60 = getelementptr inbounds [27 x i64], ptr %4, i64 0, i64 %56
  %61 = load i64, ptr %60, align 8
  br i1 %18, label %62, label %66

62:                                               ; preds = %55
  %63 = getelementptr inbounds double, ptr %9, i64 %61
  %64 = load double, ptr %63, align 8
  %65 = fcmp ugt double %64, %59
  br i1 %65, label %66, label %179

66:                                               ; preds = %55, %62
  %67 = load ptr, ptr %19, align 8
  %68 = getelementptr inbounds i32, ptr %67, i64 %61
  %69 = load i32, ptr %68, align 4
  %70 = add nsw i64 %61, 1
  %71 = getelementptr inbounds i32, ptr %67, i64 %70
  %72 = load i32, ptr %71, align 4
  %73 = sext i32 %72 to i64
  %74 = icmp slt i32 %69, %72
  br i1 %74, label %75, label %78

75:                                               ; preds = %66
  %76 = sext i32 %69 to i64
  %77 = load ptr, ptr %20, align 8
  br label %84

78:                                               ; preds = %173, %66
  %79 = phi double [ %59, %66 ], [ %174, %173 ]
  %80 = phi i64 [ %58, %66 ], [ %175, %173 ]
  %81 = phi i64 [ %57, %66 ], [ %176, %173 ]
  %82 = add nuw nsw i64 %56, 1
  %83 = icmp eq i64 %82, %40
  br i1 %83, label %179, label %55

84:                                               ; preds = %75, %173
  %85 = phi i64 [ %76, %75 ], [ %177, %173 ]
  %86 = phi i64 [ %57, %75 ], [ %176, %173 ]
  %87 = phi i64 [ %58, %75 ], [ %175, %173 ]
  %88 = phi double [ %59, %75 ], [ %174, %173 ]
  %89 = mul nsw i64 %85, %12
  %90 = getelementptr inbounds double, ptr %77, i64 %89
  %91 = getelementptr inbounds double, ptr %7, i64 %85
  %92 = load double, ptr %91, align 8
  %93 = fcmp oeq double %92, 0xFFF0000000000000
  br i1 %93, label %173, label %94

94:                                               ; preds = %84
  br i1 %18, label %103, label %95

95:                                               ; preds = %94
  %96 = getelementptr inbounds i64, ptr %11, i64 %85
  %97 = load i64, ptr %96, align 8
  %98 = icmp slt i64 %97, %86
  br i1 %98, label %173, label %99

99:                                               ; preds = %95
  %100 = icmp ne i64 %97, %86
  %101 = fcmp ugt double %92, %88
  %102 = select i1 %100, i1 true, i1 %101
  br i1 %102, label %105, label %173

103:                                              ; preds = %94
  %104 = fcmp ugt double %92, %88
  br i1 %104, label %105, label %173

105:                                              ; preds = %103, %99
  %106 = load ptr, ptr %21, align 8
  %107 = load ptr, ptr %22, align 8
  br i1 %23, label %139, label %108

108:                                              ; preds = %105, %132
  %109 = phi i1 [ %134, %132 ], [ false, %105 ]
  %110 = phi i64 [ %133, %132 ], [ 0, %105 ]
  %111 = getelementptr inbounds double, ptr %54, i64 %110
  %112 = load double, ptr %111, align 8
  %113 = getelementptr inbounds double, ptr %90, i64 %110
  %114 = load double, ptr %113, align 8
  %115 = fsub double %112, %114
  %116 = tail call double @llvm.fabs.f64(double %115)
  %117 = getelementptr inbounds double, ptr %106, i64 %110
  %118 = load double, ptr %117, align 8
  %119 = fcmp olt double %116, %118
  br i1 %119, label %132, label %120

120:                                              ; preds = %108
  %121 = getelementptr inbounds i8, ptr %107, i64 %110
  %122 = load i8, ptr %121, align 1
  %123 = icmp eq i8 %122, 0
  br i1 %123, label %136, label %124

124:                                              ; preds = %120
  %125 = fdiv double %115, 0x401921FB54442D18
  %126 = fadd double %125, 5.000000e-01
  %127 = tail call double @llvm.floor.f64(double %126)
  %128 = fmul double %127, 0x401921FB54442D18
  %129 = fsub double %115, %128
  %130 = tail call double @llvm.fabs.f64(double %129)
  %131 = fcmp olt double %130, %118
  br i1 %131, label %132, label %136

132:                                              ; preds = %124, %108
  %133 = add nuw nsw i64 %110, 1
  %134 = icmp sge i64 %133, %12
  %135 = icmp eq i64 %133, %12
  br i1 %135, label %136, label %108

136:                                              ; preds = %120, %124, %132
  %137 = phi i1 [ %109, %124 ], [ %109, %120 ], [ %134, %132 ]
  br i1 %137, label %138, label %173

138:                                              ; preds = %136
  br i1 %24, label %143, label %139

139:                                              ; preds = %160, %105, %138
  %140 = phi double [ 0.000000e+00, %138 ], [ 0.000000e+00, %105 ], [ %163, %160 ]
  %141 = tail call double @llvm.sqrt.f64(double %140)
  %142 = fsub double %92, %141
  br i1 %18, label %170, label %166

143:                                              ; preds = %138, %160
  %144 = phi i64 [ %164, %160 ], [ 0, %138 ]
  %145 = phi double [ %163, %160 ], [ 0.000000e+00, %138 ]
  %146 = getelementptr inbounds double, ptr %90, i64 %144
  %147 = load double, ptr %146, align 8
  %148 = getelementptr inbounds double, ptr %54, i64 %144
  %149 = load double, ptr %148, align 8
  %150 = getelementptr inbounds i8, ptr %107, i64 %144
  %151 = load i8, ptr %150, align 1
  %152 = fsub double %149, %147
  %153 = icmp eq i8 %151, 0
  br i1 %153, label %160, label %154

154:                                              ; preds = %143
  %155 = fdiv double %152, 0x401921FB54442D18
  %156 = fadd double %155, 5.000000e-01
  %157 = tail call double @llvm.floor.f64(double %156)
  %158 = fmul double %157, 0x401921FB54442D18
  %159 = fsub double %152, %158
  br label %160

160:                                              ; preds = %143, %154
  %161 = phi double [ %159, %154 ], [ %152, %143 ]
  %162 = fmul double %161, %161
  %163 = fadd double %145, %162
  %164 = add nuw nsw i64 %144, 1
  %165 = icmp eq i64 %164, %12
  br i1 %165, label %139, label %143

166:                                              ; preds = %139
  %167 = getelementptr inbounds i64, ptr %11, i64 %85
  %168 = load i64, ptr %167, align 8
  %169 = icmp sgt i64 %168, %86
  br i1 %169, label %173, label %170

170:                                              ; preds = %166, %139
  %171 = fcmp ogt double %142, %88
  br i1 %171, label %172, label %173

172:                                              ; preds = %170
  br label %173

173:                                              ; preds = %172, %170, %166, %136, %95, %103, %99, %84
  %174 = phi double [ %88, %84 ], [ %88, %99 ], [ %88, %103 ], [ %88, %95 ], [ %88, %136 ], [ %142, %172 ], [ %88, %170 ], [ %142, %166 ]
  %175 = phi i64 [ %87, %84 ], [ %87, %99 ], [ %87, %103 ], [ %87, %95 ], [ %87, %136 ], [ %85, %172 ], [ %87, %170 ], [ %85, %166 ]
  %176 = phi i64 [ %86, %84 ], [ %86, %99 ], [ %86, %103 ], [ %86, %95 ], [ %86, %136 ], [ %86, %172 ], [ %86, %170 ], [ %168, %166 ]
  %177 = add nsw i64 %85, 1
  %178 = icmp eq i64 %177, %73
  br i1 %178, label %78, label %84

179:                                              ; preds = %78, %62, %50
  %180 = phi double [ 0xFFF0000000000000, %50 ], [ %59, %62 ], [ %79, %78 ]
  %181 = phi i64 [ -1, %50 ], [ %58, %62 ], [ %80, %78 ]
  %182 = getelementptr inbounds double, ptr %43, i64 %52
  store double %180, ptr %182, align 8
  %183 = trunc i64 %181 to i32
  %184 = getelementptr inbounds i32, ptr %44, i64 %52
  store i32 %183, ptr %184, align 4
  %185 = fcmp ogt double %180, %51
  %186 = select i1 %185, double %180, double %51
  %187 = add nsw i64 %52, 1
  %188 = icmp eq i64 %187, %36
  br i1 %188, label %45, label %50
}

declare double @llvm.sqrt.f64(double) #4

define dso_local void @manipplan_closest(ptr nocapture noundef readonly %0, i64 noundef %1, i64 noundef %2) local_unnamed_addr #2 {
  %4 = alloca [27 x i64], align 16
  %5 = load ptr, ptr %0, align 8
  %6 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 2
  %7 = load ptr, ptr %6, align 8
  %8 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 2, i32 1
  %9 = load ptr, ptr %8, align 8
  call void @llvm.lifetime.start.p0(i64 216, ptr nonnull %4) #6
  %10 = load i64, ptr %5, align 8
  %11 = icmp slt i64 %1, %2
  br i1 %11, label %12, label %26

12:                                               ; preds = %3
  %13 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 3, i32 3
  %14 = load ptr, ptr %13, align 8
  %15 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 3, i32 1
  %16 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 1, i32 3
  %17 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 1, i32 1
  %18 = getelementptr inbounds %struct.Grid, ptr %5, i64 0, i32 7
  %19 = getelementptr inbounds %struct.Grid, ptr %5, i64 0, i32 8
  %20 = icmp slt i64 %10, 1
  %21 = icmp sgt i64 %10, 0
  %22 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 7
  %23 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 4
  %24 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 5
  %25 = getelementptr inbounds %struct.Step, ptr %0, i64 0, i32 4, i32 1
  br label %27

26:                                               ; preds = %50, %3
  call void @llvm.lifetime.end.p0(i64 216, ptr nonnull %4) #6
  ret void

27:                                               ; preds = %12, %50
  %28 = phi i64 [ %1, %12 ], [ %32, %50 ]
  %29 = getelementptr inbounds i32, ptr %14, i64 %28
  %30 = load i32, ptr %29, align 4
  %31 = sext i32 %30 to i64
  %32 = add nsw i64 %28, 1
  %33 = getelementptr inbounds i32, ptr %14, i64 %32
  %34 = load i32, ptr %33, align 4
  %35 = sext i32 %34 to i64
  %36 = icmp slt i32 %30, %34
  br i1 %36, label %37, label %50

37:                                               ; preds = %27
  %38 = call fastcc i64 @cells_around(ptr noundef nonnull %5, i64 noundef %28, ptr noundef %9, ptr noundef nonnull %4)
  %39 = icmp eq i64 %38, 0
  br i1 %39, label %44, label %40

40:                                               ; preds = %37
  %41 = load i64, ptr %4, align 16
  %42 = getelementptr inbounds double, ptr %9, i64 %41
  %43 = load double, ptr %42, align 8
  br label %44

44:                                               ; preds = %37, %40
  %45 = phi double [ 0xFFF0000000000000, %37 ], [ %43, %40 ]
  %46 = load ptr, ptr %15, align 8
  %47 = icmp sgt i64 %38, 0
  %48 = load ptr, ptr %23, align 8
  %49 = load ptr, ptr %24, align 8
  br label %55

50:                                               ; preds = %173, %27
  %51 = phi double [ 0xFFF0000000000000, %27 ], [ %180, %173 ]
  %52 = load ptr, ptr %25, align 8
  %53 = getelementptr inbounds double, ptr %52, i64 %28
  store double %51, ptr %53, align 8
  %54 = icmp eq i64 %32, %2
  br i1 %54, label %26, label %27

55:                                               ; preds = %44, %173
  %56 = phi double [ 0xFFF0000000000000, %44 ], [ %180, %173 ]
  %57 = phi i64 [ %31, %44 ], [ %181, %173 ]
  %58 = mul nsw i64 %57, %10
  %59 = getelementptr inbounds double, ptr %46, i64 %58
  br i1 %47, label %60, label %173

60:                                               ; preds = %55, %83
  %61 = phi i64 [ %86, %83 ], [ 0, %55 ]
  %62 = phi i64 [ %85, %83 ], [ -1, %55 ]
  %63 = phi double [ %84, %83 ], [ 0xFFF0000000000000, %55 ]
  %64 = getelementptr inbounds [27 x i64], ptr %4, i64 0, i64 %61
  %65 = load i64, ptr %64, align 8
  %66 = getelementptr inbounds double, ptr %9, i64 %65
  %67 = load double, ptr %66, align 8
  %68 = fcmp ole double %67, %63
  %69 = fcmp oeq double %63, %45
  %70 = select i1 %68, i1 true, i1 %69
  br i1 %70, label %173, label %71

71:                                               ; preds = %60
  %72 = load ptr, ptr %16, align 8
  %73 = getelementptr inbounds i32, ptr %72, i64 %65
  %74 = load i32, ptr %73, align 4
  %75 = add nsw i64 %65, 1
  %76 = getelementptr inbounds i32, ptr %72, i64 %75
  %77 = load i32, ptr %76, align 4
  %78 = sext i32 %77 to i64
  %79 = icmp slt i32 %74, %77
  br i1 %79, label %80, label %83

80:                                               ; preds = %71
  %81 = sext i32 %74 to i64
  %82 = load ptr, ptr %17, align 8
  br label %88

83:                                               ; preds = %168, %71
  %84 = phi double [ %63, %71 ], [ %169, %168 ]
  %85 = phi i64 [ %62, %71 ], [ %170, %168 ]
  %86 = add nuw nsw i64 %61, 1
  %87 = icmp eq i64 %86, %38
  br i1 %87, label %173, label %60

88:                                               ; preds = %80, %168
  %89 = phi i64 [ %81, %80 ], [ %171, %168 ]
  %90 = phi i64 [ %62, %80 ], [ %170, %168 ]
  %91 = phi double [ %63, %80 ], [ %169, %168 ]
  %92 = mul nsw i64 %89, %10
  %93 = getelementptr inbounds double, ptr %82, i64 %92
  %94 = getelementptr inbounds double, ptr %7, i64 %89
  %95 = load double, ptr %94, align 8
  %96 = fcmp ugt double %95, %91
  br i1 %96, label %97, label %168

97:                                               ; preds = %88
  %98 = load ptr, ptr %18, align 8
  %99 = load ptr, ptr %19, align 8
  br i1 %20, label %133, label %100

100:                                              ; preds = %97, %124
  %101 = phi i1 [ %126, %124 ], [ false, %97 ]
  %102 = phi i64 [ %125, %124 ], [ 0, %97 ]
  %103 = getelementptr inbounds double, ptr %59, i64 %102
  %104 = load double, ptr %103, align 8
  %105 = getelementptr inbounds double, ptr %93, i64 %102
  %106 = load double, ptr %105, align 8
  %107 = fsub double %104, %106
  %108 = tail call double @llvm.fabs.f64(double %107)
  %109 = getelementptr inbounds double, ptr %98, i64 %102
  %110 = load double, ptr %109, align 8
  %111 = fcmp olt double %108, %110
  br i1 %111, label %124, label %112

112:                                              ; preds = %100
  %113 = getelementptr inbounds i8, ptr %99, i64 %102
  %114 = load i8, ptr %113, align 1
  %115 = icmp eq i8 %114, 0
  br i1 %115, label %128, label %116

116:                                              ; preds = %112
  %117 = fdiv double %107, 0x401921FB54442D18
  %118 = fadd double %117, 5.000000e-01
  %119 = tail call double @llvm.floor.f64(double %118)
  %120 = fmul double %119, 0x401921FB54442D18
  %121 = fsub double %107, %120
  %122 = tail call double @llvm.fabs.f64(double %121)
  %123 = fcmp olt double %122, %110
  br i1 %123, label %124, label %128

124:                                              ; preds = %116, %100
  %125 = add nuw nsw i64 %102, 1
  %126 = icmp sge i64 %125, %10
  %127 = icmp eq i64 %125, %10
  br i1 %127, label %128, label %100

128:                                              ; preds = %112, %116, %124
  %129 = phi i1 [ %101, %116 ], [ %101, %112 ], [ %126, %124 ]
  br i1 %129, label %130, label %168

130:                                              ; preds = %128
  br i1 %21, label %131, label %133

131:                                              ; preds = %130
  %132 = load ptr, ptr %22, align 8
  br label %141

133:                                              ; preds = %158, %97, %130
  %134 = phi double [ 0.000000e+00, %130 ], [ 0.000000e+00, %97 ], [ %165, %158 ]
  %135 = fneg double %134
  %136 = fcmp olt double %95, %135
  %137 = select i1 %136, double %95, double %135
  %138 = fcmp ogt double %137, %91
  %139 = select i1 %138, double %137, double %91
  %140 = select i1 %138, i64 %89, i64 %90
  br label %168

141:                                              ; preds = %131, %158
  %142 = phi i64 [ 0, %131 ], [ %166, %158 ]
  %143 = phi double [ 0.000000e+00, %131 ], [ %165, %158 ]
  %144 = getelementptr inbounds double, ptr %93, i64 %142
  %145 = load double, ptr %144, align 8
  %146 = getelementptr inbounds double, ptr %59, i64 %142
  %147 = load double, ptr %146, align 8
  %148 = getelementptr inbounds i8, ptr %99, i64 %142
  %149 = load i8, ptr %148, align 1
  %150 = fsub double %147, %145
  %151 = icmp eq i8 %149, 0
  br i1 %151, label %158, label %152

152:                                              ; preds = %141
  %153 = fdiv double %150, 0x401921FB54442D18
  %154 = fadd double %153, 5.000000e-01
  %155 = tail call double @llvm.floor.f64(double %154)
  %156 = fmul double %155, 0x401921FB54442D18
  %157 = fsub double %150, %156
  br label %158

158:                                              ; preds = %141, %152
  %159 = phi double [ %157, %152 ], [ %150, %141 ]
  %160 = tail call double @llvm.fabs.f64(double %159)
  %161 = getelementptr inbounds double, ptr %132, i64 %142
  %162 = load double, ptr %161, align 8
  %163 = fdiv double %160, %162
  %164 = fcmp ogt double %163, %143
  %165 = select i1 %164, double %163, double %143
  %166 = add nuw nsw i64 %142, 1
  %167 = icmp eq i64 %166, %10
  br i1 %167, label %133, label %141

168:                                              ; preds = %88, %128, %133
  %169 = phi double [ %139, %133 ], [ %91, %128 ], [ %91, %88 ]
  %170 = phi i64 [ %140, %133 ], [ %90, %128 ], [ %90, %88 ]
  %171 = add nsw i64 %89, 1
  %172 = icmp eq i64 %171, %78
  br i1 %172, label %83, label %88

173:                                              ; preds = %83, %60, %55
  %174 = phi double [ 0xFFF0000000000000, %55 ], [ %63, %60 ], [ %84, %83 ]
  %175 = phi i64 [ -1, %55 ], [ %62, %60 ], [ %85, %83 ]
  %176 = getelementptr inbounds double, ptr %48, i64 %57
  store double %174, ptr %176, align 8
  %177 = trunc i64 %175 to i32
  %178 = getelementptr inbounds i32, ptr %49, i64 %57
  store i32 %177, ptr %178, align 4
  %179 = fcmp ogt double %174, %56
  %180 = select i1 %179, double %174, double %56
  %181 = add nsw i64 %57, 1
  %182 = icmp eq i64 %181, %35
  br i1 %182, label %50, label %55
}

declare double @llvm.fabs.f64(double) #4

declare double @llvm.floor.f64(double) #4

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #5

attributes #0 = { nofree norecurse nosync nounwind memory(argmem: readwrite) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #3 = { nofree norecurse nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #5 = { nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #6 = { nounwind }


