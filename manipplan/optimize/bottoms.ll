; bottoms.c 6e5e29b888a9de1cdf3f67c1b4c8ef0073bcf4ca99fd5a081659ec8336db2a59: written by make kernel

%struct.Dips = type { i64, ptr, ptr, double, ptr, ptr, double, double, double, double, i64 }
%struct.Bracket = type { double, double, double, double, double, double, double, double, i64 }

define dso_local i64 @manipplan_bottoms(ptr nocapture noundef readonly %0, ptr noundef %1, i64 noundef %2, ptr nocapture noundef %3) local_unnamed_addr #0 {
  %5 = alloca double, align 8
  %6 = alloca [64 x double], align 16
  %7 = alloca double, align 8
  %8 = alloca double, align 8
  %9 = alloca i64, align 8
  %10 = icmp sgt i64 %2, 0
  br i1 %10, label %11, label %22

11:                                               ; preds = %4
  %12 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 10
  %13 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 7
  %14 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 9
  %15 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 8
  %16 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 2
  %17 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 1
  %18 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 3
  %19 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 5
  %20 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 4
  %21 = getelementptr inbounds %struct.Dips, ptr %0, i64 0, i32 6
  br label %24

22:                                               ; preds = %168, %4
  %23 = phi i64 [ 0, %4 ], [ %169, %168 ]
  ret i64 %23

24:                                               ; preds = %11, %168
  %25 = phi i64 [ 0, %11 ], [ %169, %168 ]
  %26 = phi i64 [ 0, %11 ], [ %170, %168 ]
  %27 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26
  %28 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 6
  %29 = load double, ptr %28, align 8
  %30 = fcmp uno double %29, 0.000000e+00
  br i1 %30, label %31, label %34

31:                                               ; preds = %24
  %32 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 8
  %33 = load i64, ptr %32, align 8
  br label %59

34:                                               ; preds = %24
  %35 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 7
  %36 = load double, ptr %35, align 8
  %37 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 4
  %38 = load double, ptr %37, align 8
  %39 = fcmp ogt double %38, %36
  %40 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 1
  %41 = load double, ptr %40, align 8
  %42 = fcmp olt double %41, %29
  %43 = select i1 %39, double %41, double %29
  br i1 %39, label %45, label %44

44:                                               ; preds = %34
  br i1 %42, label %49, label %46

45:                                               ; preds = %34
  br i1 %42, label %46, label %49

46:                                               ; preds = %45, %44
  %47 = phi double [ %36, %44 ], [ %38, %45 ]
  store double %43, ptr %27, align 8
  %48 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 3
  store double %47, ptr %48, align 8
  br label %53

49:                                               ; preds = %45, %44
  %50 = phi double [ %36, %44 ], [ %38, %45 ]
  %51 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 2
  store double %43, ptr %51, align 8
  %52 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 5
  store double %50, ptr %52, align 8
  br label %53

53:                                               ; preds = %49, %46
  br i1 %39, label %54, label %55

54:                                               ; preds = %53
  store double %29, ptr %40, align 8
  store double %36, ptr %37, align 8
  br label %55

55:                                               ; preds = %53, %54
  %56 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 8
  %57 = load i64, ptr %56, align 8
  %58 = add nsw i64 %57, 1
  store i64 %58, ptr %56, align 8
  store double 0x7FF8000000000000, ptr %28, align 8
  br label %59

59:                                               ; preds = %31, %55
  %60 = phi i64 [ %33, %31 ], [ %58, %55 ]
  %61 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 8
  %62 = load i64, ptr %12, align 8
  %63 = icmp slt i64 %60, %62
  br i1 %63, label %64, label %168

64:                                               ; preds = %59
  %65 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 2
  %66 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 3
  %67 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 5
  %68 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 4
  %69 = getelementptr inbounds %struct.Bracket, ptr %3, i64 %26, i32 1
  %70 = shl nuw nsw i64 %26, 1
  %71 = getelementptr inbounds i64, ptr %1, i64 %70
  br label %72

72:                                               ; preds = %64, %163
  %73 = phi i64 [ %60, %64 ], [ %165, %163 ]
  %74 = load double, ptr %65, align 8
  %75 = load double, ptr %27, align 8
  %76 = fsub double %74, %75
  %77 = load double, ptr %13, align 8
  %78 = fcmp ult double %76, %77
  br i1 %78, label %168, label %79

79:                                               ; preds = %72
  %80 = load double, ptr %66, align 8
  %81 = load double, ptr %67, align 8
  %82 = call double @llvm.maxnum.f64(double %80, double %81)
  %83 = load double, ptr %68, align 8
  %84 = fsub double %82, %83
  %85 = load double, ptr %14, align 8
  %86 = load double, ptr %15, align 8
  %87 = fsub double %86, %83
  %88 = fmul double %85, %87
  %89 = fcmp ogt double %84, %88
  br i1 %89, label %90, label %168

