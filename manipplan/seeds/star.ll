; star.c b00ad23090af5a27f091e0d1fcee44ca83eef0bfd76b63cd5406d52ebf386c33: written by make kernel

%struct.Star = type { i64, ptr, ptr, ptr, ptr, double, double, double, double, i64, ptr, ptr, ptr, ptr, ptr, double, i64 }

define dso_local double @manipplan_edge_cost(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2) local_unnamed_addr #0 {
  %4 = alloca [512 x double], align 16
  %5 = alloca [8 x double], align 16
  %6 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 3
  %7 = load ptr, ptr %6, align 8
  %8 = icmp eq ptr %7, null
  %9 = load i64, ptr %0, align 8
  %10 = icmp sgt i64 %9, 0
  br i1 %8, label %12, label %11

11:                                               ; preds = %3
  br i1 %10, label %25, label %34

12:                                               ; preds = %3
  br i1 %10, label %13, label %64

13:                                               ; preds = %12, %13
  %14 = phi i64 [ %23, %13 ], [ 0, %12 ]
  %15 = phi double [ %22, %13 ], [ 0.000000e+00, %12 ]
  %16 = getelementptr inbounds double, ptr %2, i64 %14
  %17 = load double, ptr %16, align 8
  %18 = getelementptr inbounds double, ptr %1, i64 %14
  %19 = load double, ptr %18, align 8
  %20 = fsub double %17, %19
  %21 = fmul double %20, %20
  %22 = fadd double %15, %21
  %23 = add nuw nsw i64 %14, 1
  %24 = icmp eq i64 %23, %9
  br i1 %24, label %56, label %13

25:                                               ; preds = %11, %37
  %26 = phi i64 [ %38, %37 ], [ 0, %11 ]
  %27 = phi double [ %53, %37 ], [ 0.000000e+00, %11 ]
  %28 = getelementptr inbounds double, ptr %2, i64 %26
  %29 = load double, ptr %28, align 8
  %30 = getelementptr inbounds double, ptr %1, i64 %26
  %31 = load double, ptr %30, align 8
  %32 = fsub double %29, %31
  %33 = mul nsw i64 %26, %9
  br label %40

34:                                               ; preds = %37, %11
  %35 = phi double [ 0.000000e+00, %11 ], [ %53, %37 ]
  %36 = tail call double @llvm.maxnum.f64(double %35, double 0.000000e+00)
  br label %56

37:                                               ; preds = %40
  %38 = add nuw nsw i64 %26, 1
  %39 = icmp eq i64 %38, %9
  br i1 %39, label %34, label %25

40:                                               ; preds = %40, %25
  %41 = phi i64 [ 0, %25 ], [ %54, %40 ]
  %42 = phi double [ %27, %25 ], [ %53, %40 ]
  %43 = add nsw i64 %41, %33
  %44 = getelementptr inbounds double, ptr %7, i64 %43
  %45 = load double, ptr %44, align 8
  %46 = fmul double %32, %45
  %47 = getelementptr inbounds double, ptr %2, i64 %41
  %48 = load double, ptr %47, align 8
  %49 = getelementptr inbounds double, ptr %1, i64 %41
  %50 = load double, ptr %49, align 8
  %51 = fsub double %48, %50
  %52 = fmul double %46, %51
  %53 = fadd double %42, %52
  %54 = add nuw nsw i64 %41, 1
  %55 = icmp eq i64 %54, %9
  br i1 %55, label %37, label %40

56:                                               ; preds = %13, %34
  %57 = phi double [ %36, %34 ], [ %22, %13 ]
  %58 = tail call double @llvm.sqrt.f64(double %57)
  call void @llvm.lifetime.start.p0(i64 4096, ptr nonnull %4) #4
  call void @llvm.lifetime.start.p0(i64 64, ptr nonnull %5) #4
  %59 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 4
  %60 = load ptr, ptr %59, align 8
  %61 = icmp eq ptr %60, null
  %62 = fcmp oeq double %58, 0.000000e+00
  %63 = select i1 %61, i1 true, i1 %62
  br i1 %63, label %184, label %65

64:                                               ; preds = %12
  call void @llvm.lifetime.start.p0(i64 4096, ptr nonnull %4) #4
  call void @llvm.lifetime.start.p0(i64 64, ptr nonnull %5) #4
  br label %184

65:                                               ; preds = %56
  br i1 %10, label %66, label %78

