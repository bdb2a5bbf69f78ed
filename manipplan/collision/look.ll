; look.c 2a472a1686d81b50efd1ae1a482125a516a8cacbd4c6a257c4be303c0de12d33: written by make kernel

%struct.Dips = type { ptr, ptr, double, ptr, ptr, double, double, i64 }
%struct.Bracket = type { double, double, double, double, double, double, double, double, i64 }
%struct.Look = type { i64, i64, ptr, ptr, i64, i64, ptr, double, double, double, double, i64, ptr, ptr, ptr, ptr, i64, ptr, ptr, ptr, ptr, ptr }
%struct.Found = type { double, double, i64, i64 }

define dso_local i64 @manipplan_bottoms(ptr nocapture noundef readonly %0, ptr noundef %1, i64 noundef %2, ptr nocapture noundef %3) local_unnamed_addr #0 {
  %5 = alloca double, align 8
  %6 = alloca [64 x double], align 16
  %7 = alloca double, align 8
  %8 = alloca double, align 8
  %9 = alloca i64, align 8
  %10 = icmp sgt i64 %2, 0
  br i1 %10, label %11, label %19

11:                                               ; preds = %4
  %12 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 7
  %13 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 6
  %14 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 1
  %15 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 2
  %16 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 4
  %17 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 3
  %18 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 5
  br label %21

19:                                               ; preds = %157, %4
  %20 = phi i64 [ 0, %4 ], [ %158, %157 ]
  ret i64 %20

21:                                               ; preds = %11, %157
  %22 = phi i64 [ 0, %11 ], [ %158, %157 ]
  %23 = phi i64 [ 0, %11 ], [ %159, %157 ]
  %24 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23
  %25 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 6
  %26 = load double, ptr %25, align 8
  %27 = fcmp uno double %26, 0.000000e+00
  br i1 %27, label %28, label %31

28:                                               ; preds = %21
  %29 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 8
  %30 = load i64, ptr %29, align 8
  br label %56

31:                                               ; preds = %21
  %32 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 7
  %33 = load double, ptr %32, align 8
  %34 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 4
  %35 = load double, ptr %34, align 8
  %36 = fcmp ogt double %35, %33
  %37 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 1
  %38 = load double, ptr %37, align 8
  %39 = fcmp olt double %38, %26
  %40 = select i1 %36, double %38, double %26
  br i1 %36, label %42, label %41

41:                                               ; preds = %31
  br i1 %39, label %46, label %43

42:                                               ; preds = %31
  br i1 %39, label %43, label %46

43:                                               ; preds = %42, %41
  %44 = phi double [ %33, %41 ], [ %35, %42 ]
  store double %40, ptr %24, align 8
  %45 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 3
  store double %44, ptr %45, align 8
  br label %50

46:                                               ; preds = %42, %41
  %47 = phi double [ %33, %41 ], [ %35, %42 ]
  %48 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 2
  store double %40, ptr %48, align 8
  %49 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 5
  store double %47, ptr %49, align 8
  br label %50

50:                                               ; preds = %46, %43
  br i1 %36, label %51, label %52

51:                                               ; preds = %50
  store double %26, ptr %37, align 8
  store double %33, ptr %34, align 8
  br label %52

52:                                               ; preds = %50, %51
  %53 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 8
  %54 = load i64, ptr %53, align 8
  %55 = add nsw i64 %54, 1
  store i64 %55, ptr %53, align 8
  store double 0x7FF8000000000000, ptr %25, align 8
  br label %56

56:                                               ; preds = %28, %52
  %57 = phi i64 [ %30, %28 ], [ %55, %52 ]
  %58 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 8
  %59 = load i64, ptr %12, align 8
  %60 = icmp slt i64 %57, %59
  br i1 %60, label %61, label %157

61:                                               ; preds = %56
  %62 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 2
  %63 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 1
  %64 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 3
  %65 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 4
  %66 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %23, i32 5
  %67 = shl nuw nsw i64 %23, 1
  %68 = getelementptr inbounds i64, ptr %1, i64 %67
  br label %69

69:                                               ; preds = %61, %152
  %70 = phi i64 [ %57, %61 ], [ %154, %152 ]
  %71 = load double, ptr %62, align 8
  %72 = load double, ptr %24, align 8
  %73 = fsub double %71, %72
  %74 = load double, ptr %13, align 8
  %75 = fcmp ult double %73, %74
  br i1 %75, label %157, label %76

76:                                               ; preds = %69
  %77 = load double, ptr %63, align 8
  %78 = fsub double %77, %72
  %79 = fsub double %71, %77
  %80 = fcmp ogt double %78, %79
  %81 = fmul double %78, -5.000000e-01
  %82 = fmul double %79, 5.000000e-01
  %83 = select i1 %80, double %81, double %82
  %84 = load double, ptr %64, align 8
  %85 = load double, ptr %65, align 8
  %86 = fsub double %84, %85
  %87 = fdiv double %86, %78
  %88 = load double, ptr %66, align 8
  %89 = fsub double %88, %85
  %90 = fdiv double %89, %79
  %91 = fmul double %79, %87
  %92 = fmul double %78, %90
  %93 = fsub double %91, %92
  %94 = fadd double %87, %90
  %95 = fmul double %94, 2.000000e+00
  %96 = fdiv double %93, %95
  %97 = call double @llvm.fabs.f64(double %96) #6
  %98 = fcmp one double %97, 0x7FF0000000000000
  %99 = fneg double %78
  %100 = fcmp ogt double %96, %99
  %101 = select i1 %98, i1 %100, i1 false
  %102 = fcmp olt double %96, %79
  %103 = select i1 %101, i1 %102, i1 false
  br i1 %103, label %104, label %108

