; winding.c a27b5b4a401251f012ccafad7dd7d3def1174cebf3beebffdced721d150c9456: written by make kernel

define dso_local void @manipplan_winding(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef readonly %2, i64 noundef %3, ptr nocapture noundef writeonly %4) local_unnamed_addr #0 {
  %6 = alloca [3 x [3 x double]], align 16
  %7 = alloca [3 x double], align 16
  %8 = icmp sgt i64 %3, 0
  br i1 %8, label %9, label %25

9:                                                ; preds = %5
  %10 = icmp sgt i64 %1, 0
  %11 = getelementptr inbounds [3 x [3 x double]], ptr %6, i64 0, i64 1
  %12 = getelementptr inbounds [3 x [3 x double]], ptr %6, i64 0, i64 2
  %13 = getelementptr inbounds [3 x [3 x double]], ptr %6, i64 0, i64 1, i64 1
  %14 = getelementptr inbounds [3 x [3 x double]], ptr %6, i64 0, i64 2, i64 2
  %15 = getelementptr inbounds [3 x [3 x double]], ptr %6, i64 0, i64 1, i64 2
  %16 = getelementptr inbounds [3 x [3 x double]], ptr %6, i64 0, i64 2, i64 1
  %17 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 1
  %18 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 2
  %19 = getelementptr inbounds double, ptr %6, i64 1
  %20 = getelementptr inbounds double, ptr %6, i64 2
  br label %21

21:                                               ; preds = %9, %26
  %22 = phi i64 [ 0, %9 ], [ %30, %26 ]
  br i1 %10, label %23, label %26

23:                                               ; preds = %21
  %24 = mul nsw i64 %22, 3
  br label %32

25:                                               ; preds = %26, %5
  ret void

26:                                               ; preds = %40, %21
  %27 = phi double [ 0.000000e+00, %21 ], [ %91, %40 ]
  %28 = fdiv double %27, 0x401921FB54442D18
  %29 = getelementptr inbounds double, ptr %4, i64 %22
  store double %28, ptr %29, align 8
  %30 = add nuw nsw i64 %22, 1
  %31 = icmp eq i64 %30, %3
  br i1 %31, label %25, label %21

32:                                               ; preds = %23, %40
  %33 = phi double [ 0.000000e+00, %23 ], [ %91, %40 ]
  %34 = phi i64 [ 0, %23 ], [ %92, %40 ]
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %6) #4
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7) #4
  %35 = mul nuw nsw i64 %34, 9
  br label %36

36:                                               ; preds = %32, %94
  %37 = phi i64 [ 0, %32 ], [ %108, %94 ]
  %38 = mul nuw nsw i64 %37, 3
  %39 = add nuw nsw i64 %35, %38
  br label %110

40:                                               ; preds = %94
  %41 = load double, ptr %13, align 16
  %42 = load double, ptr %14, align 16
  %43 = fmul double %41, %42
  %44 = load double, ptr %15, align 8
  %45 = load double, ptr %16, align 8
  %46 = fmul double %44, %45
  %47 = fsub double %43, %46
  %48 = load double, ptr %12, align 16
  %49 = fmul double %44, %48
  %50 = load double, ptr %11, align 8
  %51 = fmul double %42, %50
  %52 = fsub double %49, %51
  %53 = fmul double %45, %50
  %54 = fmul double %41, %48
  %55 = fsub double %53, %54
  %56 = load double, ptr %7, align 16
  %57 = load double, ptr %17, align 8
  %58 = fmul double %56, %57
  %59 = load double, ptr %18, align 16
  %60 = fmul double %58, %59
  %61 = load double, ptr %6, align 16
  %62 = fmul double %50, %61
  %63 = load double, ptr %19, align 8
  %64 = fmul double %63, %41
  %65 = fadd double %62, %64
  %66 = load double, ptr %20, align 16
  %67 = fmul double %66, %44
  %68 = fadd double %65, %67
  %69 = fmul double %59, %68
  %70 = fadd double %60, %69
  %71 = fmul double %48, %50
  %72 = fmul double %41, %45
  %73 = fadd double %71, %72
  %74 = fmul double %44, %42
  %75 = fadd double %73, %74
  %76 = fmul double %56, %75
  %77 = fadd double %70, %76
  %78 = fmul double %48, %61
  %79 = fmul double %63, %45
  %80 = fadd double %78, %79
  %81 = fmul double %66, %42
  %82 = fadd double %80, %81
  %83 = fmul double %57, %82
  %84 = fadd double %83, %77
  %85 = fmul double %47, %61
  %86 = fmul double %52, %63
  %87 = fadd double %85, %86
  %88 = fmul double %55, %66
  %89 = fadd double %87, %88
  %90 = tail call double @atan2(double noundef %89, double noundef %84) #5
  %91 = fadd double %33, %90
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7) #4
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %6) #4
  %92 = add nuw nsw i64 %34, 1
  %93 = icmp eq i64 %92, %1
  br i1 %93, label %26, label %32

94:                                               ; preds = %110
  %95 = getelementptr inbounds [3 x [3 x double]], ptr %6, i64 0, i64 %37
  %96 = load double, ptr %95, align 8
  %97 = fmul double %96, %96
  %98 = getelementptr inbounds double, ptr %95, i64 1
  %99 = load double, ptr %98, align 8
  %100 = fmul double %99, %99
  %101 = fadd double %97, %100
  %102 = getelementptr inbounds double, ptr %95, i64 2
  %103 = load double, ptr %102, align 8
  %104 = fmul double %103, %103
  %105 = fadd double %101, %104
  %106 = tail call double @llvm.sqrt.f64(double %105)
  %107 = getelementptr inbounds [3 x double], ptr %7, i64 0, i64 %37
  store double %106, ptr %107, align 8
  %108 = add nuw nsw i64 %37, 1
  %109 = icmp eq i64 %108, 3
  br i1 %109, label %40, label %36

110:                                              ; preds = %36, %110
  %111 = phi i64 [ 0, %36 ], [ %120, %110 ]
  %112 = add nuw nsw i64 %39, %111
  %113 = getelementptr inbounds double, ptr %0, i64 %112
  %114 = load double, ptr %113, align 8
  %115 = add nuw nsw i64 %24, %111
  %116 = getelementptr inbounds double, ptr %2, i64 %115
  %117 = load double, ptr %116, align 8
  %118 = fsub double %114, %117
  %119 = getelementptr inbounds [3 x [3 x double]], ptr %6, i64 0, i64 %37, i64 %111
  store double %118, ptr %119, align 8
  %120 = add nuw nsw i64 %111, 1
  %121 = icmp eq i64 %120, 3
  br i1 %121, label %94, label %110
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

declare double @llvm.sqrt.f64(double) #2

declare double @atan2(double noundef, double noundef) local_unnamed_addr #3

attributes #0 = { nofree nosync nounwind memory(argmem: readwrite) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { mustprogress nofree nosync nounwind willreturn memory(none) "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { nounwind }
attributes #5 = { nounwind willreturn memory(none) }