66:                                               ; preds = %65, %66
  %67 = phi i64 [ %76, %66 ], [ 0, %65 ]
  %68 = phi double [ %75, %66 ], [ 0.000000e+00, %65 ]
  %69 = getelementptr inbounds double, ptr %2, i64 %67
  %70 = load double, ptr %69, align 8
  %71 = getelementptr inbounds double, ptr %1, i64 %67
  %72 = load double, ptr %71, align 8
  %73 = fsub double %70, %72
  %74 = fmul double %73, %73
  %75 = fadd double %68, %74
  %76 = add nuw nsw i64 %67, 1
  %77 = icmp eq i64 %76, %9
  br i1 %77, label %78, label %66

78:                                               ; preds = %66, %65
  %79 = phi double [ 0.000000e+00, %65 ], [ %75, %66 ]
  %80 = tail call double @llvm.sqrt.f64(double %79)
  %81 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 8
  %82 = load double, ptr %81, align 8
  %83 = fdiv double %80, %82
  %84 = tail call double @llvm.ceil.f64(double %83)
  %85 = fptosi double %84 to i64
  %86 = icmp sgt i64 %85, 0
  br i1 %86, label %89, label %87

87:                                               ; preds = %78
  %88 = sitofp i64 %85 to double
  br label %179

89:                                               ; preds = %78
  %90 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 9
  %91 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 10
  %92 = sitofp i64 %85 to double
  %93 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 5
  %94 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 7
  %95 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 11
  %96 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 6
  %97 = load i64, ptr %90, align 8
  br label %98

98:                                               ; preds = %89, %150
  %99 = phi i64 [ %97, %89 ], [ %114, %150 ]
  %100 = phi i1 [ true, %89 ], [ %153, %150 ]
  %101 = phi double [ 0.000000e+00, %89 ], [ %151, %150 ]
  %102 = phi i64 [ 0, %89 ], [ %152, %150 ]
  %103 = icmp sgt i64 %99, 0
  br i1 %103, label %104, label %109

104:                                              ; preds = %98
  %105 = sitofp i64 %102 to double
  %106 = load ptr, ptr %91, align 8
  %107 = load i64, ptr %0, align 8
  %108 = icmp sgt i64 %107, 0
  br label %124

109:                                              ; preds = %134, %98
  %110 = load ptr, ptr %59, align 8
  %111 = call i32 %110(ptr noundef nonnull %4, ptr noundef nonnull %5, i64 noundef %99) #4
  %112 = icmp eq i32 %111, 0
  br i1 %112, label %113, label %178

113:                                              ; preds = %109
  %114 = load i64, ptr %90, align 8
  %115 = icmp sgt i64 %114, 0
  br i1 %115, label %116, label %150

116:                                              ; preds = %113
  %117 = load double, ptr %93, align 8
  %118 = fmul double %117, %117
  %119 = load double, ptr %94, align 8
  %120 = load ptr, ptr %95, align 8
  %121 = load double, ptr %96, align 8
  %122 = fcmp oeq double %121, 1.000000e+00
  %123 = fcmp oeq double %121, 2.000000e+00
  br label %155

124:                                              ; preds = %104, %134
  %125 = phi i64 [ 0, %104 ], [ %135, %134 ]
  %126 = getelementptr inbounds double, ptr %106, i64 %125
  %127 = load double, ptr %126, align 8
  %128 = fadd double %127, 1.000000e+00
  %129 = fmul double %128, 5.000000e-01
  %130 = fadd double %129, %105
  %131 = fdiv double %130, %92
  br i1 %108, label %132, label %134

132:                                              ; preds = %124
  %133 = mul nsw i64 %107, %125
  br label %137

134:                                              ; preds = %137, %124
  %135 = add nuw nsw i64 %125, 1
  %136 = icmp eq i64 %135, %99
  br i1 %136, label %109, label %124

137:                                              ; preds = %132, %137
  %138 = phi i64 [ 0, %132 ], [ %148, %137 ]
  %139 = getelementptr inbounds double, ptr %1, i64 %138
  %140 = load double, ptr %139, align 8
  %141 = getelementptr inbounds double, ptr %2, i64 %138
  %142 = load double, ptr %141, align 8
  %143 = fsub double %142, %140
  %144 = fmul double %131, %143
  %145 = fadd double %140, %144
  %146 = add nsw i64 %133, %138
  %147 = getelementptr inbounds [512 x double], ptr %4, i64 0, i64 %146
  store double %145, ptr %147, align 8
  %148 = add nuw nsw i64 %138, 1
  %149 = icmp eq i64 %148, %107
  br i1 %149, label %134, label %137

150:                                              ; preds = %172, %113
  %151 = phi double [ %101, %113 ], [ %175, %172 ]
  %152 = add nuw nsw i64 %102, 1
  %153 = icmp slt i64 %152, %85
  %154 = icmp eq i64 %152, %85
  br i1 %154, label %179, label %98