104:                                              ; preds = %76
  %105 = srem i64 %70, 3
  %106 = icmp slt i64 %105, 2
  %107 = select i1 %106, double %96, double %83
  br label %108

108:                                              ; preds = %76, %104
  %109 = phi double [ %83, %76 ], [ %107, %104 ]
  %110 = fadd double %78, %79
  %111 = fmul double %110, 2.000000e-02
  %112 = fmul double %74, 2.500000e-01
  %113 = call double @llvm.maxnum.f64(double %111, double %112)
  %114 = call double @llvm.fabs.f64(double %109)
  %115 = fcmp olt double %114, %113
  %116 = call double @llvm.copysign.f64(double %113, double %83)
  %117 = select i1 %115, double %116, double %109
  %118 = fadd double %77, %117
  %119 = call double @llvm.maxnum.f64(double %118, double %72)
  %120 = call double @llvm.minnum.f64(double %119, double %71)
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %5)
  store double %120, ptr %5, align 8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %6) #7
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %7) #7
  store double 0x7FF0000000000000, ptr %7, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %8) #7
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %9) #7
  %121 = load ptr, ptr %14, align 8
  %122 = load ptr, ptr %0, align 8
  %123 = load double, ptr %15, align 8
  %124 = call i64 %121(ptr noundef %122, ptr noundef nonnull %5, i64 noundef 1, double noundef %123, ptr noundef nonnull %6) #7
  %125 = icmp eq i64 %124, 0
  br i1 %125, label %127, label %126

126:                                              ; preds = %108
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %7) #7
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %5)
  br label %136

127:                                              ; preds = %108
  %128 = load ptr, ptr %16, align 8
  %129 = load ptr, ptr %17, align 8
  call void %128(ptr noundef %129, ptr noundef nonnull %6, i64 noundef 1, ptr noundef %68, ptr noundef nonnull %7, ptr noundef nonnull %8, ptr noundef nonnull %9) #7
  %130 = load double, ptr %8, align 8
  %131 = load double, ptr %18, align 8
  %132 = fdiv double %130, %131
  %133 = call double @llvm.rint.f64(double %132)
  %134 = fmul double %131, %133
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %7) #7
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %5)
  %135 = fcmp uno double %134, 0.000000e+00
  br i1 %135, label %136, label %138

136:                                              ; preds = %127, %126
  store double %120, ptr %25, align 8
  %137 = add nsw i64 %22, 1
  br label %157

138:                                              ; preds = %127
  %139 = load double, ptr %65, align 8
  %140 = fcmp ogt double %139, %134
  %141 = load double, ptr %63, align 8
  %142 = fcmp olt double %141, %120
  %143 = select i1 %140, double %141, double %120
  br i1 %140, label %145, label %144

144:                                              ; preds = %138
  br i1 %142, label %148, label %146

145:                                              ; preds = %138
  br i1 %142, label %146, label %148

146:                                              ; preds = %145, %144
  %147 = phi double [ %134, %144 ], [ %139, %145 ]
  store double %143, ptr %24, align 8
  store double %147, ptr %64, align 8
  br label %150

148:                                              ; preds = %145, %144
  %149 = phi double [ %134, %144 ], [ %139, %145 ]
  store double %143, ptr %62, align 8
  store double %149, ptr %66, align 8
  br label %150

150:                                              ; preds = %148, %146
  br i1 %140, label %151, label %152

151:                                              ; preds = %150
  store double %120, ptr %63, align 8
  store double %134, ptr %65, align 8
  br label %152

152:                                              ; preds = %151, %150
  %153 = load i64, ptr %58, align 8
  %154 = add nsw i64 %153, 1
  store i64 %154, ptr %58, align 8
  %155 = load i64, ptr %12, align 8
  %156 = icmp slt i64 %154, %155
  br i1 %156, label %69, label %157

157:                                              ; preds = %69, %152, %56, %136
  %158 = phi i64 [ %137, %136 ], [ %22, %56 ], [ %22, %152 ], [ %22, %69 ]
  %159 = add nuw nsw i64 %23, 1
  %160 = icmp eq i64 %159, %2
  br i1 %160, label %19, label %21
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

define dso_local i64 @manipplan_look(ptr nocapture noundef readonly %0, ptr noundef readonly %1, double noundef %2, ptr noundef %3) local_unnamed_addr #0 {
  %5 = alloca double, align 8
  %6 = alloca [64 x double], align 16
  %7 = alloca double, align 8
  %8 = alloca double, align 8
  %9 = alloca i64, align 8
  %10 = alloca double, align 8
  %11 = alloca [64 x double], align 16
  %12 = alloca double, align 8
  %13 = alloca double, align 8
  %14 = alloca i64, align 8
  %15 = alloca double, align 8
  %16 = alloca [64 x double], align 16
  %17 = alloca double, align 8
  %18 = alloca double, align 8
  %19 = alloca i64, align 8
  %20 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 4
  %21 = load i64, ptr %20, align 8
  %22 = icmp sgt i64 %21, 0
  br i1 %22, label %23, label %30

23:                                               ; preds = %4
  %24 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 7
  %25 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 5
  %26 = load i64, ptr %25, align 8
  %27 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 10
  %28 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 15
  %29 = load ptr, ptr %28, align 8
  br label %151

