; curves.c 704a5f18a8e833d2099565e5de2972ecd911fd5fd6f6143e89967956c6f09a0f: written by make kernel

%struct.Curve = type { i64, i64, i64, ptr, ptr }

define dso_local i64 @manipplan_curve(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, i64 noundef %2, double noundef %3, ptr nocapture noundef %4) local_unnamed_addr #0 {
  %6 = alloca [31 x double], align 16
  %7 = alloca [31 x double], align 16
  %8 = alloca [31 x double], align 16
  %9 = getelementptr inbounds %struct.Curve, ptr %0, i64 0, i32 1
  %10 = load i64, ptr %9, align 8
  %11 = getelementptr inbounds %struct.Curve, ptr %0, i64 0, i32 2
  %12 = load i64, ptr %11, align 8
  %13 = icmp sgt i64 %2, 0
  br i1 %13, label %16, label %28

14:                                               ; preds = %16
  %15 = icmp eq i64 %25, 0
  br i1 %15, label %28, label %152

16:                                               ; preds = %5, %16
  %17 = phi i64 [ %25, %16 ], [ 0, %5 ]
  %18 = phi i64 [ %26, %16 ], [ 0, %5 ]
  %19 = getelementptr inbounds double, ptr %1, i64 %18
  %20 = load double, ptr %19, align 8
  %21 = fcmp ult double %20, 0.000000e+00
  %22 = fcmp ugt double %20, 1.000000e+00
  %23 = or i1 %21, %22
  %24 = zext i1 %23 to i64
  %25 = add nuw nsw i64 %17, %24
  %26 = add nuw nsw i64 %18, 1
  %27 = icmp eq i64 %26, %2
  br i1 %27, label %14, label %16

28:                                               ; preds = %5, %14
  call void @llvm.lifetime.start.p0(i64 248, ptr nonnull %6) #4
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(248) %6, i8 0, i64 248, i1 false)
  call void @llvm.lifetime.start.p0(i64 248, ptr nonnull %7) #4
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(248) %7, i8 0, i64 248, i1 false)
  call void @llvm.lifetime.start.p0(i64 248, ptr nonnull %8) #4
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(248) %8, i8 0, i64 248, i1 false)
  store double 1.000000e+00, ptr %8, align 16
  %29 = icmp slt i64 %10, 1
  br i1 %29, label %32, label %30

30:                                               ; preds = %28
  %31 = add nuw i64 %10, 1
  br label %47

32:                                               ; preds = %47, %28
  br i1 %13, label %33, label %58

33:                                               ; preds = %32
  %34 = load i64, ptr %0, align 8
  %35 = icmp sgt i64 %34, 1
  %36 = getelementptr inbounds %struct.Curve, ptr %0, i64 0, i32 3
  %37 = load ptr, ptr %36, align 8
  %38 = getelementptr inbounds %struct.Curve, ptr %0, i64 0, i32 4
  %39 = load ptr, ptr %38, align 8
  %40 = add i64 %10, 1
  %41 = mul i64 %12, %40
  %42 = icmp sgt i64 %12, 0
  %43 = getelementptr inbounds [31 x double], ptr %8, i64 0, i64 %10
  %44 = fcmp ule double %3, 0.000000e+00
  %45 = icmp slt i64 %12, 1
  %46 = select i1 %44, i1 true, i1 %45
  br label %59

47:                                               ; preds = %30, %47
  %48 = phi double [ 1.000000e+00, %30 ], [ %54, %47 ]
  %49 = phi i64 [ 1, %30 ], [ %56, %47 ]
  %50 = sub i64 %31, %49
  %51 = sitofp i64 %50 to double
  %52 = fmul double %48, %51
  %53 = sitofp i64 %49 to double
  %54 = fdiv double %52, %53
  %55 = getelementptr inbounds [31 x double], ptr %6, i64 0, i64 %49
  store double %54, ptr %55, align 8
  %56 = add nuw i64 %49, 1
  %57 = icmp eq i64 %49, %10
  br i1 %57, label %32, label %47

58:                                               ; preds = %148, %32
  call void @llvm.lifetime.end.p0(i64 248, ptr nonnull %8) #4
  call void @llvm.lifetime.end.p0(i64 248, ptr nonnull %7) #4
  call void @llvm.lifetime.end.p0(i64 248, ptr nonnull %6) #4
  br label %152

59:                                               ; preds = %33, %148
  %60 = phi ptr [ %4, %33 ], [ %150, %148 ]
  %61 = phi i64 [ 0, %33 ], [ %149, %148 ]
  %62 = getelementptr inbounds double, ptr %1, i64 %61
  %63 = load double, ptr %62, align 8
  br i1 %35, label %64, label %76

64:                                               ; preds = %59, %64
  %65 = phi i64 [ %73, %64 ], [ 0, %59 ]
  %66 = phi i64 [ %72, %64 ], [ %34, %59 ]
  %67 = add nsw i64 %66, %65
  %68 = sdiv i64 %67, 2
  %69 = getelementptr inbounds double, ptr %37, i64 %68
  %70 = load double, ptr %69, align 8
  %71 = fcmp ugt double %70, %63
  %72 = select i1 %71, i64 %68, i64 %66
  %73 = select i1 %71, i64 %65, i64 %68
  %74 = sub nsw i64 %72, %73
  %75 = icmp sgt i64 %74, 1
  br i1 %75, label %64, label %76