155:                                              ; preds = %116, %172
  %156 = phi i64 [ 0, %116 ], [ %176, %172 ]
  %157 = phi double [ %101, %116 ], [ %175, %172 ]
  %158 = getelementptr inbounds [8 x double], ptr %5, i64 0, i64 %156
  %159 = load double, ptr %158, align 8
  %160 = fmul double %159, %159
  %161 = fadd double %160, %118
  %162 = call double @llvm.sqrt.f64(double %161)
  %163 = call double @llvm.maxnum.f64(double %162, double %119)
  %164 = getelementptr inbounds double, ptr %120, i64 %156
  %165 = load double, ptr %164, align 8
  %166 = fmul double %165, 5.000000e-01
  br i1 %122, label %172, label %167

167:                                              ; preds = %155
  br i1 %123, label %168, label %170

168:                                              ; preds = %167
  %169 = fmul double %163, %163
  br label %172

170:                                              ; preds = %167
  %171 = call double @llvm.pow.f64(double %163, double %121)
  br label %172

172:                                              ; preds = %155, %168, %170
  %173 = phi double [ %169, %168 ], [ %171, %170 ], [ %163, %155 ]
  %174 = fdiv double %166, %173
  %175 = fadd double %157, %174
  %176 = add nuw nsw i64 %156, 1
  %177 = icmp eq i64 %176, %114
  br i1 %177, label %150, label %155

178:                                              ; preds = %109
  br i1 %100, label %184, label %179

179:                                              ; preds = %150, %87, %178
  %180 = phi double [ %88, %87 ], [ %92, %178 ], [ %92, %150 ]
  %181 = phi double [ 0.000000e+00, %87 ], [ %101, %178 ], [ %151, %150 ]
  %182 = fmul double %58, %181
  %183 = fdiv double %182, %180
  br label %184

184:                                              ; preds = %64, %179, %178, %56
  %185 = phi double [ %58, %56 ], [ %183, %179 ], [ 0x7FF0000000000000, %178 ], [ 0.000000e+00, %64 ]
  call void @llvm.lifetime.end.p0(i64 64, ptr nonnull %5) #4
  call void @llvm.lifetime.end.p0(i64 4096, ptr nonnull %4) #4
  ret double %185
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare double @llvm.ceil.f64(double) #2

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

declare double @llvm.sqrt.f64(double) #2

declare double @llvm.maxnum.f64(double, double) #2

declare double @llvm.pow.f64(double, double) #2

define dso_local double @manipplan_way_cost(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, i64 noundef %2) local_unnamed_addr #0 {
  %4 = icmp sgt i64 %2, 1
  br i1 %4, label %7, label %5

5:                                                ; preds = %7, %3
  %6 = phi double [ 0.000000e+00, %3 ], [ %17, %7 ]
  ret double %6

7:                                                ; preds = %3, %7
  %8 = phi i64 [ %18, %7 ], [ 1, %3 ]
  %9 = phi i64 [ %8, %7 ], [ 0, %3 ]
  %10 = phi double [ %17, %7 ], [ 0.000000e+00, %3 ]
  %11 = load i64, ptr %0, align 8
  %12 = mul nsw i64 %11, %9
  %13 = getelementptr inbounds double, ptr %1, i64 %12
  %14 = mul nsw i64 %11, %8
  %15 = getelementptr inbounds double, ptr %1, i64 %14
  %16 = tail call double @manipplan_edge_cost(ptr noundef nonnull %0, ptr noundef %13, ptr noundef %15)
  %17 = fadd double %10, %16
  %18 = add nuw nsw i64 %8, 1
  %19 = icmp eq i64 %18, %2
  br i1 %19, label %5, label %7
}

define dso_local i64 @manipplan_improve(ptr nocapture noundef %0, ptr nocapture noundef %1, ptr noundef %2, i64 noundef %3, i64 noundef %4, i64 noundef %5) local_unnamed_addr #0 {
  %7 = alloca [2 x [64 x double]], align 16
  %8 = alloca [64 x double], align 16
  %9 = load i64, ptr %0, align 8
  %10 = shl i64 %9, 3
  %11 = icmp sgt i64 %5, 0
  br i1 %11, label %12, label %21

12:                                               ; preds = %6
  %13 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 16
  %14 = getelementptr inbounds [2 x [64 x double]], ptr %7, i64 0, i64 1
  %15 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 15
  %16 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 1
  %17 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 2
  %18 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 14
  %19 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 12
  %20 = getelementptr inbounds %struct.Star, ptr %0, i64 0, i32 13
  br label %23

21:                                               ; preds = %411, %6
  %22 = phi i64 [ %3, %6 ], [ %412, %411 ]
  ret i64 %22