30:                                               ; preds = %151, %4
  %31 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 1
  %32 = load ptr, ptr %31, align 8
  %33 = load ptr, ptr %0, align 8
  %34 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 6
  %35 = load ptr, ptr %34, align 8
  %36 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 2
  %37 = load double, ptr %36, align 8
  %38 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 14
  %39 = load ptr, ptr %38, align 8
  %40 = tail call i64 %32(ptr noundef %33, ptr noundef %35, i64 noundef %21, double noundef %37, ptr noundef %39) #7
  %41 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 3
  %42 = load ptr, ptr %41, align 8
  %43 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 3
  %44 = load ptr, ptr %43, align 8
  %45 = load ptr, ptr %38, align 8
  %46 = load i64, ptr %20, align 8
  %47 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 15
  %48 = load ptr, ptr %47, align 8
  %49 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 16
  %50 = load i64, ptr %49, align 8
  %51 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 17
  %52 = load ptr, ptr %51, align 8
  %53 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 18
  %54 = load ptr, ptr %53, align 8
  %55 = tail call i64 %42(ptr noundef %44, ptr noundef %45, i64 noundef %46, ptr noundef %48, i64 noundef %50, ptr noundef %52, ptr noundef %54) #7
  %56 = load i64, ptr %49, align 8
  %57 = icmp sgt i64 %55, %56
  br i1 %57, label %510, label %58

58:                                               ; preds = %30
  %59 = icmp sgt i64 %55, 0
  br i1 %59, label %60, label %295

60:                                               ; preds = %58
  %61 = load ptr, ptr %53, align 8
  %62 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  %63 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 5
  br label %66

64:                                               ; preds = %90
  %65 = icmp sgt i64 %91, 0
  br i1 %65, label %94, label %142

66:                                               ; preds = %90, %60
  %67 = phi i64 [ 0, %60 ], [ %92, %90 ]
  %68 = phi i64 [ 0, %60 ], [ %91, %90 ]
  %69 = getelementptr inbounds double, ptr %61, i64 %67
  %70 = load double, ptr %69, align 8
  %71 = fcmp uno double %70, 0.000000e+00
  br i1 %71, label %510, label %72

72:                                               ; preds = %66
  %73 = load ptr, ptr %47, align 8
  %74 = load ptr, ptr %51, align 8
  %75 = getelementptr inbounds i64, ptr %74, i64 %67
  %76 = load i64, ptr %75, align 8
  %77 = load i64, ptr %62, align 8
  %78 = sdiv i64 %76, %77
  %79 = getelementptr inbounds double, ptr %73, i64 %78
  %80 = load double, ptr %79, align 8
  %81 = fcmp ult double %70, %80
  br i1 %81, label %82, label %90

82:                                               ; preds = %72
  %83 = getelementptr inbounds i64, ptr %74, i64 %68
  store i64 %76, ptr %83, align 8
  %84 = load double, ptr %63, align 8
  %85 = fdiv double %70, %84
  %86 = tail call double @llvm.rint.f64(double %85)
  %87 = fmul double %84, %86
  %88 = add nsw i64 %68, 1
  %89 = getelementptr inbounds double, ptr %61, i64 %68
  store double %87, ptr %89, align 8
  br label %90

90:                                               ; preds = %82, %72
  %91 = phi i64 [ %68, %72 ], [ %88, %82 ]
  %92 = add nuw nsw i64 %67, 1
  %93 = icmp eq i64 %92, %55
  br i1 %93, label %64, label %66

94:                                               ; preds = %64, %139
  %95 = phi i64 [ %140, %139 ], [ 0, %64 ]
  %96 = getelementptr inbounds i64, ptr %74, i64 %95
  %97 = load i64, ptr %96, align 8
  %98 = load i64, ptr %62, align 8
  %99 = sdiv i64 %97, %98
  %100 = icmp slt i64 %95, %91
  br i1 %100, label %101, label %139

101:                                              ; preds = %94, %107
  %102 = phi i64 [ %108, %107 ], [ %95, %94 ]
  %103 = getelementptr inbounds i64, ptr %74, i64 %102
  %104 = load i64, ptr %103, align 8
  %105 = sdiv i64 %104, %98
  %106 = icmp eq i64 %105, %99
  br i1 %106, label %107, label %110

107:                                              ; preds = %101
  %108 = add i64 %102, 1
  %109 = icmp eq i64 %108, %91
  br i1 %109, label %110, label %101

110:                                              ; preds = %107, %101
  %111 = phi i64 [ %102, %101 ], [ %91, %107 ]
  %112 = add nsw i64 %95, 1
  %113 = icmp slt i64 %112, %111
  br i1 %113, label %114, label %139

114:                                              ; preds = %110, %133
  %115 = phi i64 [ %137, %133 ], [ %112, %110 ]
  %116 = getelementptr inbounds i64, ptr %74, i64 %115
  %117 = load i64, ptr %116, align 8
  %118 = getelementptr inbounds double, ptr %61, i64 %115
  %119 = load double, ptr %118, align 8
  %120 = icmp sgt i64 %115, %95
  br i1 %120, label %121, label %133

121:                                              ; preds = %114, %127
  %122 = phi i64 [ %123, %127 ], [ %115, %114 ]
  %123 = add nsw i64 %122, -1
  %124 = getelementptr inbounds i64, ptr %74, i64 %123
  %125 = load i64, ptr %124, align 8
  %126 = icmp sgt i64 %125, %117
  br i1 %126, label %127, label %133

127:                                              ; preds = %121
  %128 = getelementptr inbounds i64, ptr %74, i64 %122
  store i64 %125, ptr %128, align 8
  %129 = getelementptr inbounds double, ptr %61, i64 %123
  %130 = load double, ptr %129, align 8
  %131 = getelementptr inbounds double, ptr %61, i64 %122
  store double %130, ptr %131, align 8
  %132 = icmp sgt i64 %123, %95
  br i1 %132, label %121, label %133

133:                                              ; preds = %127, %121, %114
  %134 = phi i64 [ %115, %114 ], [ %95, %127 ], [ %122, %121 ]
  %135 = getelementptr inbounds i64, ptr %74, i64 %134
  store i64 %117, ptr %135, align 8
  %136 = getelementptr inbounds double, ptr %61, i64 %134
  store double %119, ptr %136, align 8
  %137 = add nsw i64 %115, 1
  %138 = icmp eq i64 %137, %111
  br i1 %138, label %139, label %114

139:                                              ; preds = %133, %110, %94
  %140 = phi i64 [ %111, %110 ], [ %95, %94 ], [ %111, %133 ]
  %141 = icmp slt i64 %140, %91
  br i1 %141, label %94, label %142

142:                                              ; preds = %139, %64
  %143 = icmp slt i64 %91, 0
  br i1 %143, label %510, label %144

144:                                              ; preds = %142
  %145 = icmp eq i64 %91, 0
  br i1 %145, label %295, label %146

146:                                              ; preds = %144
  %147 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  %148 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 7
  %149 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 8
  %150 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 5
  br label %306

151:                                              ; preds = %23, %151
  %152 = phi i64 [ 0, %23 ], [ %164, %151 ]
  %153 = load double, ptr %24, align 8
  %154 = srem i64 %152, %26
  %155 = icmp eq i64 %154, 0
  %156 = load double, ptr %27, align 8
  %157 = fcmp olt double %156, %2
  %158 = select i1 %155, i1 %157, i1 false
  %159 = select i1 %158, double %2, double %156
  %160 = fadd double %153, %159
  %161 = fcmp ogt double %160, 0.000000e+00
  %162 = select i1 %161, double %160, double 0.000000e+00
  %163 = getelementptr inbounds double, ptr %29, i64 %152
  store double %162, ptr %163, align 8
  %164 = add nuw nsw i64 %152, 1
  %165 = icmp eq i64 %164, %21
  br i1 %165, label %30, label %151

166:                                              ; preds = %338
  %167 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 7
  %168 = load double, ptr %167, align 8
  %169 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 10
  %170 = load double, ptr %169, align 8
  %171 = fadd double %168, %170
  %172 = icmp sgt i64 %91, 0
  br i1 %172, label %173, label %295

173:                                              ; preds = %166
  %174 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 1
  %175 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 9
  %176 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %177 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %178 = load ptr, ptr %51, align 8
  br label %179

179:                                              ; preds = %290, %173
  %180 = phi ptr [ %178, %173 ], [ %291, %290 ]
  %181 = phi i64 [ 0, %173 ], [ %292, %290 ]
  %182 = phi i64 [ 0, %173 ], [ %293, %290 ]
  %183 = phi i64 [ 0, %173 ], [ %240, %290 ]
  %184 = phi i64 [ 0, %173 ], [ %214, %290 ]
  %185 = getelementptr inbounds i64, ptr %180, i64 %182
  %186 = load i64, ptr %185, align 8
  %187 = load i64, ptr %174, align 8
  %188 = sdiv i64 %186, %187
  %189 = load i64, ptr %20, align 8
  %190 = add nsw i64 %189, -1
  %191 = load ptr, ptr %53, align 8
  %192 = getelementptr inbounds double, ptr %191, i64 %182
  %193 = load double, ptr %192, align 8
  %194 = tail call double @llvm.minnum.f64(double %193, double %171)
  %195 = icmp sgt i64 %188, 0
  br i1 %195, label %196, label %213

196:                                              ; preds = %179
  %197 = sub nsw i64 %186, %187
  %198 = icmp slt i64 %184, %182
  br i1 %198, label %199, label %213

199:                                              ; preds = %196, %204
  %200 = phi i64 [ %205, %204 ], [ %184, %196 ]
  %201 = getelementptr inbounds i64, ptr %180, i64 %200
  %202 = load i64, ptr %201, align 8
  %203 = icmp slt i64 %202, %197
  br i1 %203, label %204, label %207

204:                                              ; preds = %199
  %205 = add i64 %200, 1
  %206 = icmp eq i64 %205, %182
  br i1 %206, label %213, label %199

207:                                              ; preds = %199
  %208 = icmp eq i64 %202, %197
  br i1 %208, label %209, label %213

209:                                              ; preds = %207
  %210 = getelementptr inbounds double, ptr %191, i64 %200
  %211 = load double, ptr %210, align 8
  %212 = tail call double @llvm.minnum.f64(double %211, double %171)
  br label %213

213:                                              ; preds = %204, %209, %207, %196, %179
  %214 = phi i64 [ %184, %179 ], [ %200, %209 ], [ %200, %207 ], [ %184, %196 ], [ %182, %204 ]
  %215 = phi double [ 0xFFF0000000000000, %179 ], [ %212, %209 ], [ %171, %207 ], [ %171, %196 ], [ %171, %204 ]
  %216 = phi double [ 0x7FF0000000000000, %179 ], [ %212, %209 ], [ %171, %207 ], [ %171, %196 ], [ %171, %204 ]
  %217 = icmp slt i64 %188, %190
  br i1 %217, label %218, label %239

218:                                              ; preds = %213
  %219 = add nsw i64 %187, %186
  %220 = icmp slt i64 %183, %91
  br i1 %220, label %221, label %235

221:                                              ; preds = %218, %226
  %222 = phi i64 [ %227, %226 ], [ %183, %218 ]
  %223 = getelementptr inbounds i64, ptr %180, i64 %222
  %224 = load i64, ptr %223, align 8
  %225 = icmp slt i64 %224, %219
  br i1 %225, label %226, label %229

226:                                              ; preds = %221
  %227 = add i64 %222, 1
  %228 = icmp eq i64 %227, %91
  br i1 %228, label %235, label %221

