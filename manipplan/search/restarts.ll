; restarts.c 3f888b0f907daf22b91486f3c3f762d51b1c2c3e311d40aa9067ee99f6735151: written by make kernel

%struct.State = type { i64, i64, i64, i64, i64, ptr, ptr, ptr }
%struct.Problem = type { i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, i64, i64, i64 }

define dso_local i64 @manipplan_restarts(ptr nocapture noundef readonly %0, i64 noundef %1, ptr nocapture noundef %2) local_unnamed_addr #0 {
  %4 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 4
  %5 = load i64, ptr %4, align 8
  %6 = add nsw i64 %5, %1
  %7 = icmp sgt i64 %1, 0
  br i1 %7, label %8, label %202

8:                                                ; preds = %3
  %9 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 2
  %10 = getelementptr inbounds %struct.Problem, ptr %0, i64 0, i32 10
  %11 = getelementptr inbounds %struct.Problem, ptr %0, i64 0, i32 6
  %12 = getelementptr inbounds %struct.Problem, ptr %0, i64 0, i32 7
  %13 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 5
  %14 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 1
  %15 = getelementptr inbounds %struct.Problem, ptr %0, i64 0, i32 1
  %16 = getelementptr inbounds %struct.Problem, ptr %0, i64 0, i32 5
  %17 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 6
  %18 = getelementptr inbounds %struct.Problem, ptr %0, i64 0, i32 4
  %19 = getelementptr inbounds %struct.Problem, ptr %0, i64 0, i32 3
  %20 = getelementptr inbounds %struct.Problem, ptr %0, i64 0, i32 11
  %21 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 7
  %22 = getelementptr inbounds %struct.Problem, ptr %0, i64 0, i32 8
  %23 = getelementptr inbounds %struct.Problem, ptr %0, i64 0, i32 9
  %24 = getelementptr inbounds %struct.State, ptr %2, i64 0, i32 3
  %25 = getelementptr inbounds %struct.Problem, ptr %0, i64 0, i32 12
  br label %26

26:                                               ; preds = %8, %199
  %27 = load i64, ptr %2, align 8
  %28 = icmp eq i64 %27, 0
  br i1 %28, label %32, label %29

29:                                               ; preds = %26
  %30 = load ptr, ptr %11, align 8
  %31 = load ptr, ptr %12, align 8
  br label %57

32:                                               ; preds = %26
  %33 = load i64, ptr %9, align 8
  %34 = load i64, ptr %10, align 8
  %35 = icmp eq i64 %33, %34
  br i1 %35, label %202, label %36

36:                                               ; preds = %32
  %37 = load ptr, ptr %11, align 8
  %38 = add nsw i64 %33, 1
  store i64 %38, ptr %9, align 8
  %39 = getelementptr inbounds i64, ptr %37, i64 %33
  %40 = load i64, ptr %39, align 8
  %41 = load ptr, ptr %12, align 8
  %42 = getelementptr inbounds i64, ptr %41, i64 %40
  %43 = load i64, ptr %42, align 8
  %44 = load ptr, ptr %13, align 8
  %45 = getelementptr inbounds i64, ptr %44, i64 %43
  store i64 %40, ptr %45, align 8
  store i64 %43, ptr %14, align 8
  store i64 1, ptr %2, align 8
  %46 = load i64, ptr %15, align 8
  %47 = add nsw i64 %46, -1
  %48 = icmp slt i64 %43, %47
  br i1 %48, label %49, label %57

49:                                               ; preds = %36
  %50 = load ptr, ptr %16, align 8
  %51 = add nsw i64 %43, 1
  %52 = getelementptr inbounds i64, ptr %50, i64 %51
  %53 = load i64, ptr %52, align 8
  %54 = load ptr, ptr %17, align 8
  %55 = getelementptr inbounds i64, ptr %54, i64 %51
  store i64 %53, ptr %55, align 8
  %56 = load i64, ptr %2, align 8
  br label %57

57:                                               ; preds = %29, %36, %49
  %58 = phi i64 [ %27, %29 ], [ 1, %36 ], [ %56, %49 ]
  %59 = phi ptr [ %31, %29 ], [ %41, %36 ], [ %41, %49 ]
  %60 = phi ptr [ %30, %29 ], [ %37, %36 ], [ %37, %49 ]
  %61 = load i64, ptr %9, align 8
  %62 = add nsw i64 %61, -1
  %63 = getelementptr inbounds i64, ptr %60, i64 %62
  %64 = load i64, ptr %63, align 8
  %65 = getelementptr inbounds i64, ptr %59, i64 %64
  %66 = load i64, ptr %65, align 8
  %67 = load ptr, ptr %18, align 8
  %68 = getelementptr inbounds double, ptr %67, i64 %64
  %69 = load double, ptr %68, align 8
  %70 = icmp eq i64 %58, 1
  br i1 %70, label %71, label %88