23:                                               ; preds = %12, %411
  %24 = phi i64 [ %3, %12 ], [ %412, %411 ]
  %25 = phi i64 [ 0, %12 ], [ %413, %411 ]
  call void @llvm.lifetime.start.p0(i64 1024, ptr nonnull %7) #4
  call void @llvm.lifetime.start.p0(i64 512, ptr nonnull %8) #4
  %26 = icmp sgt i64 %24, 1
  %27 = load i64, ptr %0, align 8
  br i1 %26, label %28, label %30

28:                                               ; preds = %23
  %29 = icmp sgt i64 %27, 0
  br label %252

30:                                               ; preds = %272, %23
  %31 = phi double [ 0.000000e+00, %23 ], [ %275, %272 ]
  %32 = load i64, ptr %13, align 8
  %33 = add i64 %32, -7046029254386353131
  %34 = lshr i64 %33, 30
  %35 = xor i64 %34, %33
  %36 = mul i64 %35, -4658895280553007687
  %37 = lshr i64 %36, 27
  %38 = xor i64 %37, %36
  %39 = mul i64 %38, -7723592293110705685
  %40 = lshr i64 %39, 42
  %41 = lshr i64 %39, 11
  %42 = xor i64 %40, %41
  %43 = uitofp i64 %42 to double
  %44 = fmul double %43, 0x3CA0000000000000
  %45 = fmul double %31, %44
  %46 = fmul double %44, %45
  %47 = fsub double %31, %46
  %48 = add i64 %32, 4354685564936845354
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
  %60 = fmul double %59, %47
  %61 = add i64 %32, -2691343689449507777
  %62 = lshr i64 %61, 30
  %63 = xor i64 %62, %61
  %64 = mul i64 %63, -4658895280553007687
  %65 = lshr i64 %64, 27
  %66 = xor i64 %65, %64
  %67 = mul i64 %66, -7723592293110705685
  %68 = lshr i64 %67, 42
  %69 = lshr i64 %67, 11
  %70 = xor i64 %68, %69
  %71 = uitofp i64 %70 to double
  %72 = fmul double %71, 0x3CA0000000000000
  %73 = icmp sgt i64 %27, 0
  br label %74

74:                                               ; preds = %119, %30
  %75 = phi i64 [ 0, %30 ], [ %121, %119 ]
  %76 = phi double [ %60, %30 ], [ %120, %119 ]
  %77 = mul nsw i64 %75, %27
  %78 = getelementptr inbounds double, ptr %1, i64 %77
  %79 = getelementptr inbounds double, ptr %78, i64 %27
  br i1 %73, label %80, label %92

80:                                               ; preds = %74, %80
  %81 = phi i64 [ %90, %80 ], [ 0, %74 ]
  %82 = phi double [ %89, %80 ], [ 0.000000e+00, %74 ]
  %83 = getelementptr inbounds double, ptr %79, i64 %81
  %84 = load double, ptr %83, align 8
  %85 = getelementptr inbounds double, ptr %78, i64 %81
  %86 = load double, ptr %85, align 8
  %87 = fsub double %84, %86
  %88 = fmul double %87, %87
  %89 = fadd double %82, %88
  %90 = add nuw nsw i64 %81, 1
  %91 = icmp eq i64 %90, %27
  br i1 %91, label %92, label %80

92:                                               ; preds = %80, %74
  %93 = phi double [ 0.000000e+00, %74 ], [ %89, %80 ]
  %94 = call double @llvm.sqrt.f64(double %93)
  %95 = fcmp olt double %76, %94
  %96 = add nuw nsw i64 %75, 2
  %97 = icmp eq i64 %96, %24
  %98 = select i1 %95, i1 true, i1 %97
  br i1 %98, label %99, label %119

99:                                               ; preds = %92
  %100 = fcmp olt double %72, 5.000000e-01
  %101 = fcmp ogt double %94, 0.000000e+00
  br i1 %101, label %102, label %105

102:                                              ; preds = %99
  %103 = fdiv double %76, %94
  %104 = call double @llvm.minnum.f64(double %103, double 1.000000e+00)
  br label %105

105:                                              ; preds = %102, %99
  %106 = phi double [ %104, %102 ], [ 0.000000e+00, %99 ]
  br i1 %73, label %107, label %122

107:                                              ; preds = %105, %107
  %108 = phi i64 [ %117, %107 ], [ 0, %105 ]
  %109 = getelementptr inbounds double, ptr %78, i64 %108
  %110 = load double, ptr %109, align 8
  %111 = getelementptr inbounds double, ptr %79, i64 %108
  %112 = load double, ptr %111, align 8
  %113 = fsub double %112, %110
  %114 = fmul double %106, %113
  %115 = fadd double %110, %114
  %116 = getelementptr inbounds double, ptr %7, i64 %108
  store double %115, ptr %116, align 8
  %117 = add nuw nsw i64 %108, 1
  %118 = icmp eq i64 %117, %27
  br i1 %118, label %122, label %107

