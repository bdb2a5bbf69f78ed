; bottoms.c 288f37e8d7f532d51c4cce2c006a46d7ed89757b16a3664be1425c1b0e4828c6: written by make kernel

%struct.Dips = type { ptr, ptr, double, ptr, ptr, double, double, i64 }
%struct.Bracket = type { double, double, double, double, double, double, double, double, i64 }

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
  %97 = call double @llvm.fabs.f64(double %96) #3
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
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %6) #4
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %7) #4
  store double 0x7FF0000000000000, ptr %7, align 8
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %8) #4
  call void @llvm.lifetime.start.p0(i64 8, ptr nonnull %9) #4
  %121 = load ptr, ptr %14, align 8
  %122 = load ptr, ptr %0, align 8
  %123 = load double, ptr %15, align 8
  %124 = call i64 %121(ptr noundef %122, ptr noundef nonnull %5, i64 noundef 1, double noundef %123, ptr noundef nonnull %6) #4
  %125 = icmp eq i64 %124, 0
  br i1 %125, label %127, label %126

126:                                              ; preds = %108
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #4
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #4
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %7) #4
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #4
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %5)
  br label %136

127:                                              ; preds = %108
  %128 = load ptr, ptr %16, align 8
  %129 = load ptr, ptr %17, align 8
  call void %128(ptr noundef %129, ptr noundef nonnull %6, i64 noundef 1, ptr noundef %68, ptr noundef nonnull %7, ptr noundef nonnull %8, ptr noundef nonnull %9) #4
  %130 = load double, ptr %8, align 8
  %131 = load double, ptr %18, align 8
  %132 = fdiv double %130, %131
  %133 = call double @llvm.rint.f64(double %132)
  %134 = fmul double %131, %133
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %9) #4
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %8) #4
  call void @llvm.lifetime.end.p0(i64 8, ptr nonnull %7) #4
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %6) #4
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

declare double @llvm.fabs.f64(double) #2

declare double @llvm.maxnum.f64(double, double) #2

declare double @llvm.copysign.f64(double, double) #2

declare double @llvm.minnum.f64(double, double) #2

declare double @llvm.rint.f64(double) #2

attributes #0 = { nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { memory(none) }
attributes #4 = { nounwind }