90:                                               ; preds = %79
  %91 = load double, ptr %69, align 8
  %92 = fsub double %91, %75
  %93 = fsub double %74, %91
  %94 = fcmp ogt double %92, %93
  %95 = fmul double %92, -5.000000e-01
  %96 = fmul double %93, 5.000000e-01
  %97 = select i1 %94, double %95, double %96
  %98 = fsub double %80, %83
  %99 = fdiv double %98, %92
  %100 = fsub double %81, %83
  %101 = fdiv double %100, %93
  %102 = fmul double %93, %99
  %103 = fmul double %92, %101
  %104 = fsub double %102, %103
  %105 = fadd double %99, %101
  %106 = fmul double %105, 2.000000e+00
  %107 = fdiv double %104, %106
  %108 = call double @llvm.fabs.f64(double %107) #3
  %109 = fcmp one double %108, 0x7FF0000000000000
  %110 = fneg double %92
  %111 = fcmp ogt double %107, %110
  %112 = select i1 %109, i1 %111, i1 false
  %113 = fcmp olt double %107, %93
  %114 = select i1 %112, i1 %113, i1 false
  br i1 %114, label %115, label %119

115:                                              ; preds = %90
  %116 = srem i64 %73, 3
  %117 = icmp slt i64 %116, 2
  %118 = select i1 %117, double %107, double %97
  br label %119

119:                                              ; preds = %90, %115
  %120 = phi double [ %97, %90 ], [ %118, %115 ]
  %121 = fadd double %92, %93
  %122 = fmul double %121, 2.000000e-02
  %123 = fmul double %77, 2.500000e-01
  %124 = call double @llvm.maxnum.f64(double %122, double %123)
  %125 = call double @llvm.fabs.f64(double %120)
  %126 = fcmp olt double %125, %124
  %127 = call double @llvm.copysign.f64(double %124, double %97)
  %128 = select i1 %126, double %127, double %120
  %129 = fadd double %91, %128
  %130 = call double @llvm.maxnum.f64(double %129, double %75)
  %131 = call double @llvm.minnum.f64(double %130, double %74)
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %5)
  store double %131, ptr %5, align 8
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %6) #4
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %7) #4
  store double 0x7FF0000000000000, ptr %7, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %8) #4
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %9) #4
  %132 = load ptr, ptr %16, align 8
  %133 = load ptr, ptr %17, align 8
  %134 = load double, ptr %18, align 8
  %135 = call i64 %132(ptr noundef %133, ptr noundef nonnull %5, i64 noundef 1, double noundef %134, ptr noundef nonnull %6) #4
  %136 = icmp eq i64 %135, 0
  br i1 %136, label %138, label %137

137:                                              ; preds = %119
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #4
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #4
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %7) #4
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #4
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %5)
  br label %147

138:                                              ; preds = %119
  %139 = load ptr, ptr %19, align 8
  %140 = load ptr, ptr %20, align 8
  call void %139(ptr noundef %140, ptr noundef nonnull %6, i64 noundef 1, ptr noundef %71, ptr noundef nonnull %7, ptr noundef nonnull %8, ptr noundef nonnull %9) #4
  %141 = load double, ptr %8, align 8
  %142 = load double, ptr %21, align 8
  %143 = fdiv double %141, %142
  %144 = call double @llvm.rint.f64(double %143)
  %145 = fmul double %142, %144
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #4
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #4
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %7) #4
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #4
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %5)
  %146 = fcmp uno double %145, 0.000000e+00
  br i1 %146, label %147, label %149

147:                                              ; preds = %138, %137
  store double %131, ptr %28, align 8
  %148 = add nsw i64 %25, 1
  br label %168

149:                                              ; preds = %138
  %150 = load double, ptr %68, align 8
  %151 = fcmp ogt double %150, %145
  %152 = load double, ptr %69, align 8
  %153 = fcmp olt double %152, %131
  %154 = select i1 %151, double %152, double %131
  br i1 %151, label %156, label %155

155:                                              ; preds = %149
  br i1 %153, label %159, label %157

156:                                              ; preds = %149
  br i1 %153, label %157, label %159

157:                                              ; preds = %156, %155
  %158 = phi double [ %145, %155 ], [ %150, %156 ]
  store double %154, ptr %27, align 8
  store double %158, ptr %66, align 8
  br label %161

159:                                              ; preds = %156, %155
  %160 = phi double [ %145, %155 ], [ %150, %156 ]
  store double %154, ptr %65, align 8
  store double %160, ptr %67, align 8
  br label %161

161:                                              ; preds = %159, %157
  br i1 %151, label %162, label %163

162:                                              ; preds = %161
  store double %131, ptr %69, align 8
  store double %145, ptr %68, align 8
  br label %163

163:                                              ; preds = %162, %161
  %164 = load i64, ptr %61, align 8
  %165 = add nsw i64 %164, 1
  store i64 %165, ptr %61, align 8
  %166 = load i64, ptr %12, align 8
  %167 = icmp slt i64 %165, %166
  br i1 %167, label %72, label %168

168:                                              ; preds = %79, %72, %163, %59, %147
  %169 = phi i64 [ %148, %147 ], [ %25, %59 ], [ %25, %163 ], [ %25, %72 ], [ %25, %79 ]
  %170 = add nuw nsw i64 %26, 1
  %171 = icmp eq i64 %170, %2
  br i1 %171, label %22, label %24
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

declare double @llvm.maxnum.f64(double, double) #2

declare double @llvm.fabs.f64(double) #2

declare double @llvm.copysign.f64(double, double) #2

declare double @llvm.minnum.f64(double, double) #2

declare double @llvm.rint.f64(double) #2

attributes #0 = { nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { memory(none) }
attributes #4 = { nounwind }