119:                                              ; preds = %92
  %120 = fsub double %76, %94
  %121 = add nuw nsw i64 %75, 1
  br label %74

122:                                              ; preds = %107, %105
  %123 = fadd double %46, %60
  br label %124

124:                                              ; preds = %168, %122
  %125 = phi i64 [ 0, %122 ], [ %170, %168 ]
  %126 = phi double [ %123, %122 ], [ %169, %168 ]
  %127 = mul nsw i64 %125, %27
  %128 = getelementptr inbounds double, ptr %1, i64 %127
  %129 = getelementptr inbounds double, ptr %128, i64 %27
  br i1 %73, label %130, label %142

130:                                              ; preds = %124, %130
  %131 = phi i64 [ %140, %130 ], [ 0, %124 ]
  %132 = phi double [ %139, %130 ], [ 0.000000e+00, %124 ]
  %133 = getelementptr inbounds double, ptr %129, i64 %131
  %134 = load double, ptr %133, align 8
  %135 = getelementptr inbounds double, ptr %128, i64 %131
  %136 = load double, ptr %135, align 8
  %137 = fsub double %134, %136
  %138 = fmul double %137, %137
  %139 = fadd double %132, %138
  %140 = add nuw nsw i64 %131, 1
  %141 = icmp eq i64 %140, %27
  br i1 %141, label %142, label %130

142:                                              ; preds = %130, %124
  %143 = phi double [ 0.000000e+00, %124 ], [ %139, %130 ]
  %144 = call double @llvm.sqrt.f64(double %143)
  %145 = fcmp olt double %126, %144
  %146 = add nuw nsw i64 %125, 2
  %147 = icmp eq i64 %146, %24
  %148 = select i1 %145, i1 true, i1 %147
  br i1 %148, label %149, label %168

149:                                              ; preds = %142
  %150 = fcmp ogt double %144, 0.000000e+00
  br i1 %150, label %151, label %154

151:                                              ; preds = %149
  %152 = fdiv double %126, %144
  %153 = call double @llvm.minnum.f64(double %152, double 1.000000e+00)
  br label %154

154:                                              ; preds = %151, %149
  %155 = phi double [ %153, %151 ], [ 0.000000e+00, %149 ]
  br i1 %73, label %156, label %171

156:                                              ; preds = %154, %156
  %157 = phi i64 [ %166, %156 ], [ 0, %154 ]
  %158 = getelementptr inbounds double, ptr %128, i64 %157
  %159 = load double, ptr %158, align 8
  %160 = getelementptr inbounds double, ptr %129, i64 %157
  %161 = load double, ptr %160, align 8
  %162 = fsub double %161, %159
  %163 = fmul double %155, %162
  %164 = fadd double %159, %163
  %165 = getelementptr inbounds double, ptr %14, i64 %157
  store double %164, ptr %165, align 8
  %166 = add nuw nsw i64 %157, 1
  %167 = icmp eq i64 %166, %27
  br i1 %167, label %171, label %156

168:                                              ; preds = %142
  %169 = fsub double %126, %144
  %170 = add nuw nsw i64 %125, 1
  br label %124

171:                                              ; preds = %156, %154
  %172 = add i64 %32, 8709371129873690708
  %173 = lshr i64 %172, 30
  %174 = xor i64 %173, %172
  %175 = mul i64 %174, -4658895280553007687
  %176 = lshr i64 %175, 27
  %177 = xor i64 %176, %175
  %178 = mul i64 %177, -7723592293110705685
  %179 = lshr i64 %178, 42
  %180 = lshr i64 %178, 11
  %181 = xor i64 %179, %180
  %182 = uitofp i64 %181 to double
  %183 = fmul double %182, 0x3CA0000000000000
  %184 = fmul double %183, %46
  %185 = fadd double %184, %60
  br label %186

186:                                              ; preds = %230, %171
  %187 = phi i64 [ 0, %171 ], [ %232, %230 ]
  %188 = phi double [ %185, %171 ], [ %231, %230 ]
  %189 = mul nsw i64 %187, %27
  %190 = getelementptr inbounds double, ptr %1, i64 %189
  %191 = getelementptr inbounds double, ptr %190, i64 %27
  br i1 %73, label %192, label %204

192:                                              ; preds = %186, %192
  %193 = phi i64 [ %202, %192 ], [ 0, %186 ]
  %194 = phi double [ %201, %192 ], [ 0.000000e+00, %186 ]
  %195 = getelementptr inbounds double, ptr %191, i64 %193
  %196 = load double, ptr %195, align 8
  %197 = getelementptr inbounds double, ptr %190, i64 %193
  %198 = load double, ptr %197, align 8
  %199 = fsub double %196, %198
  %200 = fmul double %199, %199
  %201 = fadd double %194, %200
  %202 = add nuw nsw i64 %193, 1
  %203 = icmp eq i64 %202, %27
  br i1 %203, label %204, label %192

204:                                              ; preds = %192, %186
  %205 = phi double [ 0.000000e+00, %186 ], [ %201, %192 ]
  %206 = call double @llvm.sqrt.f64(double %205)
  %207 = fcmp olt double %188, %206
  %208 = add nuw nsw i64 %187, 2
  %209 = icmp eq i64 %208, %24
  %210 = select i1 %207, i1 true, i1 %209
  br i1 %210, label %211, label %230

211:                                              ; preds = %204
  %212 = fcmp ogt double %206, 0.000000e+00
  br i1 %212, label %213, label %216

213:                                              ; preds = %211
  %214 = fdiv double %188, %206
  %215 = call double @llvm.minnum.f64(double %214, double 1.000000e+00)
  br label %216

216:                                              ; preds = %213, %211
  %217 = phi double [ %215, %213 ], [ 0.000000e+00, %211 ]
  br i1 %73, label %218, label %233

218:                                              ; preds = %216, %218
  %219 = phi i64 [ %228, %218 ], [ 0, %216 ]
  %220 = getelementptr inbounds double, ptr %190, i64 %219
  %221 = load double, ptr %220, align 8
  %222 = getelementptr inbounds double, ptr %191, i64 %219
  %223 = load double, ptr %222, align 8
  %224 = fsub double %223, %221
  %225 = fmul double %217, %224
  %226 = fadd double %221, %225
  %227 = getelementptr inbounds double, ptr %8, i64 %219
  store double %226, ptr %227, align 8
  %228 = add nuw nsw i64 %219, 1
  %229 = icmp eq i64 %228, %27
  br i1 %229, label %233, label %218

230:                                              ; preds = %204
  %231 = fsub double %188, %206
  %232 = add nuw nsw i64 %187, 1
  br label %186

233:                                              ; preds = %218, %216
  %234 = load double, ptr %15, align 8
  %235 = fmul double %46, %234
  %236 = add i64 %32, 1663341875487337577
  store i64 %236, ptr %13, align 8
  %237 = lshr i64 %236, 30
  %238 = xor i64 %237, %236
  %239 = mul i64 %238, -4658895280553007687
  %240 = lshr i64 %239, 27
  %241 = xor i64 %240, %239
  %242 = mul i64 %241, -7723592293110705685
  %243 = lshr i64 %242, 42
  %244 = lshr i64 %242, 11
  %245 = xor i64 %243, %244
  %246 = uitofp i64 %245 to double
  %247 = fmul double %246, 0x3CA0000000000000
  %248 = fmul double %247, %235
  br i1 %73, label %249, label %279

249:                                              ; preds = %233
  %250 = load ptr, ptr %16, align 8
  %251 = load ptr, ptr %17, align 8
  br label %282

252:                                              ; preds = %28, %272
  %253 = phi i64 [ 1, %28 ], [ %276, %272 ]
  %254 = phi double [ 0.000000e+00, %28 ], [ %275, %272 ]
  %255 = phi i64 [ 0, %28 ], [ %253, %272 ]
  %256 = mul nsw i64 %27, %255
  %257 = getelementptr inbounds double, ptr %1, i64 %256
  %258 = mul nsw i64 %27, %253
  %259 = getelementptr inbounds double, ptr %1, i64 %258
  br i1 %29, label %260, label %272

260:                                              ; preds = %252, %260
  %261 = phi i64 [ %270, %260 ], [ 0, %252 ]
  %262 = phi double [ %269, %260 ], [ 0.000000e+00, %252 ]
  %263 = getelementptr inbounds double, ptr %259, i64 %261
  %264 = load double, ptr %263, align 8
  %265 = getelementptr inbounds double, ptr %257, i64 %261
  %266 = load double, ptr %265, align 8
  %267 = fsub double %264, %266
  %268 = fmul double %267, %267
  %269 = fadd double %262, %268
  %270 = add nuw nsw i64 %261, 1
  %271 = icmp eq i64 %270, %27
  br i1 %271, label %272, label %260

272:                                              ; preds = %260, %252
  %273 = phi double [ 0.000000e+00, %252 ], [ %269, %260 ]
  %274 = call double @llvm.sqrt.f64(double %273)
  %275 = fadd double %254, %274
  %276 = add nuw nsw i64 %253, 1
  %277 = icmp eq i64 %276, %24
  br i1 %277, label %30, label %252