76:                                               ; preds = %64, %59
  %77 = phi i64 [ 0, %59 ], [ %73, %64 ]
  %78 = getelementptr inbounds double, ptr %37, i64 %77
  %79 = load double, ptr %78, align 8
  %80 = fsub double %63, %79
  %81 = add nsw i64 %77, 1
  %82 = getelementptr inbounds double, ptr %37, i64 %81
  %83 = load double, ptr %82, align 8
  %84 = fsub double %83, %79
  %85 = fdiv double %80, %84
  br i1 %29, label %88, label %86

86:                                               ; preds = %76
  %87 = fsub double 1.000000e+00, %85
  br label %93

88:                                               ; preds = %93, %76
  %89 = mul i64 %41, %77
  %90 = getelementptr inbounds double, ptr %39, i64 %89
  br i1 %42, label %91, label %103

91:                                               ; preds = %88
  %92 = load double, ptr %43, align 8
  br label %104

93:                                               ; preds = %86, %93
  %94 = phi double [ 1.000000e+00, %86 ], [ %99, %93 ]
  %95 = phi double [ 1.000000e+00, %86 ], [ %97, %93 ]
  %96 = phi i64 [ 1, %86 ], [ %101, %93 ]
  %97 = fmul double %85, %95
  %98 = getelementptr inbounds [31 x double], ptr %7, i64 0, i64 %96
  store double %97, ptr %98, align 8
  %99 = fmul double %87, %94
  %100 = getelementptr inbounds [31 x double], ptr %8, i64 0, i64 %96
  store double %99, ptr %100, align 8
  %101 = add nuw i64 %96, 1
  %102 = icmp eq i64 %96, %10
  br i1 %102, label %88, label %93

103:                                              ; preds = %104, %88
  br i1 %29, label %112, label %113

104:                                              ; preds = %91, %104
  %105 = phi i64 [ 0, %91 ], [ %110, %104 ]
  %106 = getelementptr inbounds double, ptr %90, i64 %105
  %107 = load double, ptr %106, align 8
  %108 = fmul double %92, %107
  %109 = getelementptr inbounds double, ptr %60, i64 %105
  store double %108, ptr %109, align 8
  %110 = add nuw nsw i64 %105, 1
  %111 = icmp eq i64 %110, %12
  br i1 %111, label %103, label %104

112:                                              ; preds = %126, %103
  br i1 %46, label %148, label %139

113:                                              ; preds = %103, %126
  %114 = phi i64 [ %127, %126 ], [ 1, %103 ]
  %115 = phi ptr [ %125, %126 ], [ %90, %103 ]
  %116 = getelementptr inbounds [31 x double], ptr %6, i64 0, i64 %114
  %117 = load double, ptr %116, align 8
  %118 = getelementptr inbounds [31 x double], ptr %7, i64 0, i64 %114
  %119 = load double, ptr %118, align 8
  %120 = fmul double %117, %119
  %121 = sub nsw i64 %10, %114
  %122 = getelementptr inbounds [31 x double], ptr %8, i64 0, i64 %121
  %123 = load double, ptr %122, align 8
  %124 = fmul double %120, %123
  %125 = getelementptr inbounds double, ptr %115, i64 %12
  br i1 %42, label %129, label %126

126:                                              ; preds = %129, %113
  %127 = add nuw i64 %114, 1
  %128 = icmp eq i64 %10, %114
  br i1 %128, label %112, label %113

129:                                              ; preds = %113, %129
  %130 = phi i64 [ %137, %129 ], [ 0, %113 ]
  %131 = getelementptr inbounds double, ptr %125, i64 %130
  %132 = load double, ptr %131, align 8
  %133 = fmul double %124, %132
  %134 = getelementptr inbounds double, ptr %60, i64 %130
  %135 = load double, ptr %134, align 8
  %136 = fadd double %135, %133
  store double %136, ptr %134, align 8
  %137 = add nuw nsw i64 %130, 1
  %138 = icmp eq i64 %137, %12
  br i1 %138, label %126, label %129

139:                                              ; preds = %112, %139
  %140 = phi i64 [ %146, %139 ], [ 0, %112 ]
  %141 = getelementptr inbounds double, ptr %60, i64 %140
  %142 = load double, ptr %141, align 8
  %143 = fdiv double %142, %3
  %144 = tail call double @llvm.rint.f64(double %143)
  %145 = fmul double %144, %3
  store double %145, ptr %141, align 8
  %146 = add nuw nsw i64 %140, 1
  %147 = icmp eq i64 %146, %12
  br i1 %147, label %148, label %139

148:                                              ; preds = %139, %112
  %149 = add nuw nsw i64 %61, 1
  %150 = getelementptr inbounds double, ptr %60, i64 %12
  %151 = icmp eq i64 %149, %2
  br i1 %151, label %58, label %59

152:                                              ; preds = %14, %58
  %153 = phi i64 [ 0, %58 ], [ %25, %14 ]
  ret i64 %153
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #2

declare double @llvm.rint.f64(double) #3

attributes #0 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #3 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #4 = { nounwind }