229:                                              ; preds = %221
  %230 = icmp eq i64 %224, %219
  br i1 %230, label %231, label %235

231:                                              ; preds = %229
  %232 = getelementptr inbounds double, ptr %191, i64 %222
  %233 = load double, ptr %232, align 8
  %234 = tail call double @llvm.minnum.f64(double %233, double %171)
  br label %235

235:                                              ; preds = %226, %231, %229, %218
  %236 = phi i64 [ %222, %231 ], [ %222, %229 ], [ %183, %218 ], [ %91, %226 ]
  %237 = phi double [ %234, %231 ], [ %171, %229 ], [ %171, %218 ], [ %171, %226 ]
  %238 = tail call double @llvm.maxnum.f64(double %215, double %237)
  br label %239

239:                                              ; preds = %235, %213
  %240 = phi i64 [ %236, %235 ], [ %183, %213 ]
  %241 = phi double [ %238, %235 ], [ %215, %213 ]
  %242 = phi double [ %237, %235 ], [ 0x7FF0000000000000, %213 ]
  %243 = fcmp oge double %216, %194
  %244 = fcmp ogt double %242, %194
  %245 = select i1 %243, i1 %244, i1 false
  br i1 %245, label %246, label %290

246:                                              ; preds = %239
  %247 = fsub double %241, %194
  %248 = fsub double %194, %247
  %249 = load double, ptr %167, align 8
  %250 = load double, ptr %175, align 8
  %251 = fadd double %249, %250
  %252 = fcmp olt double %248, %251
  br i1 %252, label %253, label %290

253:                                              ; preds = %246
  %254 = load ptr, ptr %34, align 8
  %255 = add nsw i64 %188, -1
  %256 = select i1 %195, i64 %255, i64 0
  %257 = getelementptr inbounds double, ptr %254, i64 %256
  %258 = load double, ptr %257, align 8
  %259 = getelementptr inbounds double, ptr %254, i64 %188
  %260 = load double, ptr %259, align 8
  %261 = add nsw i64 %188, 1
  %262 = select i1 %217, i64 %261, i64 %190
  %263 = getelementptr inbounds double, ptr %254, i64 %262
  %264 = load double, ptr %263, align 8
  %265 = icmp eq i64 %188, 0
  %266 = fcmp olt double %216, %171
  %267 = select i1 %266, double %216, double 0x7FF8000000000000
  %268 = select i1 %265, double %194, double %267
  %269 = icmp eq i64 %188, %190
  %270 = fcmp olt double %242, %171
  %271 = select i1 %270, double %242, double 0x7FF8000000000000
  %272 = select i1 %269, double %194, double %271
  %273 = load ptr, ptr %176, align 8
  %274 = getelementptr inbounds %struct.Bracket, ptr %273, i64 %181
  store double %258, ptr %274, align 8
  %275 = getelementptr inbounds i8, ptr %274, i64 8
  store double %260, ptr %275, align 8
  %276 = getelementptr inbounds i8, ptr %274, i64 16
  store double %264, ptr %276, align 8
  %277 = getelementptr inbounds i8, ptr %274, i64 24
  store double %268, ptr %277, align 8
  %278 = getelementptr inbounds i8, ptr %274, i64 32
  store double %194, ptr %278, align 8
  %279 = getelementptr inbounds i8, ptr %274, i64 40
  store double %272, ptr %279, align 8
  %280 = getelementptr inbounds i8, ptr %274, i64 48
  store double 0x7FF8000000000000, ptr %280, align 8
  %281 = getelementptr inbounds i8, ptr %274, i64 56
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %281, i8 0, i64 16, i1 false)
  %282 = load ptr, ptr %51, align 8
  %283 = getelementptr inbounds i64, ptr %282, i64 %182
  %284 = load i64, ptr %283, align 8
  %285 = load i64, ptr %174, align 8
  %286 = srem i64 %284, %285
  %287 = load ptr, ptr %177, align 8
  %288 = add nsw i64 %181, 1
  %289 = getelementptr inbounds i64, ptr %287, i64 %181
  store i64 %286, ptr %289, align 8
  br label %290

290:                                              ; preds = %253, %246, %239
  %291 = phi ptr [ %282, %253 ], [ %180, %246 ], [ %180, %239 ]
  %292 = phi i64 [ %288, %253 ], [ %181, %246 ], [ %181, %239 ]
  %293 = add nuw nsw i64 %182, 1
  %294 = icmp eq i64 %293, %91
  br i1 %294, label %295, label %179

295:                                              ; preds = %290, %58, %144, %166
  %296 = phi i64 [ %339, %166 ], [ 0, %144 ], [ 0, %58 ], [ %339, %290 ]
  %297 = phi i64 [ 0, %166 ], [ 0, %144 ], [ 0, %58 ], [ %292, %290 ]
  %298 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 11
  %299 = load i64, ptr %298, align 8
  %300 = icmp sgt i64 %299, 0
  br i1 %300, label %301, label %342

301:                                              ; preds = %295
  %302 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 12
  %303 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %304 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 13
  %305 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  br label %352

306:                                              ; preds = %146, %338
  %307 = phi i64 [ 0, %146 ], [ %339, %338 ]
  %308 = phi i64 [ 0, %146 ], [ %340, %338 ]
  %309 = load ptr, ptr %51, align 8
  %310 = getelementptr inbounds i64, ptr %309, i64 %308
  %311 = load i64, ptr %310, align 8
  %312 = load i64, ptr %147, align 8
  %313 = sdiv i64 %311, %312
  %314 = srem i64 %311, %312
  %315 = load ptr, ptr %53, align 8
  %316 = getelementptr inbounds double, ptr %315, i64 %308
  %317 = load double, ptr %316, align 8
  %318 = load double, ptr %148, align 8
  %319 = load double, ptr %149, align 8
  %320 = fadd double %318, %319
  %321 = fcmp olt double %317, %320
  br i1 %321, label %329, label %322