278:                                              ; preds = %282
  store i64 %287, ptr %13, align 8
  br label %279

279:                                              ; preds = %278, %233
  %280 = icmp ne i64 %75, %125
  %281 = select i1 %280, i1 true, i1 %100
  br i1 %281, label %311, label %411

282:                                              ; preds = %249, %282
  %283 = phi i64 [ %236, %249 ], [ %287, %282 ]
  %284 = phi i64 [ 0, %249 ], [ %309, %282 ]
  %285 = getelementptr inbounds [64 x double], ptr %8, i64 0, i64 %284
  %286 = load double, ptr %285, align 8
  %287 = add i64 %283, -7046029254386353131
  %288 = lshr i64 %287, 30
  %289 = xor i64 %288, %287
  %290 = mul i64 %289, -4658895280553007687
  %291 = lshr i64 %290, 27
  %292 = xor i64 %291, %290
  %293 = mul i64 %292, -7723592293110705685
  %294 = lshr i64 %293, 42
  %295 = lshr i64 %293, 11
  %296 = xor i64 %294, %295
  %297 = uitofp i64 %296 to double
  %298 = fmul double %297, 0x3CA0000000000000
  %299 = fmul double %298, 2.000000e+00
  %300 = fadd double %299, -1.000000e+00
  %301 = fmul double %248, %300
  %302 = fadd double %286, %301
  %303 = getelementptr inbounds double, ptr %250, i64 %284
  %304 = load double, ptr %303, align 8
  %305 = call double @llvm.maxnum.f64(double %302, double %304)
  %306 = getelementptr inbounds double, ptr %251, i64 %284
  %307 = load double, ptr %306, align 8
  %308 = call double @llvm.minnum.f64(double %305, double %307)
  store double %308, ptr %285, align 8
  %309 = add nuw nsw i64 %284, 1
  %310 = icmp eq i64 %309, %27
  br i1 %310, label %278, label %282

311:                                              ; preds = %279
  %312 = xor i64 %125, -1
  %313 = add i64 %24, %312
  %314 = add i64 %313, 4
  %315 = add i64 %314, %75
  %316 = icmp sgt i64 %315, %4
  br i1 %316, label %411, label %317

317:                                              ; preds = %311
  %318 = add nuw nsw i64 %75, 1
  %319 = mul i64 %318, %10
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %2, ptr align 8 %1, i64 %319, i1 false)
  %320 = load i64, ptr %0, align 8
  %321 = mul nsw i64 %320, %318
  %322 = getelementptr inbounds double, ptr %2, i64 %321
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %322, ptr nonnull align 16 %7, i64 %10, i1 false)
  br i1 %100, label %323, label %328

323:                                              ; preds = %317
  %324 = add nuw nsw i64 %75, 3
  %325 = load i64, ptr %0, align 8
  %326 = mul nsw i64 %325, %96
  %327 = getelementptr inbounds double, ptr %2, i64 %326
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %327, ptr nonnull align 16 %8, i64 %10, i1 false)
  br label %328

328:                                              ; preds = %323, %317
  %329 = phi i64 [ %324, %323 ], [ %96, %317 ]
  %330 = add nsw i64 %329, 1
  %331 = load i64, ptr %0, align 8
  %332 = mul nsw i64 %331, %329
  %333 = getelementptr inbounds double, ptr %2, i64 %332
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %333, ptr nonnull align 16 %14, i64 %10, i1 false)
  %334 = load i64, ptr %0, align 8
  %335 = mul nsw i64 %334, %330
  %336 = getelementptr inbounds double, ptr %2, i64 %335
  %337 = add nuw nsw i64 %125, 1
  %338 = mul nsw i64 %334, %337
  %339 = getelementptr inbounds double, ptr %1, i64 %338
  %340 = mul i64 %313, %10
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %336, ptr align 8 %339, i64 %340, i1 false)
  %341 = add nsw i64 %330, %313
  %342 = load i64, ptr %0, align 8
  %343 = mul nsw i64 %342, %75
  %344 = getelementptr inbounds double, ptr %1, i64 %343
  %345 = sub nsw i64 %146, %75
  %346 = icmp sgt i64 %345, 1
  br i1 %346, label %347, label %363

347:                                              ; preds = %328, %347
  %348 = phi i64 [ %358, %347 ], [ 1, %328 ]
  %349 = phi i64 [ %348, %347 ], [ 0, %328 ]
  %350 = phi double [ %357, %347 ], [ 0.000000e+00, %328 ]
  %351 = load i64, ptr %0, align 8
  %352 = mul nsw i64 %351, %349
  %353 = getelementptr inbounds double, ptr %344, i64 %352
  %354 = mul nsw i64 %351, %348
  %355 = getelementptr inbounds double, ptr %344, i64 %354
  %356 = call double @manipplan_edge_cost(ptr noundef nonnull %0, ptr noundef %353, ptr noundef %355)
  %357 = fadd double %350, %356
  %358 = add nuw nsw i64 %348, 1
  %359 = icmp eq i64 %358, %345
  br i1 %359, label %360, label %347