71:                                               ; preds = %57
  %72 = load i64, ptr %14, align 8
  %73 = load i64, ptr %15, align 8
  %74 = add nsw i64 %73, -1
  %75 = icmp eq i64 %72, %74
  br i1 %75, label %78, label %76

76:                                               ; preds = %71
  %77 = load i64, ptr %14, align 8
  br label %95

78:                                               ; preds = %71
  store i64 2, ptr %2, align 8
  store i64 %66, ptr %14, align 8
  %79 = icmp sgt i64 %66, 0
  br i1 %79, label %80, label %92

80:                                               ; preds = %78
  %81 = load ptr, ptr %16, align 8
  %82 = add nsw i64 %66, -1
  %83 = getelementptr inbounds i64, ptr %81, i64 %82
  %84 = load i64, ptr %83, align 8
  %85 = load ptr, ptr %17, align 8
  %86 = getelementptr inbounds i64, ptr %85, i64 %82
  store i64 %84, ptr %86, align 8
  %87 = load i64, ptr %2, align 8
  br label %88

88:                                               ; preds = %80, %57
  %89 = phi i64 [ %58, %57 ], [ %87, %80 ]
  %90 = freeze i64 %89
  %91 = load i64, ptr %14, align 8
  switch i64 %90, label %97 [
    i64 2, label %92
    i64 1, label %95
  ]

92:                                               ; preds = %88, %78
  %93 = phi i64 [ %66, %78 ], [ %91, %88 ]
  %94 = icmp eq i64 %93, 0
  br i1 %94, label %202, label %97

95:                                               ; preds = %88, %76
  %96 = phi i64 [ %77, %76 ], [ %91, %88 ]
  br label %97

97:                                               ; preds = %88, %92, %95
  %98 = phi i64 [ %96, %95 ], [ %93, %92 ], [ %91, %88 ]
  %99 = phi i64 [ 1, %95 ], [ -1, %92 ], [ -1, %88 ]
  %100 = add nsw i64 %99, %98
  %101 = load ptr, ptr %17, align 8
  %102 = getelementptr inbounds i64, ptr %101, i64 %100
  %103 = load i64, ptr %102, align 8
  %104 = load ptr, ptr %16, align 8
  %105 = add nsw i64 %100, 1
  %106 = getelementptr inbounds i64, ptr %104, i64 %105
  %107 = load i64, ptr %106, align 8
  %108 = load ptr, ptr %19, align 8
  %109 = load i64, ptr %0, align 8
  %110 = load ptr, ptr %13, align 8
  %111 = getelementptr inbounds i64, ptr %110, i64 %98
  %112 = load i64, ptr %111, align 8
  %113 = mul nsw i64 %112, %109
  %114 = getelementptr inbounds double, ptr %108, i64 %113
  %115 = icmp slt i64 %103, %107
  br i1 %115, label %116, label %194

116:                                              ; preds = %97
  %117 = icmp slt i64 %109, 1
  br label %118

118:                                              ; preds = %116, %169
  %119 = phi i64 [ %103, %116 ], [ %170, %169 ]
  %120 = getelementptr inbounds double, ptr %67, i64 %119
  %121 = load double, ptr %120, align 8
  %122 = fcmp ult double %121, %69
  br i1 %122, label %194, label %123

123:                                              ; preds = %118
  %124 = load i64, ptr %20, align 8
  %125 = icmp eq i64 %124, 0
  br i1 %125, label %132, label %126

126:                                              ; preds = %123
  %127 = load ptr, ptr %21, align 8
  %128 = getelementptr inbounds i64, ptr %127, i64 %119
  %129 = load i64, ptr %128, align 8
  %130 = load i64, ptr %9, align 8
  %131 = icmp eq i64 %129, %130
  br i1 %131, label %169, label %132

132:                                              ; preds = %126, %123
  %133 = load i64, ptr %4, align 8
  %134 = add nsw i64 %133, 1
  store i64 %134, ptr %4, align 8
  %135 = mul nsw i64 %119, %109
  %136 = getelementptr inbounds double, ptr %108, i64 %135
  %137 = load ptr, ptr %22, align 8
  %138 = load ptr, ptr %23, align 8
  br i1 %117, label %172, label %139