322:                                              ; preds = %306
  %323 = load i64, ptr %150, align 8
  %324 = srem i64 %313, %323
  %325 = icmp eq i64 %324, 0
  %326 = fadd double %318, %2
  %327 = fcmp olt double %317, %326
  %328 = select i1 %325, i1 %327, i1 false
  br i1 %328, label %329, label %338

329:                                              ; preds = %322, %306
  %330 = load ptr, ptr %34, align 8
  %331 = getelementptr inbounds double, ptr %330, i64 %313
  %332 = load double, ptr %331, align 8
  %333 = add nsw i64 %307, 1
  %334 = getelementptr inbounds %struct.Found, ptr %3, i64 %307
  store double %317, ptr %334, align 8
  %335 = getelementptr inbounds i8, ptr %334, i64 8
  store double %332, ptr %335, align 8
  %336 = getelementptr inbounds i8, ptr %334, i64 16
  store i64 %314, ptr %336, align 8
  %337 = getelementptr inbounds i8, ptr %334, i64 24
  store i64 0, ptr %337, align 8
  br label %338

338:                                              ; preds = %322, %329
  %339 = phi i64 [ %333, %329 ], [ %307, %322 ]
  %340 = add nuw nsw i64 %308, 1
  %341 = icmp eq i64 %340, %91
  br i1 %341, label %166, label %306

342:                                              ; preds = %352, %295
  %343 = phi i64 [ %297, %295 ], [ %379, %352 ]
  %344 = icmp sgt i64 %343, 0
  br i1 %344, label %345, label %480

345:                                              ; preds = %342
  %346 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 21
  %347 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 2
  %348 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  %349 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %350 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 4
  %351 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 5
  br label %387

352:                                              ; preds = %301, %352
  %353 = phi i64 [ %297, %301 ], [ %379, %352 ]
  %354 = phi i64 [ 0, %301 ], [ %381, %352 ]
  %355 = load ptr, ptr %302, align 8
  %356 = getelementptr inbounds double, ptr %355, i64 %354
  %357 = load double, ptr %356, align 8
  %358 = load i64, ptr %20, align 8
  %359 = add nsw i64 %358, -1
  %360 = sitofp i64 %359 to double
  %361 = fdiv double 1.000000e+00, %360
  %362 = fsub double %357, %361
  %363 = tail call double @llvm.maxnum.f64(double %362, double 0.000000e+00)
  %364 = fadd double %357, %361
  %365 = tail call double @llvm.minnum.f64(double %364, double 1.000000e+00)
  %366 = load ptr, ptr %303, align 8
  %367 = getelementptr inbounds %struct.Bracket, ptr %366, i64 %353
  store double %363, ptr %367, align 8
  %368 = getelementptr inbounds i8, ptr %367, i64 8
  store double %357, ptr %368, align 8
  %369 = getelementptr inbounds i8, ptr %367, i64 16
  store double %365, ptr %369, align 8
  %370 = getelementptr inbounds i8, ptr %367, i64 24
  store double 0x7FF8000000000000, ptr %370, align 8
  %371 = getelementptr inbounds i8, ptr %367, i64 32
  store double 0x7FF8000000000000, ptr %371, align 8
  %372 = getelementptr inbounds i8, ptr %367, i64 40
  store double 0x7FF8000000000000, ptr %372, align 8
  %373 = getelementptr inbounds i8, ptr %367, i64 48
  store double 0x7FF8000000000000, ptr %373, align 8
  %374 = getelementptr inbounds i8, ptr %367, i64 56
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %374, i8 0, i64 16, i1 false)
  %375 = load ptr, ptr %304, align 8
  %376 = getelementptr inbounds i64, ptr %375, i64 %354
  %377 = load i64, ptr %376, align 8
  %378 = load ptr, ptr %305, align 8
  %379 = add nsw i64 %353, 1
  %380 = getelementptr inbounds i64, ptr %378, i64 %353
  store i64 %377, ptr %380, align 8
  %381 = add nuw nsw i64 %354, 1
  %382 = load i64, ptr %298, align 8
  %383 = icmp slt i64 %381, %382
  br i1 %383, label %352, label %342

384:                                              ; preds = %475
  %385 = add nuw nsw i64 %388, 1
  %386 = icmp eq i64 %385, %343
  br i1 %386, label %480, label %387

387:                                              ; preds = %345, %384
  %388 = phi i64 [ 0, %345 ], [ %385, %384 ]
  %389 = load ptr, ptr %346, align 8
  %390 = shl nuw nsw i64 %388, 1
  %391 = getelementptr inbounds i64, ptr %389, i64 %390
  %392 = load ptr, ptr %347, align 8
  %393 = load ptr, ptr %348, align 8
  %394 = getelementptr inbounds i64, ptr %393, i64 %388
  %395 = load i64, ptr %394, align 8
  %396 = shl nsw i64 %395, 1
  %397 = getelementptr inbounds i64, ptr %392, i64 %396
  %398 = load i64, ptr %397, align 8
  store i64 %398, ptr %391, align 8
  %399 = load i64, ptr %394, align 8
  %400 = shl nsw i64 %399, 1
  %401 = or i64 %400, 1
  %402 = getelementptr inbounds i64, ptr %392, i64 %401
  %403 = load i64, ptr %402, align 8
  %404 = getelementptr inbounds i64, ptr %391, i64 1
  store i64 %403, ptr %404, align 8
  %405 = load ptr, ptr %349, align 8
  %406 = getelementptr inbounds %struct.Bracket, ptr %405, i64 %388
  %407 = getelementptr inbounds %struct.Bracket, ptr %405, i64 %388, i32 4
  %408 = load double, ptr %407, align 8
  %409 = fcmp uno double %408, 0.000000e+00
  br i1 %409, label %410, label %428

410:                                              ; preds = %387
  %411 = getelementptr inbounds %struct.Bracket, ptr %405, i64 %388, i32 1
  %412 = load double, ptr %411, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %5)
  store double %412, ptr %5, align 8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %6) #7
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %7) #7
  store double 0x7FF0000000000000, ptr %7, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %8) #7
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %9) #7
  %413 = load ptr, ptr %31, align 8
  %414 = load ptr, ptr %0, align 8
  %415 = load double, ptr %36, align 8
  %416 = call i64 %413(ptr noundef %414, ptr noundef nonnull %5, i64 noundef 1, double noundef %415, ptr noundef nonnull %6) #7
  %417 = icmp eq i64 %416, 0
  br i1 %417, label %418, label %426

418:                                              ; preds = %410
  %419 = load ptr, ptr %350, align 8
  %420 = load ptr, ptr %43, align 8
  call void %419(ptr noundef %420, ptr noundef nonnull %6, i64 noundef 1, ptr noundef nonnull %391, ptr noundef nonnull %7, ptr noundef nonnull %8, ptr noundef nonnull %9) #7
  %421 = load double, ptr %8, align 8
  %422 = load double, ptr %351, align 8
  %423 = fdiv double %421, %422
  %424 = call double @llvm.rint.f64(double %423)
  %425 = fmul double %422, %424
  br label %426

426:                                              ; preds = %410, %418
  %427 = phi double [ %425, %418 ], [ 0x7FF8000000000000, %410 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %7) #7
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %5)
  store double %427, ptr %407, align 8
  br label %428

428:                                              ; preds = %426, %387
  %429 = getelementptr inbounds %struct.Bracket, ptr %405, i64 %388, i32 3
  %430 = load double, ptr %429, align 8
  %431 = fcmp uno double %430, 0.000000e+00
  br i1 %431, label %432, label %449

432:                                              ; preds = %428
  %433 = load double, ptr %406, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %10)
  store double %433, ptr %10, align 8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %11) #7
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %12) #7
  store double 0x7FF0000000000000, ptr %12, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %13) #7
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %14) #7
  %434 = load ptr, ptr %31, align 8
  %435 = load ptr, ptr %0, align 8
  %436 = load double, ptr %36, align 8
  %437 = call i64 %434(ptr noundef %435, ptr noundef nonnull %10, i64 noundef 1, double noundef %436, ptr noundef nonnull %11) #7
  %438 = icmp eq i64 %437, 0
  br i1 %438, label %439, label %447

439:                                              ; preds = %432
  %440 = load ptr, ptr %350, align 8
  %441 = load ptr, ptr %43, align 8
  call void %440(ptr noundef %441, ptr noundef nonnull %11, i64 noundef 1, ptr noundef nonnull %391, ptr noundef nonnull %12, ptr noundef nonnull %13, ptr noundef nonnull %14) #7
  %442 = load double, ptr %13, align 8
  %443 = load double, ptr %351, align 8
  %444 = fdiv double %442, %443
  %445 = call double @llvm.rint.f64(double %444)
  %446 = fmul double %443, %445
  br label %447

447:                                              ; preds = %432, %439
  %448 = phi double [ %446, %439 ], [ 0x7FF8000000000000, %432 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %14) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %13) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %12) #7
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %11) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %10)
  store double %448, ptr %429, align 8
  br label %449

449:                                              ; preds = %447, %428
  %450 = getelementptr inbounds %struct.Bracket, ptr %405, i64 %388, i32 5
  %451 = load double, ptr %450, align 8
  %452 = fcmp uno double %451, 0.000000e+00
  br i1 %452, label %453, label %471

453:                                              ; preds = %449
  %454 = getelementptr inbounds %struct.Bracket, ptr %405, i64 %388, i32 2
  %455 = load double, ptr %454, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %15)
  store double %455, ptr %15, align 8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %16) #7
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %17) #7
  store double 0x7FF0000000000000, ptr %17, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %18) #7
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %19) #7
  %456 = load ptr, ptr %31, align 8
  %457 = load ptr, ptr %0, align 8
  %458 = load double, ptr %36, align 8
  %459 = call i64 %456(ptr noundef %457, ptr noundef nonnull %15, i64 noundef 1, double noundef %458, ptr noundef nonnull %16) #7
  %460 = icmp eq i64 %459, 0
  br i1 %460, label %461, label %469

461:                                              ; preds = %453
  %462 = load ptr, ptr %350, align 8
  %463 = load ptr, ptr %43, align 8
  call void %462(ptr noundef %463, ptr noundef nonnull %16, i64 noundef 1, ptr noundef nonnull %391, ptr noundef nonnull %17, ptr noundef nonnull %18, ptr noundef nonnull %19) #7
  %464 = load double, ptr %18, align 8
  %465 = load double, ptr %351, align 8
  %466 = fdiv double %464, %465
  %467 = call double @llvm.rint.f64(double %466)
  %468 = fmul double %465, %467
  br label %469

469:                                              ; preds = %453, %461
  %470 = phi double [ %468, %461 ], [ 0x7FF8000000000000, %453 ]
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %19) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %18) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %17) #7
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %16) #7
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %15)
  store double %470, ptr %450, align 8
  br label %471

471:                                              ; preds = %469, %449
  %472 = phi double [ %470, %469 ], [ %451, %449 ]
  %473 = load double, ptr %407, align 8
  %474 = fcmp uno double %473, 0.000000e+00
  br i1 %474, label %510, label %475

475:                                              ; preds = %471
  %476 = load double, ptr %429, align 8
  %477 = fcmp uno double %476, 0.000000e+00
  %478 = fcmp uno double %472, 0.000000e+00
  %479 = select i1 %477, i1 true, i1 %478
  br i1 %479, label %510, label %384

480:                                              ; preds = %384, %342
  %481 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 21
  %482 = load ptr, ptr %481, align 8
  %483 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 19
  %484 = load ptr, ptr %483, align 8
  %485 = call i64 @manipplan_bottoms(ptr noundef nonnull %0, ptr noundef %482, i64 noundef %343, ptr noundef %484)
  %486 = icmp eq i64 %485, 0
  br i1 %486, label %487, label %510

487:                                              ; preds = %480
  br i1 %344, label %488, label %490

488:                                              ; preds = %487
  %489 = getelementptr inbounds %struct.Look, ptr %1, i64 0, i32 20
  br label %492

490:                                              ; preds = %492, %487
  %491 = phi i64 [ %296, %487 ], [ %503, %492 ]
  call void @qsort(ptr noundef %3, i64 noundef %491, i64 noundef 32, ptr noundef nonnull @order) #7
  br label %510

492:                                              ; preds = %488, %492
  %493 = phi i64 [ %296, %488 ], [ %503, %492 ]
  %494 = phi i64 [ 0, %488 ], [ %508, %492 ]
  %495 = load ptr, ptr %483, align 8
  %496 = getelementptr inbounds %struct.Bracket, ptr %495, i64 %494, i32 4
  %497 = load double, ptr %496, align 8
  %498 = getelementptr inbounds %struct.Bracket, ptr %495, i64 %494, i32 1
  %499 = load double, ptr %498, align 8
  %500 = load ptr, ptr %489, align 8
  %501 = getelementptr inbounds i64, ptr %500, i64 %494
  %502 = load i64, ptr %501, align 8
  %503 = add nsw i64 %493, 1
  %504 = getelementptr inbounds %struct.Found, ptr %3, i64 %493
  store double %497, ptr %504, align 8
  %505 = getelementptr inbounds i8, ptr %504, i64 8
  store double %499, ptr %505, align 8
  %506 = getelementptr inbounds i8, ptr %504, i64 16
  store i64 %502, ptr %506, align 8
  %507 = getelementptr inbounds i8, ptr %504, i64 24
  store i64 1, ptr %507, align 8
  %508 = add nuw nsw i64 %494, 1
  %509 = icmp eq i64 %508, %343
  br i1 %509, label %490, label %492

510:                                              ; preds = %66, %471, %475, %30, %490, %480, %142
  %511 = phi i64 [ %91, %142 ], [ %491, %490 ], [ -1, %480 ], [ -2, %30 ], [ -1, %475 ], [ -1, %471 ], [ -1, %66 ]
  ret i64 %511
}

declare double @llvm.maxnum.f64(double, double) #2

declare double @llvm.minnum.f64(double, double) #2

declare void @qsort(ptr noundef, i64 noundef, i64 noundef, ptr nocapture noundef) local_unnamed_addr #3

define internal i32 @order(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1) #4 {
  %3 = load double, ptr %0, align 8
  %4 = load double, ptr %1, align 8
  %5 = fcmp une double %3, %4
  br i1 %5, label %6, label %9

6:                                                ; preds = %2
  %7 = fcmp olt double %3, %4
  %8 = select i1 %7, i32 -1, i32 1
  br label %34

9:                                                ; preds = %2
  %10 = getelementptr inbounds %struct.Found, ptr %0, i64 0, i32 1
  %11 = load double, ptr %10, align 8
  %12 = getelementptr inbounds %struct.Found, ptr %1, i64 0, i32 1
  %13 = load double, ptr %12, align 8
  %14 = fcmp une double %11, %13
  br i1 %14, label %15, label %18

15:                                               ; preds = %9
  %16 = fcmp olt double %11, %13
  %17 = select i1 %16, i32 -1, i32 1
  br label %34

18:                                               ; preds = %9
  %19 = getelementptr inbounds %struct.Found, ptr %0, i64 0, i32 2
  %20 = load i64, ptr %19, align 8
  %21 = getelementptr inbounds %struct.Found, ptr %1, i64 0, i32 2
  %22 = load i64, ptr %21, align 8
  %23 = icmp eq i64 %20, %22
  br i1 %23, label %27, label %24

24:                                               ; preds = %18
  %25 = icmp slt i64 %20, %22
  %26 = select i1 %25, i32 -1, i32 1
  br label %34

27:                                               ; preds = %18
  %28 = getelementptr inbounds %struct.Found, ptr %0, i64 0, i32 3
  %29 = load i64, ptr %28, align 8
  %30 = getelementptr inbounds %struct.Found, ptr %1, i64 0, i32 3
  %31 = load i64, ptr %30, align 8
  %32 = sub nsw i64 %29, %31
  %33 = trunc i64 %32 to i32
  br label %34

34:                                               ; preds = %27, %24, %15, %6
  %35 = phi i32 [ %8, %6 ], [ %17, %15 ], [ %26, %24 ], [ %33, %27 ]
  ret i32 %35
}

declare double @llvm.fabs.f64(double) #2

declare double @llvm.copysign.f64(double, double) #2

declare double @llvm.rint.f64(double) #2

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #5

attributes #0 = { nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { nofree "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { mustprogress nofree norecurse nosync nounwind willreturn memory(argmem: read) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #5 = { nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #6 = { memory(none) }
attributes #7 = { nounwind }