360:                                              ; preds = %347
  %361 = load i64, ptr %0, align 8
  %362 = mul nsw i64 %361, %75
  br label %363

363:                                              ; preds = %360, %328
  %364 = phi i64 [ %362, %360 ], [ %343, %328 ]
  %365 = phi double [ %357, %360 ], [ 0.000000e+00, %328 ]
  %366 = getelementptr inbounds double, ptr %2, i64 %364
  %367 = sub nsw i64 2, %75
  %368 = add i64 %367, %329
  %369 = icmp sgt i64 %368, 1
  br i1 %369, label %370, label %383

370:                                              ; preds = %363, %370
  %371 = phi i64 [ %381, %370 ], [ 1, %363 ]
  %372 = phi i64 [ %371, %370 ], [ 0, %363 ]
  %373 = phi double [ %380, %370 ], [ 0.000000e+00, %363 ]
  %374 = load i64, ptr %0, align 8
  %375 = mul nsw i64 %374, %372
  %376 = getelementptr inbounds double, ptr %366, i64 %375
  %377 = mul nsw i64 %374, %371
  %378 = getelementptr inbounds double, ptr %366, i64 %377
  %379 = call double @manipplan_edge_cost(ptr noundef nonnull %0, ptr noundef %376, ptr noundef %378)
  %380 = fadd double %373, %379
  %381 = add nuw nsw i64 %371, 1
  %382 = icmp eq i64 %381, %368
  br i1 %382, label %383, label %370

383:                                              ; preds = %370, %363
  %384 = phi double [ 0.000000e+00, %363 ], [ %380, %370 ]
  %385 = fmul double %365, 9.999000e-01
  %386 = fcmp olt double %384, %385
  br i1 %386, label %387, label %411

387:                                              ; preds = %383
  %388 = load ptr, ptr %18, align 8
  %389 = load ptr, ptr %19, align 8
  %390 = call i32 %388(ptr noundef %389, ptr noundef %2, i64 noundef %341) #4
  %391 = icmp eq i32 %390, 0
  br i1 %391, label %411, label %392

392:                                              ; preds = %387
  %393 = load ptr, ptr %20, align 8
  %394 = load ptr, ptr %19, align 8
  %395 = call i32 %393(ptr noundef %394, ptr noundef nonnull %7, ptr noundef nonnull %7) #4
  %396 = icmp eq i32 %395, 0
  br i1 %396, label %411, label %397

397:                                              ; preds = %392
  %398 = load ptr, ptr %20, align 8
  %399 = load ptr, ptr %19, align 8
  %400 = select i1 %100, ptr %8, ptr %14
  %401 = call i32 %398(ptr noundef %399, ptr noundef nonnull %7, ptr noundef nonnull %400) #4
  %402 = icmp eq i32 %401, 0
  br i1 %402, label %411, label %403

403:                                              ; preds = %397
  br i1 %100, label %404, label %409

404:                                              ; preds = %403
  %405 = load ptr, ptr %20, align 8
  %406 = load ptr, ptr %19, align 8
  %407 = call i32 %405(ptr noundef %406, ptr noundef nonnull %8, ptr noundef nonnull %14) #4
  %408 = icmp eq i32 %407, 0
  br i1 %408, label %411, label %409

409:                                              ; preds = %404, %403
  %410 = mul i64 %341, %10
  call void @llvm.memcpy.p0.p0.i64(ptr align 8 %1, ptr align 8 %2, i64 %410, i1 false)
  br label %411

411:                                              ; preds = %311, %397, %404, %392, %383, %387, %409, %279
  %412 = phi i64 [ %24, %279 ], [ %24, %311 ], [ %341, %409 ], [ %24, %387 ], [ %24, %383 ], [ %24, %392 ], [ %24, %404 ], [ %24, %397 ]
  call void @llvm.lifetime.end.p0(i64 512, ptr nonnull %8) #4
  call void @llvm.lifetime.end.p0(i64 1024, ptr nonnull %7) #4
  %413 = add nuw nsw i64 %25, 1
  %414 = icmp eq i64 %413, %5
  br i1 %414, label %21, label %23
}

declare double @llvm.minnum.f64(double, double) #2

declare void @llvm.memcpy.p0.p0.i64(ptr noalias nocapture writeonly, ptr noalias nocapture readonly, i64, i1 immarg) #3

attributes #0 = { nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #3 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #4 = { nounwind }