139:                                              ; preds = %132, %163
  %140 = phi i1 [ %165, %163 ], [ false, %132 ]
  %141 = phi i64 [ %164, %163 ], [ 0, %132 ]
  %142 = getelementptr inbounds double, ptr %136, i64 %141
  %143 = load double, ptr %142, align 8
  %144 = getelementptr inbounds double, ptr %114, i64 %141
  %145 = load double, ptr %144, align 8
  %146 = fsub double %143, %145
  %147 = tail call double @llvm.fabs.f64(double %146)
  %148 = getelementptr inbounds double, ptr %137, i64 %141
  %149 = load double, ptr %148, align 8
  %150 = fcmp olt double %147, %149
  br i1 %150, label %163, label %151

151:                                              ; preds = %139
  %152 = getelementptr inbounds i8, ptr %138, i64 %141
  %153 = load i8, ptr %152, align 1
  %154 = icmp eq i8 %153, 0
  br i1 %154, label %167, label %155

155:                                              ; preds = %151
  %156 = fdiv double %146, 0x401921FB54442D18
  %157 = fadd double %156, 5.000000e-01
  %158 = tail call double @llvm.floor.f64(double %157)
  %159 = fmul double %158, 0x401921FB54442D18
  %160 = fsub double %146, %159
  %161 = tail call double @llvm.fabs.f64(double %160)
  %162 = fcmp olt double %161, %149
  br i1 %162, label %163, label %167

163:                                              ; preds = %155, %139
  %164 = add nuw nsw i64 %141, 1
  %165 = icmp sge i64 %164, %109
  %166 = icmp eq i64 %164, %109
  br i1 %166, label %167, label %139

167:                                              ; preds = %151, %155, %163
  %168 = phi i1 [ %140, %155 ], [ %140, %151 ], [ %165, %163 ]
  br i1 %168, label %172, label %169

169:                                              ; preds = %167, %126
  %170 = add i64 %119, 1
  %171 = icmp eq i64 %170, %107
  br i1 %171, label %194, label %118

172:                                              ; preds = %132, %167
  %173 = load i64, ptr %24, align 8
  %174 = load i64, ptr %25, align 8
  %175 = icmp slt i64 %173, %174
  br i1 %175, label %177, label %176

176:                                              ; preds = %172
  store i64 %119, ptr %102, align 8
  br label %202

177:                                              ; preds = %172
  %178 = add nsw i64 %119, 1
  store i64 %178, ptr %102, align 8
  %179 = getelementptr inbounds i64, ptr %110, i64 %100
  store i64 %119, ptr %179, align 8
  %180 = load i64, ptr %9, align 8
  %181 = load ptr, ptr %21, align 8
  %182 = getelementptr inbounds i64, ptr %181, i64 %119
  store i64 %180, ptr %182, align 8
  %183 = load i64, ptr %24, align 8
  %184 = add nsw i64 %183, 1
  store i64 %184, ptr %24, align 8
  store i64 %100, ptr %14, align 8
  %185 = add nsw i64 %100, %99
  %186 = icmp sgt i64 %185, -1
  br i1 %186, label %187, label %199

187:                                              ; preds = %177
  %188 = load i64, ptr %15, align 8
  %189 = icmp slt i64 %185, %188
  br i1 %189, label %190, label %199

190:                                              ; preds = %187
  %191 = getelementptr inbounds i64, ptr %104, i64 %185
  %192 = load i64, ptr %191, align 8
  %193 = getelementptr inbounds i64, ptr %101, i64 %185
  store i64 %192, ptr %193, align 8
  br label %199

194:                                              ; preds = %118, %169, %97
  %195 = icmp eq i64 %98, %66
  br i1 %195, label %196, label %197

196:                                              ; preds = %194
  store i64 0, ptr %2, align 8
  br label %199

197:                                              ; preds = %194
  %198 = sub nsw i64 %98, %99
  store i64 %198, ptr %14, align 8
  br label %199

199:                                              ; preds = %177, %187, %190, %196, %197
  %200 = load i64, ptr %4, align 8
  %201 = icmp slt i64 %200, %6
  br i1 %201, label %26, label %202

202:                                              ; preds = %32, %199, %92, %3, %176
  %203 = phi i64 [ 3, %176 ], [ 0, %3 ], [ 2, %32 ], [ 0, %199 ], [ 1, %92 ]
  ret i64 %203
}

declare double @llvm.fabs.f64(double) #1

declare double @llvm.floor.f64(double) #1

attributes #0 = { nofree nosync nounwind memory(readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }


