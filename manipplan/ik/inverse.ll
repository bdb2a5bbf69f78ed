; inverse.c 94406112d76fd516cd6b4672823e1bdc54c679037afe21bd91294a2bde799b2d: written by make kernel

%struct.Turn = type { double, double }
%struct.Vector = type { double, double, double }
%struct.Turns = type { i64, [2 x %struct.Turn] }
%struct.Complex = type { double, double }
%struct.Arrangement = type { i64, %struct.Vector, double }
%struct.Chain = type { [21 x double], [21 x double], [7 x double], [7 x double], i64, i64, %struct.Arrangement }
%struct.Form = type { i64, i64, i64, i64, i64, i64, i64, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr, ptr }
%struct.Samples = type { ptr, ptr, ptr, i64, i64 }
%struct.Solutions = type { ptr, ptr, i64, i64 }
%struct.State = type { [3 x [4 x double]], ptr, ptr, [6 x double] }
%struct.Screws = type { i64, ptr, ptr, ptr, ptr, ptr, i64, ptr, ptr, ptr }

@still = internal unnamed_addr constant %struct.Turn { double 1.000000e+00, double 0.000000e+00 }, align 8

define dso_local i64 @manipplan_solutions(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, i64 noundef %2, i64 noundef %3, ptr noundef %4, ptr nocapture noundef %5) local_unnamed_addr #0 {
  %7 = alloca %struct.Vector, align 8
  %8 = alloca %struct.Vector, align 8
  %9 = alloca %struct.Vector, align 8
  %10 = alloca [2 x [3 x %struct.Turn]], align 16
  %11 = alloca [2 x [3 x %struct.Turn]], align 16
  %12 = alloca %struct.Turns, align 8
  %13 = alloca [3 x [3 x double]], align 16
  %14 = alloca [3 x [3 x double]], align 16
  %15 = alloca [3 x [4 x double]], align 16
  %16 = alloca [3 x [4 x double]], align 16
  %17 = alloca %struct.Vector, align 8
  %18 = alloca %struct.Vector, align 8
  %19 = alloca %struct.Vector, align 8
  %20 = alloca %struct.Vector, align 8
  %21 = alloca %struct.Vector, align 8
  %22 = alloca %struct.Vector, align 8
  %23 = alloca %struct.Vector, align 8
  %24 = alloca %struct.Vector, align 8
  %25 = alloca %struct.Vector, align 8
  %26 = alloca %struct.Vector, align 8
  %27 = alloca %struct.Vector, align 8
  %28 = alloca %struct.Vector, align 8
  %29 = alloca %struct.Turns, align 8
  %30 = alloca %struct.Vector, align 8
  %31 = alloca %struct.Turns, align 8
  %32 = alloca %struct.Turns, align 8
  %33 = alloca %struct.Vector, align 8
  %34 = alloca %struct.Vector, align 8
  %35 = alloca %struct.Vector, align 8
  %36 = alloca %struct.Vector, align 8
  %37 = alloca %struct.Vector, align 8
  %38 = alloca %struct.Vector, align 8
  %39 = alloca %struct.Vector, align 8
  %40 = alloca %struct.Vector, align 8
  %41 = alloca [4 x double], align 16
  %42 = alloca [4 x %struct.Complex], align 16
  %43 = alloca %struct.Vector, align 8
  %44 = alloca %struct.Vector, align 8
  %45 = alloca %struct.Vector, align 8
  %46 = alloca %struct.Vector, align 8
  %47 = alloca %struct.Turns, align 8
  %48 = alloca [2 x %struct.Turn], align 16
  %49 = alloca %struct.Turns, align 8
  %50 = alloca %struct.Vector, align 8
  %51 = alloca %struct.Vector, align 8
  %52 = alloca %struct.Turns, align 8
  %53 = alloca [2 x %struct.Turn], align 16
  %54 = alloca %struct.Turns, align 8
  %55 = alloca %struct.Vector, align 8
  %56 = alloca %struct.Turns, align 8
  %57 = alloca %struct.Vector, align 8
  %58 = alloca %struct.Turns, align 8
  %59 = alloca %struct.Turns, align 8
  %60 = alloca %struct.Vector, align 8
  %61 = alloca %struct.Turns, align 8
  %62 = alloca %struct.Vector, align 8
  %63 = alloca %struct.Vector, align 8
  %64 = alloca %struct.Vector, align 8
  %65 = alloca [4 x [3 x %struct.Turn]], align 16
  %66 = alloca [2 x [3 x %struct.Turn]], align 16
  %67 = alloca [3 x [4 x double]], align 16
  %68 = alloca %struct.Arrangement, align 8
  %69 = alloca %struct.Vector, align 8
  %70 = alloca [3 x [4 x double]], align 16
  %71 = alloca [3 x [4 x double]], align 16
  %72 = alloca %struct.Vector, align 8
  %73 = alloca %struct.Vector, align 8
  %74 = alloca %struct.Vector, align 8
  %75 = alloca %struct.Vector, align 8
  %76 = alloca %struct.Vector, align 8
  %77 = alloca %struct.Arrangement, align 8
  %78 = alloca %struct.Chain, align 8
  %79 = alloca [63 x double], align 16
  %80 = alloca [3 x [4 x double]], align 16
  call void @llvm.lifetime.start.p0(i64 504, ptr nonnull %78) #13
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(504) %78, i8 0, i64 504, i1 false)
  %81 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 4
  %82 = load i64, ptr %0, align 8
  store i64 %82, ptr %81, align 8
  %83 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 5
  store i64 -1, ptr %83, align 8
  %84 = mul nsw i64 %82, 3
  %85 = getelementptr inbounds double, ptr %4, i64 %84
  %86 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 2
  %87 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1
  %88 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 2
  %89 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 3
  call void @llvm.lifetime.start.p0(i64 504, ptr nonnull %79) #13
  %90 = load i64, ptr %86, align 8
  %91 = icmp sgt i64 %90, 0
  br i1 %91, label %96, label %92

92:                                               ; preds = %6
  %93 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 7
  %94 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 8
  %95 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 4
  br label %148

96:                                               ; preds = %6
  %97 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 11
  %98 = load ptr, ptr %97, align 8
  %99 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 14
  %100 = load ptr, ptr %99, align 8
  %101 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 15
  %102 = load ptr, ptr %101, align 8
  br label %342

103:                                              ; preds = %360
  %104 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 7
  %105 = load ptr, ptr %104, align 8
  %106 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 8
  %107 = load ptr, ptr %106, align 8
  %108 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 4
  %109 = load i64, ptr %108, align 8
  %110 = icmp eq i64 %109, 0
  %111 = select i1 %110, double 1.000000e+00, double -1.000000e+00
  br i1 %91, label %112, label %148

112:                                              ; preds = %103
  %113 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 11
  %114 = load ptr, ptr %113, align 8
  br label %115

115:                                              ; preds = %115, %112
  %116 = phi i64 [ 0, %112 ], [ %146, %115 ]
  %117 = getelementptr inbounds i64, ptr %114, i64 %116
  %118 = load i64, ptr %117, align 8
  %119 = mul nsw i64 %118, 3
  %120 = getelementptr inbounds double, ptr %105, i64 %119
  %121 = load double, ptr %120, align 8
  %122 = add nsw i64 %119, 1
  %123 = getelementptr inbounds double, ptr %105, i64 %122
  %124 = load double, ptr %123, align 8
  %125 = add nsw i64 %119, 2
  %126 = getelementptr inbounds double, ptr %105, i64 %125
  %127 = load double, ptr %126, align 8
  %128 = fmul double %111, %121
  %129 = fmul double %111, %124
  %130 = fmul double %111, %127
  %131 = mul nuw nsw i64 %116, 3
  %132 = getelementptr inbounds double, ptr %78, i64 %131
  store double %128, ptr %132, align 8
  %133 = add nuw nsw i64 %131, 1
  %134 = getelementptr inbounds double, ptr %78, i64 %133
  store double %129, ptr %134, align 8
  %135 = add nuw nsw i64 %131, 2
  %136 = getelementptr inbounds double, ptr %78, i64 %135
  store double %130, ptr %136, align 8
  %137 = getelementptr inbounds double, ptr %107, i64 %119
  %138 = load double, ptr %137, align 8
  %139 = getelementptr inbounds double, ptr %107, i64 %122
  %140 = load double, ptr %139, align 8
  %141 = getelementptr inbounds double, ptr %107, i64 %125
  %142 = load double, ptr %141, align 8
  %143 = getelementptr inbounds double, ptr %87, i64 %131
  store double %138, ptr %143, align 8
  %144 = getelementptr inbounds double, ptr %87, i64 %133
  store double %140, ptr %144, align 8
  %145 = getelementptr inbounds double, ptr %87, i64 %135
  store double %142, ptr %145, align 8
  %146 = add nuw nsw i64 %116, 1
  %147 = icmp eq i64 %146, %90
  br i1 %147, label %148, label %115

148:                                              ; preds = %115, %92, %103
  %149 = phi ptr [ %95, %92 ], [ %108, %103 ], [ %108, %115 ]
  %150 = phi ptr [ %94, %92 ], [ %106, %103 ], [ %106, %115 ]
  %151 = phi ptr [ %93, %92 ], [ %104, %103 ], [ %104, %115 ]
  %152 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 6
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %77) #13
  call fastcc void @arrangement(ptr nonnull sret(%struct.Arrangement) align 8 %77, ptr noundef nonnull %78, ptr noundef nonnull %87)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(40) %152, ptr noundef nonnull align 8 dereferenceable(40) %77, i64 40, i1 false)
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %77) #13
  %153 = getelementptr inbounds %struct.Samples, ptr %1, i64 0, i32 3
  %154 = load i64, ptr %153, align 8
  %155 = icmp sgt i64 %154, %2
  br i1 %155, label %156, label %3617

156:                                              ; preds = %148
  %157 = getelementptr inbounds %struct.Samples, ptr %1, i64 0, i32 2
  %158 = getelementptr inbounds %struct.Samples, ptr %1, i64 0, i32 4
  %159 = getelementptr inbounds %struct.Solutions, ptr %5, i64 0, i32 3
  %160 = getelementptr inbounds %struct.Solutions, ptr %5, i64 0, i32 2
  %161 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 5
  %162 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 12
  %163 = getelementptr inbounds %struct.Samples, ptr %1, i64 0, i32 1
  %164 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 13
  %165 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 17
  %166 = getelementptr inbounds %struct.Vector, ptr %69, i64 0, i32 1
  %167 = getelementptr inbounds %struct.Vector, ptr %69, i64 0, i32 2
  %168 = getelementptr inbounds [3 x [4 x double]], ptr %70, i64 0, i64 1, i64 1
  %169 = getelementptr inbounds [3 x [4 x double]], ptr %70, i64 0, i64 2, i64 2
  %170 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 1
  %171 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 10
  %172 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 16
  %173 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 14
  %174 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 15
  %175 = getelementptr inbounds %struct.Vector, ptr %73, i64 0, i32 1
  %176 = getelementptr inbounds %struct.Vector, ptr %73, i64 0, i32 2
  %177 = getelementptr inbounds %struct.Vector, ptr %74, i64 0, i32 1
  %178 = getelementptr inbounds %struct.Vector, ptr %74, i64 0, i32 2
  %179 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 9
  %180 = getelementptr inbounds [4 x double], ptr %80, i64 0, i64 3
  %181 = getelementptr inbounds [4 x double], ptr %80, i64 1, i64 3
  %182 = getelementptr inbounds [4 x double], ptr %80, i64 2, i64 3
  %183 = getelementptr inbounds [4 x double], ptr %80, i64 0, i64 1
  %184 = getelementptr inbounds [4 x double], ptr %80, i64 0, i64 2
  %185 = getelementptr inbounds [4 x double], ptr %80, i64 1
  %186 = getelementptr inbounds [4 x double], ptr %80, i64 1, i64 1
  %187 = getelementptr inbounds [4 x double], ptr %80, i64 1, i64 2
  %188 = getelementptr inbounds [4 x double], ptr %80, i64 2
  %189 = getelementptr inbounds [4 x double], ptr %80, i64 2, i64 1
  %190 = getelementptr inbounds [4 x double], ptr %80, i64 2, i64 2
  %191 = getelementptr inbounds %struct.Vector, ptr %75, i64 0, i32 1
  %192 = getelementptr inbounds %struct.Vector, ptr %75, i64 0, i32 2
  %193 = getelementptr inbounds %struct.Vector, ptr %76, i64 0, i32 1
  %194 = getelementptr inbounds %struct.Vector, ptr %76, i64 0, i32 2
  %195 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 6
  %196 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 11
  %197 = getelementptr inbounds %struct.Form, ptr %0, i64 0, i32 3
  %198 = getelementptr inbounds %struct.Vector, ptr %25, i64 0, i32 1
  %199 = getelementptr inbounds double, ptr %78, i64 1
  %200 = getelementptr inbounds %struct.Vector, ptr %25, i64 0, i32 2
  %201 = getelementptr inbounds double, ptr %78, i64 2
  %202 = getelementptr inbounds double, ptr %78, i64 3
  %203 = getelementptr inbounds %struct.Vector, ptr %26, i64 0, i32 1
  %204 = getelementptr inbounds double, ptr %78, i64 4
  %205 = getelementptr inbounds %struct.Vector, ptr %26, i64 0, i32 2
  %206 = getelementptr inbounds double, ptr %78, i64 5
  %207 = getelementptr inbounds double, ptr %78, i64 12
  %208 = getelementptr inbounds %struct.Vector, ptr %27, i64 0, i32 1
  %209 = getelementptr inbounds double, ptr %78, i64 13
  %210 = getelementptr inbounds %struct.Vector, ptr %27, i64 0, i32 2
  %211 = getelementptr inbounds double, ptr %78, i64 14
  %212 = getelementptr inbounds double, ptr %78, i64 15
  %213 = getelementptr inbounds %struct.Vector, ptr %28, i64 0, i32 1
  %214 = getelementptr inbounds double, ptr %78, i64 16
  %215 = getelementptr inbounds %struct.Vector, ptr %28, i64 0, i32 2
  %216 = getelementptr inbounds double, ptr %78, i64 17
  %217 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1, i64 1
  %218 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1, i64 2
  %219 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1, i64 3
  %220 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1, i64 4
  %221 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1, i64 5
  %222 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1, i64 6
  %223 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1, i64 7
  %224 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1, i64 8
  %225 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1, i64 9
  %226 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1, i64 10
  %227 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 1, i64 11
  %228 = getelementptr inbounds double, ptr %78, i64 6
  %229 = getelementptr inbounds double, ptr %78, i64 7
  %230 = getelementptr inbounds double, ptr %78, i64 8
  %231 = getelementptr inbounds double, ptr %78, i64 9
  %232 = getelementptr inbounds double, ptr %78, i64 10
  %233 = getelementptr inbounds double, ptr %78, i64 11
  %234 = getelementptr inbounds %struct.Vector, ptr %30, i64 0, i32 1
  %235 = getelementptr inbounds %struct.Vector, ptr %30, i64 0, i32 2
  %236 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 2, i64 4
  %237 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 3, i64 4
  %238 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 2, i64 5
  %239 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 3, i64 5
  %240 = getelementptr inbounds i8, ptr %23, i64 8
  %241 = getelementptr inbounds i8, ptr %23, i64 16
  %242 = getelementptr inbounds i8, ptr %24, i64 8
  %243 = getelementptr inbounds i8, ptr %24, i64 16
  %244 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 2, i64 1
  %245 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 3, i64 1
  %246 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 2, i64 2
  %247 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 3, i64 2
  %248 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 2, i64 3
  %249 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 3, i64 3
  %250 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 6, i32 1
  %251 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 6, i32 1, i32 1
  %252 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 6, i32 1, i32 2
  %253 = getelementptr inbounds %struct.Vector, ptr %62, i64 0, i32 1
  %254 = getelementptr inbounds %struct.Vector, ptr %62, i64 0, i32 2
  %255 = getelementptr inbounds %struct.Vector, ptr %63, i64 0, i32 1
  %256 = getelementptr inbounds %struct.Vector, ptr %63, i64 0, i32 2
  %257 = getelementptr inbounds %struct.Vector, ptr %64, i64 0, i32 1
  %258 = getelementptr inbounds %struct.Vector, ptr %64, i64 0, i32 2
  %259 = getelementptr inbounds %struct.Vector, ptr %43, i64 0, i32 1
  %260 = getelementptr inbounds %struct.Vector, ptr %43, i64 0, i32 2
  %261 = getelementptr inbounds %struct.Vector, ptr %44, i64 0, i32 1
  %262 = getelementptr inbounds %struct.Vector, ptr %44, i64 0, i32 2
  %263 = getelementptr inbounds %struct.Vector, ptr %45, i64 0, i32 1
  %264 = getelementptr inbounds %struct.Vector, ptr %45, i64 0, i32 2
  %265 = getelementptr inbounds %struct.Vector, ptr %57, i64 0, i32 1
  %266 = getelementptr inbounds %struct.Vector, ptr %57, i64 0, i32 2
  %267 = getelementptr inbounds i8, ptr %35, i64 8
  %268 = getelementptr inbounds i8, ptr %35, i64 16
  %269 = getelementptr inbounds i8, ptr %36, i64 8
  %270 = getelementptr inbounds i8, ptr %36, i64 16
  %271 = getelementptr inbounds %struct.Vector, ptr %51, i64 0, i32 1
  %272 = getelementptr inbounds %struct.Vector, ptr %51, i64 0, i32 2
  %273 = getelementptr inbounds i8, ptr %37, i64 8
  %274 = getelementptr inbounds i8, ptr %37, i64 16
  %275 = getelementptr inbounds i8, ptr %38, i64 8
  %276 = getelementptr inbounds i8, ptr %38, i64 16
  %277 = getelementptr inbounds %struct.Vector, ptr %55, i64 0, i32 1
  %278 = getelementptr inbounds %struct.Vector, ptr %55, i64 0, i32 2
  %279 = getelementptr inbounds %struct.Vector, ptr %46, i64 0, i32 1
  %280 = getelementptr inbounds %struct.Vector, ptr %46, i64 0, i32 2
  %281 = getelementptr inbounds i8, ptr %39, i64 8
  %282 = getelementptr inbounds i8, ptr %39, i64 16
  %283 = getelementptr inbounds i8, ptr %40, i64 8
  %284 = getelementptr inbounds i8, ptr %40, i64 16
  %285 = getelementptr inbounds %struct.Vector, ptr %50, i64 0, i32 1
  %286 = getelementptr inbounds %struct.Vector, ptr %50, i64 0, i32 2
  %287 = getelementptr inbounds double, ptr %41, i64 1
  %288 = getelementptr inbounds double, ptr %41, i64 2
  %289 = getelementptr inbounds double, ptr %41, i64 3
  %290 = getelementptr inbounds %struct.Vector, ptr %60, i64 0, i32 1
  %291 = getelementptr inbounds %struct.Vector, ptr %60, i64 0, i32 2
  %292 = getelementptr inbounds i8, ptr %33, i64 8
  %293 = getelementptr inbounds i8, ptr %33, i64 16
  %294 = getelementptr inbounds i8, ptr %34, i64 8
  %295 = getelementptr inbounds i8, ptr %34, i64 16
  %296 = getelementptr inbounds i8, ptr %7, i64 8
  %297 = getelementptr inbounds i8, ptr %7, i64 16
  %298 = getelementptr inbounds i8, ptr %8, i64 8
  %299 = getelementptr inbounds i8, ptr %8, i64 16
  %300 = getelementptr inbounds i8, ptr %9, i64 8
  %301 = getelementptr inbounds i8, ptr %9, i64 16
  %302 = getelementptr inbounds double, ptr %13, i64 1
  %303 = getelementptr inbounds double, ptr %13, i64 2
  %304 = getelementptr inbounds [3 x double], ptr %13, i64 1
  %305 = getelementptr inbounds [3 x double], ptr %13, i64 1, i64 1
  %306 = getelementptr inbounds [3 x double], ptr %13, i64 1, i64 2
  %307 = getelementptr inbounds [3 x double], ptr %13, i64 2
  %308 = getelementptr inbounds [3 x double], ptr %13, i64 2, i64 1
  %309 = getelementptr inbounds [3 x double], ptr %13, i64 2, i64 2
  %310 = getelementptr inbounds double, ptr %14, i64 1
  %311 = getelementptr inbounds double, ptr %14, i64 2
  %312 = getelementptr inbounds [3 x double], ptr %14, i64 1
  %313 = getelementptr inbounds [3 x double], ptr %14, i64 1, i64 1
  %314 = getelementptr inbounds [3 x double], ptr %14, i64 1, i64 2
  %315 = getelementptr inbounds [3 x double], ptr %14, i64 2
  %316 = getelementptr inbounds [3 x double], ptr %14, i64 2, i64 1
  %317 = getelementptr inbounds [3 x double], ptr %14, i64 2, i64 2
  %318 = getelementptr inbounds [4 x double], ptr %15, i64 1
  %319 = getelementptr inbounds [4 x double], ptr %15, i64 2
  %320 = getelementptr inbounds [4 x double], ptr %15, i64 0, i64 1
  %321 = getelementptr inbounds [4 x double], ptr %15, i64 1, i64 1
  %322 = getelementptr inbounds [4 x double], ptr %15, i64 2, i64 1
  %323 = getelementptr inbounds [4 x double], ptr %15, i64 0, i64 2
  %324 = getelementptr inbounds [4 x double], ptr %15, i64 1, i64 2
  %325 = getelementptr inbounds [4 x double], ptr %15, i64 2, i64 2
  %326 = getelementptr inbounds %struct.Vector, ptr %17, i64 0, i32 1
  %327 = getelementptr inbounds %struct.Vector, ptr %17, i64 0, i32 2
  %328 = getelementptr inbounds %struct.Vector, ptr %18, i64 0, i32 1
  %329 = getelementptr inbounds %struct.Vector, ptr %18, i64 0, i32 2
  %330 = getelementptr inbounds double, ptr %78, i64 18
  %331 = getelementptr inbounds %struct.Vector, ptr %19, i64 0, i32 1
  %332 = getelementptr inbounds double, ptr %78, i64 19
  %333 = getelementptr inbounds %struct.Vector, ptr %19, i64 0, i32 2
  %334 = getelementptr inbounds double, ptr %78, i64 20
  %335 = getelementptr inbounds %struct.Vector, ptr %20, i64 0, i32 1
  %336 = getelementptr inbounds %struct.Vector, ptr %20, i64 0, i32 2
  %337 = getelementptr inbounds %struct.Vector, ptr %21, i64 0, i32 1
  %338 = getelementptr inbounds %struct.Vector, ptr %21, i64 0, i32 2
  %339 = getelementptr inbounds %struct.Vector, ptr %22, i64 0, i32 1
  %340 = getelementptr inbounds %struct.Vector, ptr %22, i64 0, i32 2
  %341 = getelementptr inbounds %struct.Solutions, ptr %5, i64 0, i32 1
  br label %364

342:                                              ; preds = %96, %360
  %343 = phi i64 [ 0, %96 ], [ %362, %360 ]
  %344 = phi i64 [ %82, %96 ], [ %357, %360 ]
  %345 = phi i64 [ -1, %96 ], [ %361, %360 ]
  %346 = getelementptr inbounds i64, ptr %98, i64 %343
  %347 = load i64, ptr %346, align 8
  %348 = getelementptr inbounds double, ptr %100, i64 %347
  %349 = load double, ptr %348, align 8
  %350 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 2, i64 %343
  store double %349, ptr %350, align 8
  %351 = getelementptr inbounds double, ptr %102, i64 %347
  %352 = load double, ptr %351, align 8
  %353 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 3, i64 %343
  store double %352, ptr %353, align 8
  %354 = icmp slt i64 %347, %344
  br i1 %354, label %355, label %356

355:                                              ; preds = %342
  store i64 %347, ptr %81, align 8
  br label %356

356:                                              ; preds = %355, %342
  %357 = phi i64 [ %347, %355 ], [ %344, %342 ]
  %358 = icmp sgt i64 %347, %345
  br i1 %358, label %359, label %360

359:                                              ; preds = %356
  store i64 %347, ptr %83, align 8
  br label %360

360:                                              ; preds = %359, %356
  %361 = phi i64 [ %347, %359 ], [ %345, %356 ]
  %362 = add nuw nsw i64 %343, 1
  %363 = icmp eq i64 %362, %90
  br i1 %363, label %103, label %342

364:                                              ; preds = %156, %3610
  %365 = phi double [ 0.000000e+00, %156 ], [ %3611, %3610 ]
  %366 = phi double [ 0.000000e+00, %156 ], [ %3612, %3610 ]
  %367 = phi double [ 0.000000e+00, %156 ], [ %3613, %3610 ]
  %368 = phi double [ 0.000000e+00, %156 ], [ %423, %3610 ]
  %369 = phi double [ 0.000000e+00, %156 ], [ %424, %3610 ]
  %370 = phi double [ 0.000000e+00, %156 ], [ %425, %3610 ]
  %371 = phi i64 [ %2, %156 ], [ %3614, %3610 ]
  %372 = load ptr, ptr %157, align 8
  %373 = load i64, ptr %158, align 8
  %374 = mul nsw i64 %373, %371
  %375 = getelementptr inbounds double, ptr %372, i64 %374
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %80) #13
  %376 = load i64, ptr %159, align 8
  %377 = add nsw i64 %376, %3
  %378 = load i64, ptr %160, align 8
  %379 = icmp sgt i64 %377, %378
  br i1 %379, label %3609, label %380

380:                                              ; preds = %364
  %381 = icmp eq i64 %371, %2
  br i1 %381, label %385, label %382

382:                                              ; preds = %380
  %383 = load i64, ptr %161, align 8
  %384 = icmp eq i64 %383, 0
  br i1 %384, label %419, label %385

385:                                              ; preds = %382, %380
  %386 = load ptr, ptr %151, align 8
  %387 = load i64, ptr %0, align 8
  %388 = mul nsw i64 %387, 3
  %389 = icmp sgt i64 %387, 0
  br i1 %389, label %390, label %406

390:                                              ; preds = %385, %390
  %391 = phi i64 [ %395, %390 ], [ 0, %385 ]
  %392 = getelementptr inbounds double, ptr %386, i64 %391
  %393 = load double, ptr %392, align 8
  %394 = getelementptr inbounds double, ptr %4, i64 %391
  store double %393, ptr %394, align 8
  %395 = add nuw nsw i64 %391, 1
  %396 = icmp eq i64 %395, %388
  br i1 %396, label %397, label %390

397:                                              ; preds = %390
  %398 = load ptr, ptr %150, align 8
  br label %399

399:                                              ; preds = %397, %399
  %400 = phi i64 [ %404, %399 ], [ 0, %397 ]
  %401 = getelementptr inbounds double, ptr %398, i64 %400
  %402 = load double, ptr %401, align 8
  %403 = getelementptr inbounds double, ptr %85, i64 %400
  store double %402, ptr %403, align 8
  %404 = add nuw nsw i64 %400, 1
  %405 = icmp eq i64 %404, %388
  br i1 %405, label %406, label %399

406:                                              ; preds = %399, %385
  %407 = load ptr, ptr %162, align 8
  %408 = load double, ptr %407, align 8
  %409 = getelementptr inbounds i8, ptr %407, i64 8
  %410 = load double, ptr %409, align 8
  %411 = getelementptr inbounds i8, ptr %407, i64 16
  %412 = load double, ptr %411, align 8
  %413 = getelementptr inbounds i8, ptr %407, i64 24
  %414 = load double, ptr %413, align 8
  %415 = getelementptr inbounds i8, ptr %407, i64 32
  %416 = load double, ptr %415, align 8
  %417 = getelementptr inbounds i8, ptr %407, i64 40
  %418 = load double, ptr %417, align 8
  br label %419

419:                                              ; preds = %406, %382
  %420 = phi double [ %408, %406 ], [ %365, %382 ]
  %421 = phi double [ %410, %406 ], [ %366, %382 ]
  %422 = phi double [ %412, %406 ], [ %367, %382 ]
  %423 = phi double [ %414, %406 ], [ %368, %382 ]
  %424 = phi double [ %416, %406 ], [ %369, %382 ]
  %425 = phi double [ %418, %406 ], [ %370, %382 ]
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %72)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %73)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %74)
  %426 = load ptr, ptr %1, align 8
  %427 = load ptr, ptr %163, align 8
  %428 = getelementptr inbounds i64, ptr %427, i64 %371
  %429 = load i64, ptr %428, align 8
  %430 = shl nsw i64 %429, 4
  %431 = getelementptr inbounds double, ptr %426, i64 %430
  %432 = load ptr, ptr %164, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %69) #13
  %433 = load ptr, ptr %165, align 8
  %434 = load double, ptr %433, align 8
  store double %434, ptr %69, align 8
  %435 = getelementptr inbounds double, ptr %433, i64 1
  %436 = load double, ptr %435, align 8
  store double %436, ptr %166, align 8
  %437 = getelementptr inbounds double, ptr %433, i64 2
  %438 = load double, ptr %437, align 8
  store double %438, ptr %167, align 8
  %439 = fcmp une double %434, 0.000000e+00
  %440 = fcmp une double %436, 0.000000e+00
  %441 = select i1 %439, i1 true, i1 %440
  %442 = fcmp une double %438, 0.000000e+00
  %443 = select i1 %441, i1 true, i1 %442
  br i1 %443, label %444, label %513

444:                                              ; preds = %419
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %70) #13
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(96) %70, i8 0, i64 96, i1 false)
  store double 1.000000e+00, ptr %70, align 16
  store double 1.000000e+00, ptr %168, align 8
  store double 1.000000e+00, ptr %169, align 16
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %71) #13
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %72, i8 0, i64 24, i1 false)
  %445 = add nsw i64 %373, -1
  %446 = getelementptr inbounds double, ptr %375, i64 %445
  %447 = load double, ptr %446, align 8
  call fastcc void @shift_left(ptr noundef nonnull %70, ptr noundef nonnull byval(%struct.Vector) align 8 %69, ptr noundef nonnull byval(%struct.Vector) align 8 %72, i32 noundef 0, double noundef %447)
  br label %448

448:                                              ; preds = %456, %444
  %449 = phi i64 [ 0, %444 ], [ %462, %456 ]
  %450 = getelementptr inbounds [4 x double], ptr %431, i64 %449
  %451 = getelementptr inbounds [4 x double], ptr %431, i64 %449, i64 1
  %452 = getelementptr inbounds [4 x double], ptr %431, i64 %449, i64 2
  %453 = load double, ptr %450, align 8
  %454 = load double, ptr %451, align 8
  %455 = load double, ptr %452, align 8
  br label %464

456:                                              ; preds = %464
  %457 = getelementptr inbounds [4 x double], ptr %431, i64 %449, i64 3
  %458 = load double, ptr %457, align 8
  %459 = getelementptr inbounds [4 x double], ptr %71, i64 %449, i64 3
  %460 = load double, ptr %459, align 8
  %461 = fadd double %458, %460
  store double %461, ptr %459, align 8
  %462 = add nuw nsw i64 %449, 1
  %463 = icmp eq i64 %462, 3
  br i1 %463, label %480, label %448

464:                                              ; preds = %464, %448
  %465 = phi i64 [ 0, %448 ], [ %478, %464 ]
  %466 = getelementptr inbounds [4 x double], ptr %70, i64 0, i64 %465
  %467 = load double, ptr %466, align 8
  %468 = fmul double %453, %467
  %469 = getelementptr inbounds [4 x double], ptr %70, i64 1, i64 %465
  %470 = load double, ptr %469, align 8
  %471 = fmul double %454, %470
  %472 = fadd double %468, %471
  %473 = getelementptr inbounds [4 x double], ptr %70, i64 2, i64 %465
  %474 = load double, ptr %473, align 8
  %475 = fmul double %455, %474
  %476 = fadd double %472, %475
  %477 = getelementptr inbounds [4 x double], ptr %71, i64 %449, i64 %465
  store double %476, ptr %477, align 8
  %478 = add nuw nsw i64 %465, 1
  %479 = icmp eq i64 %478, 4
  br i1 %479, label %456, label %464

480:                                              ; preds = %456, %488
  %481 = phi i64 [ %494, %488 ], [ 0, %456 ]
  %482 = getelementptr inbounds [4 x double], ptr %71, i64 %481
  %483 = getelementptr inbounds [4 x double], ptr %71, i64 %481, i64 1
  %484 = getelementptr inbounds [4 x double], ptr %71, i64 %481, i64 2
  %485 = load double, ptr %482, align 16
  %486 = load double, ptr %483, align 8
  %487 = load double, ptr %484, align 16
  br label %496

488:                                              ; preds = %496
  %489 = getelementptr inbounds [4 x double], ptr %71, i64 %481, i64 3
  %490 = load double, ptr %489, align 8
  %491 = getelementptr inbounds [4 x double], ptr %80, i64 %481, i64 3
  %492 = load double, ptr %491, align 8
  %493 = fadd double %490, %492
  store double %493, ptr %491, align 8
  %494 = add nuw nsw i64 %481, 1
  %495 = icmp eq i64 %494, 3
  br i1 %495, label %512, label %480

496:                                              ; preds = %496, %480
  %497 = phi i64 [ 0, %480 ], [ %510, %496 ]
  %498 = getelementptr inbounds [4 x double], ptr %432, i64 0, i64 %497
  %499 = load double, ptr %498, align 8
  %500 = fmul double %485, %499
  %501 = getelementptr inbounds [4 x double], ptr %432, i64 1, i64 %497
  %502 = load double, ptr %501, align 8
  %503 = fmul double %486, %502
  %504 = fadd double %500, %503
  %505 = getelementptr inbounds [4 x double], ptr %432, i64 2, i64 %497
  %506 = load double, ptr %505, align 8
  %507 = fmul double %487, %506
  %508 = fadd double %504, %507
  %509 = getelementptr inbounds [4 x double], ptr %80, i64 %481, i64 %497
  store double %508, ptr %509, align 8
  %510 = add nuw nsw i64 %497, 1
  %511 = icmp eq i64 %510, 4
  br i1 %511, label %488, label %496

512:                                              ; preds = %488
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %71) #13
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %70) #13
  br label %545

513:                                              ; preds = %419, %518
  %514 = phi i64 [ %524, %518 ], [ 0, %419 ]
  %515 = getelementptr inbounds [4 x double], ptr %431, i64 %514
  %516 = getelementptr inbounds [4 x double], ptr %431, i64 %514, i64 1
  %517 = getelementptr inbounds [4 x double], ptr %431, i64 %514, i64 2
  br label %526

518:                                              ; preds = %526
  %519 = getelementptr inbounds [4 x double], ptr %431, i64 %514, i64 3
  %520 = load double, ptr %519, align 8
  %521 = getelementptr inbounds [4 x double], ptr %80, i64 %514, i64 3
  %522 = load double, ptr %521, align 8
  %523 = fadd double %520, %522
  store double %523, ptr %521, align 8
  %524 = add nuw nsw i64 %514, 1
  %525 = icmp eq i64 %524, 3
  br i1 %525, label %545, label %513

526:                                              ; preds = %526, %513
  %527 = phi i64 [ 0, %513 ], [ %543, %526 ]
  %528 = load double, ptr %515, align 8
  %529 = getelementptr inbounds [4 x double], ptr %432, i64 0, i64 %527
  %530 = load double, ptr %529, align 8
  %531 = fmul double %528, %530
  %532 = load double, ptr %516, align 8
  %533 = getelementptr inbounds [4 x double], ptr %432, i64 1, i64 %527
  %534 = load double, ptr %533, align 8
  %535 = fmul double %532, %534
  %536 = fadd double %531, %535
  %537 = load double, ptr %517, align 8
  %538 = getelementptr inbounds [4 x double], ptr %432, i64 2, i64 %527
  %539 = load double, ptr %538, align 8
  %540 = fmul double %537, %539
  %541 = fadd double %536, %540
  %542 = getelementptr inbounds [4 x double], ptr %80, i64 %514, i64 %527
  store double %541, ptr %542, align 8
  %543 = add nuw nsw i64 %527, 1
  %544 = icmp eq i64 %543, 4
  br i1 %544, label %518, label %526

545:                                              ; preds = %518, %512
  %546 = load i64, ptr %170, align 8
  %547 = icmp sgt i64 %546, 0
  br i1 %547, label %548, label %601

548:                                              ; preds = %545
  %549 = load ptr, ptr %171, align 8
  %550 = load ptr, ptr %172, align 8
  %551 = load i64, ptr %81, align 8
  br label %552

552:                                              ; preds = %598, %548
  %553 = phi i64 [ 0, %548 ], [ %599, %598 ]
  %554 = getelementptr inbounds i64, ptr %549, i64 %553
  %555 = load i64, ptr %554, align 8
  %556 = getelementptr inbounds i8, ptr %550, i64 %555
  %557 = load i8, ptr %556, align 1
  %558 = icmp eq i8 %557, 0
  br i1 %558, label %559, label %571

559:                                              ; preds = %552
  %560 = load ptr, ptr %173, align 8
  %561 = getelementptr inbounds double, ptr %560, i64 %555
  %562 = load double, ptr %561, align 8
  %563 = getelementptr inbounds double, ptr %375, i64 %553
  %564 = load double, ptr %563, align 8
  %565 = fcmp ugt double %562, %564
  br i1 %565, label %957, label %566

566:                                              ; preds = %559
  %567 = load ptr, ptr %174, align 8
  %568 = getelementptr inbounds double, ptr %567, i64 %555
  %569 = load double, ptr %568, align 8
  %570 = fcmp ugt double %564, %569
  br i1 %570, label %957, label %571

571:                                              ; preds = %566, %552
  %572 = icmp slt i64 %555, %551
  br i1 %572, label %573, label %598

573:                                              ; preds = %571
  %574 = load ptr, ptr %151, align 8
  %575 = mul nsw i64 %555, 3
  %576 = getelementptr inbounds double, ptr %574, i64 %575
  %577 = load double, ptr %576, align 8
  store double %577, ptr %73, align 8
  %578 = add nsw i64 %575, 1
  %579 = getelementptr inbounds double, ptr %574, i64 %578
  %580 = load double, ptr %579, align 8
  store double %580, ptr %175, align 8
  %581 = add nsw i64 %575, 2
  %582 = getelementptr inbounds double, ptr %574, i64 %581
  %583 = load double, ptr %582, align 8
  store double %583, ptr %176, align 8
  %584 = load ptr, ptr %150, align 8
  %585 = getelementptr inbounds double, ptr %584, i64 %575
  %586 = load double, ptr %585, align 8
  store double %586, ptr %74, align 8
  %587 = getelementptr inbounds double, ptr %584, i64 %578
  %588 = load double, ptr %587, align 8
  store double %588, ptr %177, align 8
  %589 = getelementptr inbounds double, ptr %584, i64 %581
  %590 = load double, ptr %589, align 8
  store double %590, ptr %178, align 8
  %591 = load ptr, ptr %179, align 8
  %592 = getelementptr inbounds i8, ptr %591, i64 %555
  %593 = load i8, ptr %592, align 1
  %594 = sext i8 %593 to i32
  %595 = getelementptr inbounds double, ptr %375, i64 %553
  %596 = load double, ptr %595, align 8
  %597 = fneg double %596
  call fastcc void @shift_left(ptr noundef nonnull %80, ptr noundef nonnull byval(%struct.Vector) align 8 %73, ptr noundef nonnull byval(%struct.Vector) align 8 %74, i32 noundef %594, double noundef %597)
  br label %598

598:                                              ; preds = %573, %571
  %599 = add nuw nsw i64 %553, 1
  %600 = icmp eq i64 %599, %546
  br i1 %600, label %601, label %552

601:                                              ; preds = %598, %545
  %602 = load i64, ptr %149, align 8
  %603 = icmp eq i64 %602, 0
  br i1 %603, label %650, label %604

604:                                              ; preds = %601
  %605 = load double, ptr %180, align 8
  %606 = load double, ptr %181, align 8
  %607 = load double, ptr %182, align 8
  br label %608

608:                                              ; preds = %611, %604
  %609 = phi i64 [ 0, %604 ], [ %612, %611 ]
  %610 = icmp eq i64 %609, 0
  br i1 %610, label %611, label %614

611:                                              ; preds = %614, %608
  %612 = add nuw nsw i64 %609, 1
  %613 = icmp eq i64 %612, 3
  br i1 %613, label %622, label %608

614:                                              ; preds = %608, %614
  %615 = phi i64 [ %620, %614 ], [ 0, %608 ]
  %616 = getelementptr inbounds [4 x double], ptr %80, i64 %609, i64 %615
  %617 = load double, ptr %616, align 8
  %618 = getelementptr inbounds [4 x double], ptr %80, i64 %615, i64 %609
  %619 = load double, ptr %618, align 8
  store double %619, ptr %616, align 8
  store double %617, ptr %618, align 8
  %620 = add nuw nsw i64 %615, 1
  %621 = icmp eq i64 %620, %609
  br i1 %621, label %611, label %614

622:                                              ; preds = %611
  %623 = load double, ptr %80, align 16
  %624 = fmul double %605, %623
  %625 = load double, ptr %183, align 8
  %626 = fmul double %606, %625
  %627 = fadd double %624, %626
  %628 = load double, ptr %184, align 16
  %629 = fmul double %607, %628
  %630 = fadd double %627, %629
  %631 = load double, ptr %185, align 16
  %632 = fmul double %605, %631
  %633 = load double, ptr %186, align 8
  %634 = fmul double %606, %633
  %635 = fadd double %632, %634
  %636 = load double, ptr %187, align 16
  %637 = fmul double %607, %636
  %638 = fadd double %635, %637
  %639 = load double, ptr %188, align 16
  %640 = fmul double %605, %639
  %641 = load double, ptr %189, align 8
  %642 = fmul double %606, %641
  %643 = fadd double %640, %642
  %644 = load double, ptr %190, align 16
  %645 = fmul double %607, %644
  %646 = fadd double %643, %645
  %647 = fneg double %630
  %648 = fneg double %638
  %649 = fneg double %646
  store double %647, ptr %180, align 8
  store double %648, ptr %181, align 8
  store double %649, ptr %182, align 8
  br label %650

650:                                              ; preds = %622, %601
  br i1 %547, label %651, label %958

651:                                              ; preds = %650
  %652 = load ptr, ptr %171, align 8
  %653 = load i64, ptr %81, align 8
  %654 = load i64, ptr %83, align 8
  br label %655

655:                                              ; preds = %951, %651
  %656 = phi double [ %422, %651 ], [ %952, %951 ]
  %657 = phi double [ %421, %651 ], [ %953, %951 ]
  %658 = phi double [ %420, %651 ], [ %954, %951 ]
  %659 = phi i64 [ 0, %651 ], [ %955, %951 ]
  %660 = getelementptr inbounds i64, ptr %652, i64 %659
  %661 = load i64, ptr %660, align 8
  %662 = icmp slt i64 %661, %653
  br i1 %662, label %951, label %663

663:                                              ; preds = %655
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %75) #13
  %664 = mul nsw i64 %661, 3
  %665 = getelementptr inbounds double, ptr %4, i64 %664
  %666 = load double, ptr %665, align 8
  store double %666, ptr %75, align 8
  %667 = add nsw i64 %664, 1
  %668 = getelementptr inbounds double, ptr %4, i64 %667
  %669 = load double, ptr %668, align 8
  store double %669, ptr %191, align 8
  %670 = add nsw i64 %664, 2
  %671 = getelementptr inbounds double, ptr %4, i64 %670
  %672 = load double, ptr %671, align 8
  store double %672, ptr %192, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %76) #13
  %673 = getelementptr inbounds double, ptr %85, i64 %664
  %674 = load double, ptr %673, align 8
  store double %674, ptr %76, align 8
  %675 = getelementptr inbounds double, ptr %85, i64 %667
  %676 = load double, ptr %675, align 8
  store double %676, ptr %193, align 8
  %677 = getelementptr inbounds double, ptr %85, i64 %670
  %678 = load double, ptr %677, align 8
  store double %678, ptr %194, align 8
  %679 = load i64, ptr %161, align 8
  %680 = icmp ne i64 %679, 0
  %681 = icmp slt i64 %661, %654
  %682 = select i1 %680, i1 %681, i1 false
  br i1 %682, label %683, label %841

683:                                              ; preds = %663
  %684 = getelementptr inbounds double, ptr %375, i64 %659
  %685 = load double, ptr %684, align 8
  %686 = tail call double @llvm.cos.f64(double %685)
  %687 = tail call double @llvm.sin.f64(double %685)
  %688 = load ptr, ptr %179, align 8
  %689 = getelementptr inbounds i8, ptr %688, i64 %661
  %690 = load i8, ptr %689, align 1
  %691 = load i64, ptr %0, align 8
  %692 = add nsw i64 %661, 1
  %693 = icmp slt i64 %692, %691
  br i1 %693, label %694, label %700

694:                                              ; preds = %683
  %695 = icmp eq i8 %690, 0
  %696 = fmul double %666, %685
  %697 = fmul double %669, %685
  %698 = fmul double %672, %685
  %699 = fsub double 1.000000e+00, %686
  br label %703

700:                                              ; preds = %791, %683
  %701 = load i64, ptr %195, align 8
  %702 = icmp sgt i64 %701, %661
  br i1 %702, label %794, label %841

703:                                              ; preds = %791, %694
  %704 = phi i64 [ %692, %694 ], [ %792, %791 ]
  %705 = mul nsw i64 %704, 3
  %706 = getelementptr inbounds double, ptr %85, i64 %705
  %707 = load double, ptr %706, align 8
  %708 = add nsw i64 %705, 1
  %709 = getelementptr inbounds double, ptr %85, i64 %708
  %710 = load double, ptr %709, align 8
  %711 = add nsw i64 %705, 2
  %712 = getelementptr inbounds double, ptr %85, i64 %711
  %713 = load double, ptr %712, align 8
  br i1 %695, label %718, label %714

714:                                              ; preds = %703
  %715 = fadd double %696, %707
  %716 = fadd double %697, %710
  %717 = fadd double %698, %713
  store double %715, ptr %706, align 8
  store double %716, ptr %709, align 8
  store double %717, ptr %712, align 8
  br label %791

718:                                              ; preds = %703
  %719 = fsub double %707, %674
  %720 = fsub double %710, %676
  %721 = fsub double %713, %678
  %722 = fmul double %666, %719
  %723 = fmul double %669, %720
  %724 = fadd double %722, %723
  %725 = fmul double %672, %721
  %726 = fadd double %724, %725
  %727 = fmul double %699, %726
  %728 = fmul double %669, %721
  %729 = fmul double %672, %720
  %730 = fsub double %728, %729
  %731 = fmul double %672, %719
  %732 = fmul double %666, %721
  %733 = fsub double %731, %732
  %734 = fmul double %666, %720
  %735 = fmul double %669, %719
  %736 = fsub double %734, %735
  %737 = fmul double %686, %719
  %738 = fmul double %687, %730
  %739 = fadd double %737, %738
  %740 = fmul double %666, %727
  %741 = fadd double %740, %739
  %742 = fmul double %686, %720
  %743 = fmul double %687, %733
  %744 = fadd double %742, %743
  %745 = fmul double %669, %727
  %746 = fadd double %745, %744
  %747 = fmul double %686, %721
  %748 = fmul double %687, %736
  %749 = fadd double %747, %748
  %750 = fmul double %672, %727
  %751 = fadd double %749, %750
  %752 = fadd double %674, %741
  %753 = fadd double %676, %746
  %754 = fadd double %678, %751
  store double %752, ptr %706, align 8
  store double %753, ptr %709, align 8
  store double %754, ptr %712, align 8
  %755 = getelementptr inbounds double, ptr %4, i64 %705
  %756 = load double, ptr %755, align 8
  %757 = getelementptr inbounds double, ptr %4, i64 %708
  %758 = load double, ptr %757, align 8
  %759 = getelementptr inbounds double, ptr %4, i64 %711
  %760 = load double, ptr %759, align 8
  %761 = fmul double %666, %756
  %762 = fmul double %669, %758
  %763 = fadd double %761, %762
  %764 = fmul double %672, %760
  %765 = fadd double %763, %764
  %766 = fmul double %699, %765
  %767 = fmul double %669, %760
  %768 = fmul double %672, %758
  %769 = fsub double %767, %768
  %770 = fmul double %672, %756
  %771 = fmul double %666, %760
  %772 = fsub double %770, %771
  %773 = fmul double %666, %758
  %774 = fmul double %669, %756
  %775 = fsub double %773, %774
  %776 = fmul double %686, %756
  %777 = fmul double %687, %769
  %778 = fadd double %776, %777
  %779 = fmul double %666, %766
  %780 = fadd double %779, %778
  %781 = fmul double %686, %758
  %782 = fmul double %687, %772
  %783 = fadd double %781, %782
  %784 = fmul double %669, %766
  %785 = fadd double %784, %783
  %786 = fmul double %686, %760
  %787 = fmul double %687, %775
  %788 = fadd double %786, %787
  %789 = fmul double %672, %766
  %790 = fadd double %788, %789
  store double %780, ptr %755, align 8
  store double %785, ptr %757, align 8
  store double %790, ptr %759, align 8
  br label %791

791:                                              ; preds = %718, %714
  %792 = add nsw i64 %704, 1
  %793 = icmp eq i64 %792, %691
  br i1 %793, label %700, label %703

794:                                              ; preds = %700
  %795 = icmp eq i8 %690, 0
  br i1 %795, label %803, label %796

796:                                              ; preds = %794
  %797 = fmul double %666, %685
  %798 = fmul double %669, %685
  %799 = fmul double %672, %685
  %800 = fadd double %797, %658
  %801 = fadd double %798, %657
  %802 = fadd double %799, %656
  br label %841

803:                                              ; preds = %794
  %804 = fsub double %658, %674
  %805 = fsub double %657, %676
  %806 = fsub double %656, %678
  %807 = fmul double %666, %804
  %808 = fmul double %669, %805
  %809 = fadd double %807, %808
  %810 = fmul double %672, %806
  %811 = fadd double %809, %810
  %812 = fsub double 1.000000e+00, %686
  %813 = fmul double %812, %811
  %814 = fmul double %669, %806
  %815 = fmul double %672, %805
  %816 = fsub double %814, %815
  %817 = fmul double %672, %804
  %818 = fmul double %666, %806
  %819 = fsub double %817, %818
  %820 = fmul double %666, %805
  %821 = fmul double %669, %804
  %822 = fsub double %820, %821
  %823 = fmul double %686, %804
  %824 = fmul double %687, %816
  %825 = fadd double %823, %824
  %826 = fmul double %666, %813
  %827 = fadd double %826, %825
  %828 = fmul double %686, %805
  %829 = fmul double %687, %819
  %830 = fadd double %828, %829
  %831 = fmul double %669, %813
  %832 = fadd double %831, %830
  %833 = fmul double %686, %806
  %834 = fmul double %687, %822
  %835 = fadd double %833, %834
  %836 = fmul double %672, %813
  %837 = fadd double %835, %836
  %838 = fadd double %674, %827
  %839 = fadd double %676, %832
  %840 = fadd double %678, %837
  br label %841

841:                                              ; preds = %796, %803, %700, %663
  %842 = phi double [ %656, %700 ], [ %656, %663 ], [ %840, %803 ], [ %802, %796 ]
  %843 = phi double [ %657, %700 ], [ %657, %663 ], [ %839, %803 ], [ %801, %796 ]
  %844 = phi double [ %658, %700 ], [ %658, %663 ], [ %838, %803 ], [ %800, %796 ]
  br i1 %603, label %845, label %943

845:                                              ; preds = %841
  %846 = load double, ptr %180, align 8
  %847 = load double, ptr %181, align 8
  %848 = load double, ptr %182, align 8
  br label %849

849:                                              ; preds = %852, %845
  %850 = phi i64 [ 0, %845 ], [ %853, %852 ]
  %851 = icmp eq i64 %850, 0
  br i1 %851, label %852, label %855

852:                                              ; preds = %855, %849
  %853 = add nuw nsw i64 %850, 1
  %854 = icmp eq i64 %853, 3
  br i1 %854, label %863, label %849

855:                                              ; preds = %849, %855
  %856 = phi i64 [ %861, %855 ], [ 0, %849 ]
  %857 = getelementptr inbounds [4 x double], ptr %80, i64 %850, i64 %856
  %858 = load double, ptr %857, align 8
  %859 = getelementptr inbounds [4 x double], ptr %80, i64 %856, i64 %850
  %860 = load double, ptr %859, align 8
  store double %860, ptr %857, align 8
  store double %858, ptr %859, align 8
  %861 = add nuw nsw i64 %856, 1
  %862 = icmp eq i64 %861, %850
  br i1 %862, label %852, label %855

863:                                              ; preds = %852
  %864 = load double, ptr %80, align 16
  %865 = fmul double %846, %864
  %866 = load double, ptr %183, align 8
  %867 = fmul double %847, %866
  %868 = fadd double %865, %867
  %869 = load double, ptr %184, align 16
  %870 = fmul double %848, %869
  %871 = fadd double %868, %870
  %872 = load double, ptr %185, align 16
  %873 = fmul double %846, %872
  %874 = load double, ptr %186, align 8
  %875 = fmul double %847, %874
  %876 = fadd double %873, %875
  %877 = load double, ptr %187, align 16
  %878 = fmul double %848, %877
  %879 = fadd double %876, %878
  %880 = load double, ptr %188, align 16
  %881 = fmul double %846, %880
  %882 = load double, ptr %189, align 8
  %883 = fmul double %847, %882
  %884 = fadd double %881, %883
  %885 = load double, ptr %190, align 16
  %886 = fmul double %848, %885
  %887 = fadd double %884, %886
  %888 = fneg double %871
  %889 = fneg double %879
  %890 = fneg double %887
  store double %888, ptr %180, align 8
  store double %889, ptr %181, align 8
  store double %890, ptr %182, align 8
  %891 = load ptr, ptr %179, align 8
  %892 = getelementptr inbounds i8, ptr %891, i64 %661
  %893 = load i8, ptr %892, align 1
  %894 = sext i8 %893 to i32
  %895 = getelementptr inbounds double, ptr %375, i64 %659
  %896 = load double, ptr %895, align 8
  call fastcc void @shift_left(ptr noundef nonnull %80, ptr noundef nonnull byval(%struct.Vector) align 8 %75, ptr noundef nonnull byval(%struct.Vector) align 8 %76, i32 noundef %894, double noundef %896)
  br i1 %603, label %897, label %950

897:                                              ; preds = %863
  %898 = load double, ptr %180, align 8
  %899 = load double, ptr %181, align 8
  %900 = load double, ptr %182, align 8
  br label %901

901:                                              ; preds = %904, %897
  %902 = phi i64 [ 0, %897 ], [ %905, %904 ]
  %903 = icmp eq i64 %902, 0
  br i1 %903, label %904, label %907

904:                                              ; preds = %907, %901
  %905 = add nuw nsw i64 %902, 1
  %906 = icmp eq i64 %905, 3
  br i1 %906, label %915, label %901

907:                                              ; preds = %901, %907
  %908 = phi i64 [ %913, %907 ], [ 0, %901 ]
  %909 = getelementptr inbounds [4 x double], ptr %80, i64 %902, i64 %908
  %910 = load double, ptr %909, align 8
  %911 = getelementptr inbounds [4 x double], ptr %80, i64 %908, i64 %902
  %912 = load double, ptr %911, align 8
  store double %912, ptr %909, align 8
  store double %910, ptr %911, align 8
  %913 = add nuw nsw i64 %908, 1
  %914 = icmp eq i64 %913, %902
  br i1 %914, label %904, label %907

915:                                              ; preds = %904
  %916 = load double, ptr %80, align 16
  %917 = fmul double %898, %916
  %918 = load double, ptr %183, align 8
  %919 = fmul double %899, %918
  %920 = fadd double %917, %919
  %921 = load double, ptr %184, align 16
  %922 = fmul double %900, %921
  %923 = fadd double %920, %922
  %924 = load double, ptr %185, align 16
  %925 = fmul double %898, %924
  %926 = load double, ptr %186, align 8
  %927 = fmul double %899, %926
  %928 = fadd double %925, %927
  %929 = load double, ptr %187, align 16
  %930 = fmul double %900, %929
  %931 = fadd double %928, %930
  %932 = load double, ptr %188, align 16
  %933 = fmul double %898, %932
  %934 = load double, ptr %189, align 8
  %935 = fmul double %899, %934
  %936 = fadd double %933, %935
  %937 = load double, ptr %190, align 16
  %938 = fmul double %900, %937
  %939 = fadd double %936, %938
  %940 = fneg double %923
  %941 = fneg double %931
  %942 = fneg double %939
  store double %940, ptr %180, align 8
  store double %941, ptr %181, align 8
  store double %942, ptr %182, align 8
  br label %950

943:                                              ; preds = %841
  %944 = load ptr, ptr %179, align 8
  %945 = getelementptr inbounds i8, ptr %944, i64 %661
  %946 = load i8, ptr %945, align 1
  %947 = sext i8 %946 to i32
  %948 = getelementptr inbounds double, ptr %375, i64 %659
  %949 = load double, ptr %948, align 8
  call fastcc void @shift_left(ptr noundef nonnull %80, ptr noundef nonnull byval(%struct.Vector) align 8 %75, ptr noundef nonnull byval(%struct.Vector) align 8 %76, i32 noundef %947, double noundef %949)
  br label %950

950:                                              ; preds = %943, %915, %863
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %76) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %75) #13
  br label %951

951:                                              ; preds = %950, %655
  %952 = phi double [ %842, %950 ], [ %656, %655 ]
  %953 = phi double [ %843, %950 ], [ %657, %655 ]
  %954 = phi double [ %844, %950 ], [ %658, %655 ]
  %955 = add nuw nsw i64 %659, 1
  %956 = icmp eq i64 %955, %546
  br i1 %956, label %958, label %655

957:                                              ; preds = %566, %559
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %69) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %72)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %73)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %74)
  br label %3610

958:                                              ; preds = %951, %650
  %959 = phi double [ %420, %650 ], [ %954, %951 ]
  %960 = phi double [ %421, %650 ], [ %953, %951 ]
  %961 = phi double [ %422, %650 ], [ %952, %951 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %69) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %72)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %73)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %74)
  %962 = load i64, ptr %161, align 8
  %963 = icmp eq i64 %962, 0
  br i1 %963, label %1004, label %964

964:                                              ; preds = %958
  %965 = select i1 %603, double 1.000000e+00, double -1.000000e+00
  %966 = load i64, ptr %86, align 8
  %967 = icmp sgt i64 %966, 0
  br i1 %967, label %968, label %1003

968:                                              ; preds = %964
  %969 = load ptr, ptr %196, align 8
  br label %970

970:                                              ; preds = %970, %968
  %971 = phi i64 [ 0, %968 ], [ %1001, %970 ]
  %972 = getelementptr inbounds i64, ptr %969, i64 %971
  %973 = load i64, ptr %972, align 8
  %974 = mul nsw i64 %973, 3
  %975 = getelementptr inbounds double, ptr %4, i64 %974
  %976 = load double, ptr %975, align 8
  %977 = add nsw i64 %974, 1
  %978 = getelementptr inbounds double, ptr %4, i64 %977
  %979 = load double, ptr %978, align 8
  %980 = add nsw i64 %974, 2
  %981 = getelementptr inbounds double, ptr %4, i64 %980
  %982 = load double, ptr %981, align 8
  %983 = fmul double %965, %976
  %984 = fmul double %965, %979
  %985 = fmul double %965, %982
  %986 = mul nuw nsw i64 %971, 3
  %987 = getelementptr inbounds double, ptr %78, i64 %986
  store double %983, ptr %987, align 8
  %988 = add nuw nsw i64 %986, 1
  %989 = getelementptr inbounds double, ptr %78, i64 %988
  store double %984, ptr %989, align 8
  %990 = add nuw nsw i64 %986, 2
  %991 = getelementptr inbounds double, ptr %78, i64 %990
  store double %985, ptr %991, align 8
  %992 = getelementptr inbounds double, ptr %85, i64 %974
  %993 = load double, ptr %992, align 8
  %994 = getelementptr inbounds double, ptr %85, i64 %977
  %995 = load double, ptr %994, align 8
  %996 = getelementptr inbounds double, ptr %85, i64 %980
  %997 = load double, ptr %996, align 8
  %998 = getelementptr inbounds double, ptr %87, i64 %986
  store double %993, ptr %998, align 8
  %999 = getelementptr inbounds double, ptr %87, i64 %988
  store double %995, ptr %999, align 8
  %1000 = getelementptr inbounds double, ptr %87, i64 %990
  store double %997, ptr %1000, align 8
  %1001 = add nuw nsw i64 %971, 1
  %1002 = icmp eq i64 %1001, %966
  br i1 %1002, label %1003, label %970

1003:                                             ; preds = %970, %964
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %68) #13
  call fastcc void @arrangement(ptr nonnull sret(%struct.Arrangement) align 8 %68, ptr noundef nonnull %78, ptr noundef nonnull %87)
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(40) %152, ptr noundef nonnull align 8 dereferenceable(40) %68, i64 40, i1 false)
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %68) #13
  br label %1004

1004:                                             ; preds = %1003, %958
  %1005 = load i64, ptr %197, align 8
  switch i64 %1005, label %2964 [
    i64 0, label %1006
    i64 1, label %2255
  ]

1006:                                             ; preds = %1004
  %1007 = load i64, ptr %152, align 8
  %1008 = load double, ptr %250, align 8
  %1009 = load double, ptr %251, align 8
  %1010 = load double, ptr %252, align 8
  %1011 = load double, ptr %78, align 8
  %1012 = load double, ptr %199, align 8
  %1013 = load double, ptr %201, align 8
  %1014 = load double, ptr %202, align 8
  %1015 = load double, ptr %204, align 8
  %1016 = load double, ptr %206, align 8
  %1017 = load double, ptr %228, align 8
  %1018 = load double, ptr %229, align 8
  %1019 = load double, ptr %230, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %62) #13
  %1020 = load double, ptr %231, align 8
  store double %1020, ptr %62, align 8
  %1021 = load double, ptr %232, align 8
  store double %1021, ptr %253, align 8
  %1022 = load double, ptr %233, align 8
  store double %1022, ptr %254, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %63) #13
  %1023 = load double, ptr %207, align 8
  store double %1023, ptr %63, align 8
  %1024 = load double, ptr %209, align 8
  store double %1024, ptr %255, align 8
  %1025 = load double, ptr %211, align 8
  store double %1025, ptr %256, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %64) #13
  %1026 = load double, ptr %212, align 8
  store double %1026, ptr %64, align 8
  %1027 = load double, ptr %214, align 8
  store double %1027, ptr %257, align 8
  %1028 = load double, ptr %216, align 8
  store double %1028, ptr %258, align 8
  %1029 = load double, ptr %80, align 16
  %1030 = fmul double %959, %1029
  %1031 = load double, ptr %183, align 8
  %1032 = fmul double %960, %1031
  %1033 = fadd double %1030, %1032
  %1034 = load double, ptr %184, align 16
  %1035 = fmul double %961, %1034
  %1036 = fadd double %1033, %1035
  %1037 = load double, ptr %185, align 16
  %1038 = fmul double %959, %1037
  %1039 = load double, ptr %186, align 8
  %1040 = fmul double %960, %1039
  %1041 = fadd double %1038, %1040
  %1042 = load double, ptr %187, align 16
  %1043 = fmul double %961, %1042
  %1044 = fadd double %1041, %1043
  %1045 = load double, ptr %188, align 16
  %1046 = fmul double %959, %1045
  %1047 = load double, ptr %189, align 8
  %1048 = fmul double %960, %1047
  %1049 = fadd double %1046, %1048
  %1050 = load double, ptr %190, align 16
  %1051 = fmul double %961, %1050
  %1052 = fadd double %1049, %1051
  %1053 = load double, ptr %180, align 8
  %1054 = load double, ptr %181, align 8
  %1055 = load double, ptr %182, align 8
  %1056 = fadd double %1036, %1053
  %1057 = fadd double %1044, %1054
  %1058 = fadd double %1052, %1055
  call void @llvm.lifetime.start.p0(i64 192, ptr nonnull %65) #13
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %66) #13
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %67) #13
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %50)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %55)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %57)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %60)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %43) #13
  store double %1011, ptr %43, align 8
  store double %1012, ptr %259, align 8
  store double %1013, ptr %260, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %44) #13
  store double %1014, ptr %44, align 8
  store double %1015, ptr %261, align 8
  store double %1016, ptr %262, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %45) #13
  store double %1017, ptr %45, align 8
  store double %1018, ptr %263, align 8
  store double %1019, ptr %264, align 8
  %1059 = load double, ptr %87, align 8
  %1060 = load double, ptr %217, align 8
  %1061 = load double, ptr %218, align 8
  %1062 = load double, ptr %219, align 8
  %1063 = load double, ptr %220, align 8
  %1064 = load double, ptr %221, align 8
  %1065 = load double, ptr %222, align 8
  %1066 = load double, ptr %223, align 8
  %1067 = load double, ptr %224, align 8
  switch i64 %1007, label %1857 [
    i64 4, label %1068
    i64 0, label %1476
    i64 1, label %1573
    i64 2, label %1671
  ]

1068:                                             ; preds = %1006
  %1069 = fmul double %1011, %1014
  %1070 = fmul double %1012, %1015
  %1071 = fadd double %1069, %1070
  %1072 = fmul double %1013, %1016
  %1073 = fadd double %1071, %1072
  %1074 = fmul double %1073, %1073
  %1075 = fsub double 1.000000e+00, %1074
  %1076 = fcmp ogt double %1075, 0.000000e+00
  %1077 = select i1 %1076, double %1075, double 0.000000e+00
  %1078 = tail call double @llvm.sqrt.f64(double %1077)
  %1079 = fmul double %1013, %1015
  %1080 = fmul double %1012, %1016
  %1081 = fsub double %1079, %1080
  %1082 = fmul double %1011, %1016
  %1083 = fmul double %1013, %1014
  %1084 = fsub double %1082, %1083
  %1085 = fmul double %1012, %1014
  %1086 = fmul double %1011, %1015
  %1087 = fsub double %1085, %1086
  %1088 = fdiv double %1081, %1078
  %1089 = fdiv double %1084, %1078
  %1090 = fdiv double %1087, %1078
  %1091 = fmul double %1016, %1089
  %1092 = fmul double %1015, %1090
  %1093 = fsub double %1091, %1092
  %1094 = fmul double %1014, %1090
  %1095 = fmul double %1016, %1088
  %1096 = fsub double %1094, %1095
  %1097 = fmul double %1015, %1088
  %1098 = fmul double %1014, %1089
  %1099 = fsub double %1097, %1098
  %1100 = fsub double %1059, %1062
  %1101 = fsub double %1060, %1063
  %1102 = fsub double %1061, %1064
  %1103 = fsub double %1056, %1059
  %1104 = fsub double %1057, %1060
  %1105 = fsub double %1058, %1061
  %1106 = fsub double %959, %1065
  %1107 = fsub double %960, %1066
  %1108 = fsub double %961, %1067
  %1109 = fmul double %1017, %1106
  %1110 = fmul double %1018, %1107
  %1111 = fadd double %1109, %1110
  %1112 = fmul double %1019, %1108
  %1113 = fadd double %1111, %1112
  %1114 = fmul double %1017, %1113
  %1115 = fmul double %1018, %1113
  %1116 = fmul double %1019, %1113
  %1117 = fmul double %1018, %1108
  %1118 = fmul double %1019, %1107
  %1119 = fsub double %1117, %1118
  %1120 = fmul double %1019, %1106
  %1121 = fmul double %1017, %1108
  %1122 = fsub double %1120, %1121
  %1123 = fmul double %1017, %1107
  %1124 = fmul double %1018, %1106
  %1125 = fsub double %1123, %1124
  %1126 = fsub double %1065, %1062
  %1127 = fsub double %1066, %1063
  %1128 = fsub double %1067, %1064
  %1129 = fadd double %1126, %1114
  %1130 = fadd double %1127, %1115
  %1131 = fadd double %1128, %1116
  %1132 = fsub double %1106, %1114
  %1133 = fsub double %1107, %1115
  %1134 = fsub double %1108, %1116
  %1135 = fmul double %1014, %1129
  %1136 = fmul double %1015, %1130
  %1137 = fadd double %1135, %1136
  %1138 = fmul double %1016, %1131
  %1139 = fadd double %1138, %1137
  %1140 = fmul double %1014, %1132
  %1141 = fmul double %1015, %1133
  %1142 = fadd double %1140, %1141
  %1143 = fmul double %1016, %1134
  %1144 = fadd double %1143, %1142
  %1145 = fmul double %1014, %1119
  %1146 = fmul double %1015, %1122
  %1147 = fadd double %1145, %1146
  %1148 = fmul double %1016, %1125
  %1149 = fadd double %1148, %1147
  %1150 = fmul double %1129, %1129
  %1151 = fmul double %1130, %1130
  %1152 = fadd double %1150, %1151
  %1153 = fmul double %1131, %1131
  %1154 = fadd double %1153, %1152
  %1155 = fmul double %1132, %1132
  %1156 = fmul double %1133, %1133
  %1157 = fadd double %1155, %1156
  %1158 = fmul double %1134, %1134
  %1159 = fadd double %1158, %1157
  %1160 = fadd double %1154, %1159
  %1161 = fmul double %1129, %1132
  %1162 = fmul double %1130, %1133
  %1163 = fadd double %1161, %1162
  %1164 = fmul double %1131, %1134
  %1165 = fadd double %1164, %1163
  %1166 = fmul double %1165, 2.000000e+00
  %1167 = fmul double %1119, %1129
  %1168 = fmul double %1122, %1130
  %1169 = fadd double %1167, %1168
  %1170 = fmul double %1125, %1131
  %1171 = fadd double %1170, %1169
  %1172 = fmul double %1171, 2.000000e+00
  %1173 = fadd double %1103, %1100
  %1174 = fadd double %1104, %1101
  %1175 = fadd double %1105, %1102
  %1176 = fmul double %1011, %1173
  %1177 = fmul double %1012, %1174
  %1178 = fadd double %1176, %1177
  %1179 = fmul double %1013, %1175
  %1180 = fadd double %1178, %1179
  %1181 = fmul double %1011, %1093
  %1182 = fmul double %1012, %1096
  %1183 = fadd double %1181, %1182
  %1184 = fmul double %1013, %1099
  %1185 = fadd double %1184, %1183
  %1186 = fmul double %1073, %1139
  %1187 = fsub double %1180, %1186
  %1188 = fdiv double %1187, %1185
  %1189 = fneg double %1073
  %1190 = fmul double %1144, %1189
  %1191 = fdiv double %1190, %1185
  %1192 = fmul double %1149, %1189
  %1193 = fdiv double %1192, %1185
  %1194 = fmul double %1100, %1100
  %1195 = fmul double %1101, %1101
  %1196 = fadd double %1194, %1195
  %1197 = fmul double %1102, %1102
  %1198 = fadd double %1196, %1197
  %1199 = fmul double %1103, %1103
  %1200 = fmul double %1104, %1104
  %1201 = fadd double %1199, %1200
  %1202 = fmul double %1105, %1105
  %1203 = fadd double %1201, %1202
  %1204 = fsub double %1198, %1203
  %1205 = fmul double %1088, %1100
  %1206 = fmul double %1089, %1101
  %1207 = fadd double %1205, %1206
  %1208 = fmul double %1090, %1102
  %1209 = fadd double %1207, %1208
  %1210 = fmul double %1209, 2.000000e+00
  %1211 = fmul double %1014, %1100
  %1212 = fmul double %1015, %1101
  %1213 = fadd double %1211, %1212
  %1214 = fmul double %1016, %1102
  %1215 = fadd double %1213, %1214
  %1216 = fmul double %1093, %1100
  %1217 = fmul double %1096, %1101
  %1218 = fadd double %1216, %1217
  %1219 = fmul double %1099, %1102
  %1220 = fadd double %1219, %1218
  %1221 = fadd double %1204, %1160
  %1222 = fmul double %1215, %1139
  %1223 = fmul double %1220, %1188
  %1224 = fadd double %1222, %1223
  %1225 = fmul double %1224, 2.000000e+00
  %1226 = fsub double %1221, %1225
  %1227 = fmul double %1215, %1144
  %1228 = fmul double %1220, %1191
  %1229 = fadd double %1227, %1228
  %1230 = fmul double %1229, 2.000000e+00
  %1231 = fsub double %1166, %1230
  %1232 = fmul double %1215, %1149
  %1233 = fmul double %1220, %1193
  %1234 = fadd double %1232, %1233
  %1235 = fmul double %1234, 2.000000e+00
  %1236 = fsub double %1172, %1235
  %1237 = fmul double %1210, %1210
  %1238 = fmul double %1188, %1188
  %1239 = fmul double %1139, %1139
  %1240 = fadd double %1239, %1238
  %1241 = fsub double %1240, %1160
  %1242 = fmul double %1237, %1241
  %1243 = fmul double %1226, %1226
  %1244 = fadd double %1242, %1243
  %1245 = fmul double %1188, 2.000000e+00
  %1246 = fmul double %1191, %1245
  %1247 = fmul double %1139, 2.000000e+00
  %1248 = fmul double %1144, %1247
  %1249 = fadd double %1248, %1246
  %1250 = fsub double %1249, %1166
  %1251 = fmul double %1237, %1250
  %1252 = fmul double %1226, 2.000000e+00
  %1253 = fmul double %1231, %1252
  %1254 = fadd double %1251, %1253
  %1255 = fmul double %1193, %1245
  %1256 = fmul double %1149, %1247
  %1257 = fadd double %1256, %1255
  %1258 = fsub double %1257, %1172
  %1259 = fmul double %1237, %1258
  %1260 = fmul double %1236, %1252
  %1261 = fadd double %1259, %1260
  %1262 = fmul double %1191, %1191
  %1263 = fmul double %1144, %1144
  %1264 = fadd double %1263, %1262
  %1265 = fmul double %1237, %1264
  %1266 = fmul double %1231, %1231
  %1267 = fadd double %1265, %1266
  %1268 = fmul double %1191, 2.000000e+00
  %1269 = fmul double %1193, %1268
  %1270 = fmul double %1144, 2.000000e+00
  %1271 = fmul double %1149, %1270
  %1272 = fadd double %1271, %1269
  %1273 = fmul double %1237, %1272
  %1274 = fmul double %1231, 2.000000e+00
  %1275 = fmul double %1236, %1274
  %1276 = fadd double %1273, %1275
  %1277 = fmul double %1193, %1193
  %1278 = fmul double %1149, %1149
  %1279 = fadd double %1278, %1277
  %1280 = fmul double %1237, %1279
  %1281 = fmul double %1236, %1236
  %1282 = fadd double %1280, %1281
  %1283 = fadd double %1244, %1254
  %1284 = fadd double %1267, %1283
  %1285 = fsub double %1244, %1254
  %1286 = fadd double %1267, %1285
  %1287 = fadd double %1276, %1261
  %1288 = fmul double %1287, 2.000000e+00
  %1289 = fsub double %1261, %1276
  %1290 = fmul double %1289, 2.000000e+00
  %1291 = fsub double %1244, %1267
  %1292 = fmul double %1291, 2.000000e+00
  %1293 = fmul double %1282, 4.000000e+00
  %1294 = fadd double %1293, %1292
  %1295 = tail call double @llvm.fabs.f64(double %1286)
  %1296 = tail call double @llvm.fabs.f64(double %1284)
  %1297 = fcmp oge double %1295, %1296
  %1298 = select i1 %1297, double %1286, double %1284
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %41) #13
  %1299 = select i1 %1297, double %1284, double %1286
  %1300 = fdiv double %1299, %1298
  store double %1300, ptr %41, align 16
  %1301 = select i1 %1297, double %1288, double %1290
  %1302 = fdiv double %1301, %1298
  store double %1302, ptr %287, align 8
  %1303 = fdiv double %1294, %1298
  store double %1303, ptr %288, align 16
  %1304 = select i1 %1297, double %1290, double %1288
  %1305 = fdiv double %1304, %1298
  store double %1305, ptr %289, align 8
  call void @llvm.lifetime.start.p0(i64 64, ptr nonnull %42) #13
  %1306 = call fastcc i32 @quartic_roots(ptr noundef nonnull %41, ptr noundef nonnull %42)
  %1307 = icmp sgt i32 %1306, 0
  br i1 %1307, label %1308, label %1474

1308:                                             ; preds = %1068
  %1309 = fmul double %1011, %1103
  %1310 = fmul double %1012, %1104
  %1311 = fadd double %1309, %1310
  %1312 = fmul double %1013, %1105
  %1313 = fadd double %1311, %1312
  %1314 = zext i32 %1306 to i64
  br label %1315

1315:                                             ; preds = %1470, %1308
  %1316 = phi i64 [ 0, %1308 ], [ %1472, %1470 ]
  %1317 = phi i64 [ 0, %1308 ], [ %1471, %1470 ]
  %1318 = getelementptr inbounds [4 x %struct.Complex], ptr %42, i64 0, i64 %1316
  %1319 = load double, ptr %1318, align 16
  %1320 = getelementptr inbounds [4 x %struct.Complex], ptr %42, i64 0, i64 %1316, i32 1
  %1321 = load double, ptr %1320, align 8
  %1322 = tail call double @llvm.fabs.f64(double %1321)
  %1323 = tail call double @llvm.fabs.f64(double %1319)
  %1324 = fadd double %1323, 1.000000e+00
  %1325 = fmul double %1324, 0x3EB0C6F7A0B5ED8D
  %1326 = fcmp ogt double %1322, %1325
  br i1 %1326, label %1470, label %1327

1327:                                             ; preds = %1315
  %1328 = select i1 %1297, double %1319, double 1.000000e+00
  %1329 = select i1 %1297, double 1.000000e+00, double %1319
  %1330 = fmul double %1328, %1328
  %1331 = fmul double %1329, %1329
  %1332 = fadd double %1330, %1331
  %1333 = fsub double %1331, %1330
  %1334 = fdiv double %1333, %1332
  %1335 = fmul double %1328, 2.000000e+00
  %1336 = fmul double %1329, %1335
  %1337 = fdiv double %1336, %1332
  %1338 = fsub double 1.000000e+00, %1334
  %1339 = fmul double %1113, %1338
  %1340 = fmul double %1106, %1334
  %1341 = fmul double %1119, %1337
  %1342 = fadd double %1340, %1341
  %1343 = fmul double %1017, %1339
  %1344 = fadd double %1342, %1343
  %1345 = fmul double %1107, %1334
  %1346 = fmul double %1122, %1337
  %1347 = fadd double %1345, %1346
  %1348 = fmul double %1018, %1339
  %1349 = fadd double %1347, %1348
  %1350 = fmul double %1108, %1334
  %1351 = fmul double %1125, %1337
  %1352 = fadd double %1350, %1351
  %1353 = fmul double %1019, %1339
  %1354 = fadd double %1352, %1353
  %1355 = fadd double %1065, %1344
  %1356 = fadd double %1066, %1349
  %1357 = fadd double %1067, %1354
  %1358 = fsub double %1355, %1062
  %1359 = fsub double %1356, %1063
  %1360 = fsub double %1357, %1064
  %1361 = fmul double %1191, %1334
  %1362 = fadd double %1188, %1361
  %1363 = fmul double %1193, %1337
  %1364 = fadd double %1363, %1362
  %1365 = fmul double %1231, %1334
  %1366 = fadd double %1226, %1365
  %1367 = fmul double %1236, %1337
  %1368 = fadd double %1367, %1366
  %1369 = fdiv double %1368, %1210
  %1370 = fmul double %1014, %1358
  %1371 = fmul double %1015, %1359
  %1372 = fadd double %1370, %1371
  %1373 = fmul double %1016, %1360
  %1374 = fadd double %1373, %1372
  %1375 = fmul double %1014, %1374
  %1376 = fmul double %1015, %1374
  %1377 = fmul double %1016, %1374
  %1378 = fmul double %1093, %1364
  %1379 = fmul double %1096, %1364
  %1380 = fmul double %1099, %1364
  %1381 = fadd double %1378, %1375
  %1382 = fadd double %1379, %1376
  %1383 = fadd double %1380, %1377
  %1384 = fmul double %1088, %1369
  %1385 = fmul double %1089, %1369
  %1386 = fmul double %1090, %1369
  %1387 = fadd double %1384, %1381
  %1388 = fadd double %1385, %1382
  %1389 = fadd double %1386, %1383
  %1390 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1317
  %1391 = fsub double %1387, %1100
  %1392 = fsub double %1388, %1101
  %1393 = fsub double %1389, %1102
  %1394 = fmul double %1012, %1393
  %1395 = fmul double %1013, %1392
  %1396 = fsub double %1394, %1395
  %1397 = fmul double %1013, %1391
  %1398 = fmul double %1011, %1393
  %1399 = fsub double %1397, %1398
  %1400 = fmul double %1011, %1392
  %1401 = fmul double %1012, %1391
  %1402 = fsub double %1400, %1401
  %1403 = fmul double %1103, %1396
  %1404 = fmul double %1104, %1399
  %1405 = fadd double %1403, %1404
  %1406 = fmul double %1105, %1402
  %1407 = fadd double %1406, %1405
  %1408 = fmul double %1103, %1391
  %1409 = fmul double %1104, %1392
  %1410 = fadd double %1408, %1409
  %1411 = fmul double %1105, %1393
  %1412 = fadd double %1411, %1410
  %1413 = fmul double %1011, %1391
  %1414 = fmul double %1012, %1392
  %1415 = fadd double %1413, %1414
  %1416 = fmul double %1013, %1393
  %1417 = fadd double %1416, %1415
  %1418 = fmul double %1313, %1417
  %1419 = fsub double %1412, %1418
  %1420 = fmul double %1407, %1407
  %1421 = fmul double %1419, %1419
  %1422 = fadd double %1420, %1421
  %1423 = tail call double @llvm.sqrt.f64(double %1422)
  %1424 = fcmp olt double %1423, 0x3D06849B86A12B9B
  %1425 = fdiv double %1419, %1423
  %1426 = fdiv double %1407, %1423
  %1427 = select i1 %1424, double 1.000000e+00, double %1425
  %1428 = select i1 %1424, double 0.000000e+00, double %1426
  store double %1427, ptr %1390, align 16
  %1429 = getelementptr inbounds i8, ptr %1390, i64 8
  store double %1428, ptr %1429, align 8
  %1430 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1317, i64 1
  %1431 = fmul double %1015, %1360
  %1432 = fmul double %1016, %1359
  %1433 = fsub double %1431, %1432
  %1434 = fmul double %1016, %1358
  %1435 = fmul double %1014, %1360
  %1436 = fsub double %1434, %1435
  %1437 = fmul double %1014, %1359
  %1438 = fmul double %1015, %1358
  %1439 = fsub double %1437, %1438
  %1440 = fmul double %1433, %1387
  %1441 = fmul double %1436, %1388
  %1442 = fadd double %1440, %1441
  %1443 = fmul double %1439, %1389
  %1444 = fadd double %1443, %1442
  %1445 = fmul double %1358, %1387
  %1446 = fmul double %1359, %1388
  %1447 = fadd double %1445, %1446
  %1448 = fmul double %1360, %1389
  %1449 = fadd double %1448, %1447
  %1450 = fmul double %1014, %1387
  %1451 = fmul double %1015, %1388
  %1452 = fadd double %1450, %1451
  %1453 = fmul double %1016, %1389
  %1454 = fadd double %1453, %1452
  %1455 = fmul double %1374, %1454
  %1456 = fsub double %1449, %1455
  %1457 = fmul double %1444, %1444
  %1458 = fmul double %1456, %1456
  %1459 = fadd double %1457, %1458
  %1460 = tail call double @llvm.sqrt.f64(double %1459)
  %1461 = fcmp olt double %1460, 0x3D06849B86A12B9B
  %1462 = fdiv double %1456, %1460
  %1463 = fdiv double %1444, %1460
  %1464 = select i1 %1461, double 1.000000e+00, double %1462
  %1465 = select i1 %1461, double 0.000000e+00, double %1463
  store double %1464, ptr %1430, align 16
  %1466 = getelementptr inbounds i8, ptr %1430, i64 8
  store double %1465, ptr %1466, align 8
  %1467 = add nsw i64 %1317, 1
  %1468 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1317, i64 2
  store double %1334, ptr %1468, align 16
  %1469 = getelementptr inbounds i8, ptr %1468, i64 8
  store double %1337, ptr %1469, align 8
  br label %1470

1470:                                             ; preds = %1327, %1315
  %1471 = phi i64 [ %1467, %1327 ], [ %1317, %1315 ]
  %1472 = add nuw nsw i64 %1316, 1
  %1473 = icmp eq i64 %1472, %1314
  br i1 %1473, label %1474, label %1315

1474:                                             ; preds = %1470, %1068
  %1475 = phi i64 [ 0, %1068 ], [ %1471, %1470 ]
  call void @llvm.lifetime.end.p0(i64 64, ptr nonnull %42) #13
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %41) #13
  br label %2044

1476:                                             ; preds = %1006
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %46) #13
  %1477 = fsub double %1056, %1008
  store double %1477, ptr %46, align 8
  %1478 = fsub double %1057, %1009
  store double %1478, ptr %279, align 8
  %1479 = fsub double %1058, %1010
  store double %1479, ptr %280, align 8
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %47) #13
  %1480 = fmul double %1477, %1477
  %1481 = fmul double %1478, %1478
  %1482 = fadd double %1480, %1481
  %1483 = fmul double %1479, %1479
  %1484 = fadd double %1482, %1483
  %1485 = tail call double @llvm.sqrt.f64(double %1484)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %40)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %39)
  %1486 = fsub double %959, %1065
  %1487 = fsub double %960, %1066
  %1488 = fsub double %961, %1067
  store double %1486, ptr %40, align 8
  store double %1487, ptr %283, align 8
  store double %1488, ptr %284, align 8
  %1489 = fsub double %1008, %1065
  %1490 = fsub double %1009, %1066
  %1491 = fsub double %1010, %1067
  store double %1489, ptr %39, align 8
  store double %1490, ptr %281, align 8
  store double %1491, ptr %282, align 8
  %1492 = fmul double %1486, %1486
  %1493 = fmul double %1487, %1487
  %1494 = fadd double %1492, %1493
  %1495 = fmul double %1488, %1488
  %1496 = fadd double %1494, %1495
  %1497 = fmul double %1489, %1489
  %1498 = fmul double %1490, %1490
  %1499 = fadd double %1497, %1498
  %1500 = fmul double %1491, %1491
  %1501 = fadd double %1499, %1500
  %1502 = fadd double %1501, %1496
  %1503 = fmul double %1485, %1485
  %1504 = fsub double %1502, %1503
  %1505 = fmul double %1504, 5.000000e-01
  call fastcc void @turns_to_height(ptr nonnull sret(%struct.Turns) align 8 %47, ptr noundef nonnull byval(%struct.Vector) align 8 %45, ptr noundef nonnull byval(%struct.Vector) align 8 %40, ptr noundef nonnull byval(%struct.Vector) align 8 %39, double noundef %1505)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %40)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %39)
  %1506 = load i64, ptr %47, align 8
  %1507 = icmp sgt i64 %1506, 0
  br i1 %1507, label %1508, label %1523

1508:                                             ; preds = %1476
  %1509 = fmul double %1017, %1486
  %1510 = fmul double %1018, %1487
  %1511 = fadd double %1509, %1510
  %1512 = fmul double %1019, %1488
  %1513 = fadd double %1511, %1512
  %1514 = fmul double %1018, %1488
  %1515 = fmul double %1019, %1487
  %1516 = fsub double %1514, %1515
  %1517 = fmul double %1019, %1486
  %1518 = fmul double %1017, %1488
  %1519 = fsub double %1517, %1518
  %1520 = fmul double %1017, %1487
  %1521 = fmul double %1018, %1486
  %1522 = fsub double %1520, %1521
  br label %1525

1523:                                             ; preds = %1557, %1476
  %1524 = phi i64 [ 0, %1476 ], [ %1558, %1557 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %47) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %46) #13
  br label %2044

1525:                                             ; preds = %1557, %1508
  %1526 = phi i64 [ 0, %1508 ], [ %1558, %1557 ]
  %1527 = phi i64 [ 0, %1508 ], [ %1559, %1557 ]
  %1528 = getelementptr inbounds %struct.Turns, ptr %47, i64 0, i32 1, i64 %1527
  %1529 = load double, ptr %1528, align 8
  %1530 = getelementptr inbounds i8, ptr %1528, i64 8
  %1531 = load double, ptr %1530, align 8
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %48) #13
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %49) #13
  %1532 = fsub double 1.000000e+00, %1529
  %1533 = fmul double %1513, %1532
  %1534 = fmul double %1486, %1529
  %1535 = fmul double %1516, %1531
  %1536 = fadd double %1534, %1535
  %1537 = fmul double %1017, %1533
  %1538 = fadd double %1537, %1536
  %1539 = fmul double %1487, %1529
  %1540 = fmul double %1519, %1531
  %1541 = fadd double %1539, %1540
  %1542 = fmul double %1018, %1533
  %1543 = fadd double %1542, %1541
  %1544 = fmul double %1488, %1529
  %1545 = fmul double %1522, %1531
  %1546 = fadd double %1544, %1545
  %1547 = fmul double %1019, %1533
  %1548 = fadd double %1546, %1547
  %1549 = fadd double %1065, %1538
  %1550 = fadd double %1066, %1543
  %1551 = fadd double %1067, %1548
  %1552 = fsub double %1549, %1008
  store double %1552, ptr %50, align 8
  %1553 = fsub double %1550, %1009
  store double %1553, ptr %285, align 8
  %1554 = fsub double %1551, %1010
  store double %1554, ptr %286, align 8
  call fastcc void @two_meeting(ptr nonnull sret(%struct.Turns) align 8 %49, ptr noundef nonnull byval(%struct.Vector) align 8 %43, ptr noundef nonnull byval(%struct.Vector) align 8 %44, ptr noundef nonnull byval(%struct.Vector) align 8 %50, ptr noundef nonnull byval(%struct.Vector) align 8 %46, ptr noundef nonnull %48)
  %1555 = load i64, ptr %49, align 8
  %1556 = icmp sgt i64 %1555, 0
  br i1 %1556, label %1561, label %1557

1557:                                             ; preds = %1561, %1525
  %1558 = phi i64 [ %1526, %1525 ], [ %1571, %1561 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %49) #13
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %48) #13
  %1559 = add nuw nsw i64 %1527, 1
  %1560 = icmp eq i64 %1559, %1506
  br i1 %1560, label %1523, label %1525

1561:                                             ; preds = %1525, %1561
  %1562 = phi i64 [ %1571, %1561 ], [ %1526, %1525 ]
  %1563 = phi i64 [ %1570, %1561 ], [ 0, %1525 ]
  %1564 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1562
  %1565 = getelementptr inbounds [2 x %struct.Turn], ptr %48, i64 0, i64 %1563
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(16) %1564, ptr noundef nonnull align 16 dereferenceable(16) %1565, i64 16, i1 false)
  %1566 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1562, i64 1
  %1567 = getelementptr inbounds %struct.Turns, ptr %49, i64 0, i32 1, i64 %1563
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(16) %1566, ptr noundef nonnull align 8 dereferenceable(16) %1567, i64 16, i1 false)
  %1568 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1562, i64 2
  store double %1529, ptr %1568, align 16
  %1569 = getelementptr inbounds i8, ptr %1568, i64 8
  store double %1531, ptr %1569, align 8
  %1570 = add nuw nsw i64 %1563, 1
  %1571 = add nsw i64 %1562, 1
  %1572 = icmp eq i64 %1570, %1555
  br i1 %1572, label %1557, label %1561

1573:                                             ; preds = %1006
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %51) #13
  %1574 = fsub double %959, %1008
  store double %1574, ptr %51, align 8
  %1575 = fsub double %960, %1009
  store double %1575, ptr %271, align 8
  %1576 = fsub double %961, %1010
  store double %1576, ptr %272, align 8
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %52) #13
  %1577 = fmul double %1574, %1574
  %1578 = fmul double %1575, %1575
  %1579 = fadd double %1577, %1578
  %1580 = fmul double %1576, %1576
  %1581 = fadd double %1579, %1580
  %1582 = tail call double @llvm.sqrt.f64(double %1581)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %38)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %37)
  %1583 = fsub double %1056, %1059
  %1584 = fsub double %1057, %1060
  %1585 = fsub double %1058, %1061
  store double %1583, ptr %38, align 8
  store double %1584, ptr %275, align 8
  store double %1585, ptr %276, align 8
  %1586 = fsub double %1008, %1059
  %1587 = fsub double %1009, %1060
  %1588 = fsub double %1010, %1061
  store double %1586, ptr %37, align 8
  store double %1587, ptr %273, align 8
  store double %1588, ptr %274, align 8
  %1589 = fmul double %1583, %1583
  %1590 = fmul double %1584, %1584
  %1591 = fadd double %1589, %1590
  %1592 = fmul double %1585, %1585
  %1593 = fadd double %1591, %1592
  %1594 = fmul double %1586, %1586
  %1595 = fmul double %1587, %1587
  %1596 = fadd double %1594, %1595
  %1597 = fmul double %1588, %1588
  %1598 = fadd double %1596, %1597
  %1599 = fadd double %1598, %1593
  %1600 = fmul double %1582, %1582
  %1601 = fsub double %1599, %1600
  %1602 = fmul double %1601, 5.000000e-01
  call fastcc void @turns_to_height(ptr nonnull sret(%struct.Turns) align 8 %52, ptr noundef nonnull byval(%struct.Vector) align 8 %43, ptr noundef nonnull byval(%struct.Vector) align 8 %38, ptr noundef nonnull byval(%struct.Vector) align 8 %37, double noundef %1602)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %38)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %37)
  %1603 = load i64, ptr %52, align 8
  %1604 = icmp sgt i64 %1603, 0
  br i1 %1604, label %1605, label %1620

1605:                                             ; preds = %1573
  %1606 = fmul double %1011, %1583
  %1607 = fmul double %1012, %1584
  %1608 = fadd double %1606, %1607
  %1609 = fmul double %1013, %1585
  %1610 = fadd double %1608, %1609
  %1611 = fmul double %1012, %1585
  %1612 = fmul double %1013, %1584
  %1613 = fsub double %1611, %1612
  %1614 = fmul double %1013, %1583
  %1615 = fmul double %1011, %1585
  %1616 = fsub double %1614, %1615
  %1617 = fmul double %1011, %1584
  %1618 = fmul double %1012, %1583
  %1619 = fsub double %1617, %1618
  br label %1622

1620:                                             ; preds = %1655, %1573
  %1621 = phi i64 [ 0, %1573 ], [ %1656, %1655 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %52) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %51) #13
  br label %2044

1622:                                             ; preds = %1655, %1605
  %1623 = phi i64 [ 0, %1605 ], [ %1656, %1655 ]
  %1624 = phi i64 [ 0, %1605 ], [ %1657, %1655 ]
  %1625 = getelementptr inbounds %struct.Turns, ptr %52, i64 0, i32 1, i64 %1624
  %1626 = load double, ptr %1625, align 8
  %1627 = getelementptr inbounds { double, double }, ptr %1625, i64 0, i32 1
  %1628 = load double, ptr %1627, align 8
  %1629 = fneg double %1628
  call void @llvm.lifetime.start.p0(i64 32, ptr nonnull %53) #13
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %54) #13
  %1630 = fsub double 1.000000e+00, %1626
  %1631 = fmul double %1610, %1630
  %1632 = fmul double %1583, %1626
  %1633 = fmul double %1613, %1628
  %1634 = fadd double %1632, %1633
  %1635 = fmul double %1011, %1631
  %1636 = fadd double %1635, %1634
  %1637 = fmul double %1584, %1626
  %1638 = fmul double %1616, %1628
  %1639 = fadd double %1637, %1638
  %1640 = fmul double %1012, %1631
  %1641 = fadd double %1640, %1639
  %1642 = fmul double %1585, %1626
  %1643 = fmul double %1619, %1628
  %1644 = fadd double %1642, %1643
  %1645 = fmul double %1013, %1631
  %1646 = fadd double %1644, %1645
  %1647 = fadd double %1059, %1636
  %1648 = fadd double %1060, %1641
  %1649 = fadd double %1061, %1646
  %1650 = fsub double %1647, %1008
  store double %1650, ptr %55, align 8
  %1651 = fsub double %1648, %1009
  store double %1651, ptr %277, align 8
  %1652 = fsub double %1649, %1010
  store double %1652, ptr %278, align 8
  call fastcc void @two_meeting(ptr nonnull sret(%struct.Turns) align 8 %54, ptr noundef nonnull byval(%struct.Vector) align 8 %44, ptr noundef nonnull byval(%struct.Vector) align 8 %45, ptr noundef nonnull byval(%struct.Vector) align 8 %51, ptr noundef nonnull byval(%struct.Vector) align 8 %55, ptr noundef nonnull %53)
  %1653 = load i64, ptr %54, align 8
  %1654 = icmp sgt i64 %1653, 0
  br i1 %1654, label %1659, label %1655

1655:                                             ; preds = %1659, %1622
  %1656 = phi i64 [ %1623, %1622 ], [ %1669, %1659 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %54) #13
  call void @llvm.lifetime.end.p0(i64 32, ptr nonnull %53) #13
  %1657 = add nuw nsw i64 %1624, 1
  %1658 = icmp eq i64 %1657, %1603
  br i1 %1658, label %1620, label %1622

1659:                                             ; preds = %1622, %1659
  %1660 = phi i64 [ %1669, %1659 ], [ %1623, %1622 ]
  %1661 = phi i64 [ %1668, %1659 ], [ 0, %1622 ]
  %1662 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1660
  store double %1626, ptr %1662, align 16
  %1663 = getelementptr inbounds i8, ptr %1662, i64 8
  store double %1629, ptr %1663, align 8
  %1664 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1660, i64 1
  %1665 = getelementptr inbounds [2 x %struct.Turn], ptr %53, i64 0, i64 %1661
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(16) %1664, ptr noundef nonnull align 16 dereferenceable(16) %1665, i64 16, i1 false)
  %1666 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1660, i64 2
  %1667 = getelementptr inbounds %struct.Turns, ptr %54, i64 0, i32 1, i64 %1661
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(16) %1666, ptr noundef nonnull align 8 dereferenceable(16) %1667, i64 16, i1 false)
  %1668 = add nuw nsw i64 %1661, 1
  %1669 = add nsw i64 %1660, 1
  %1670 = icmp eq i64 %1668, %1653
  br i1 %1670, label %1655, label %1659

1671:                                             ; preds = %1006
  %1672 = fsub double %1056, %1059
  %1673 = fsub double %1057, %1060
  %1674 = fsub double %1058, %1061
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %56) #13
  %1675 = fsub double %959, %1065
  store double %1675, ptr %57, align 8
  %1676 = fsub double %960, %1066
  store double %1676, ptr %265, align 8
  %1677 = fsub double %961, %1067
  store double %1677, ptr %266, align 8
  %1678 = fsub double %1056, %1065
  %1679 = fsub double %1057, %1066
  %1680 = fsub double %1058, %1067
  %1681 = fmul double %1011, %1678
  %1682 = fmul double %1012, %1679
  %1683 = fadd double %1681, %1682
  %1684 = fmul double %1013, %1680
  %1685 = fadd double %1683, %1684
  call fastcc void @turns_to_height(ptr nonnull sret(%struct.Turns) align 8 %56, ptr noundef nonnull byval(%struct.Vector) align 8 %45, ptr noundef nonnull byval(%struct.Vector) align 8 %57, ptr noundef nonnull byval(%struct.Vector) align 8 %43, double noundef %1685)
  %1686 = load i64, ptr %56, align 8
  %1687 = icmp sgt i64 %1686, 0
  br i1 %1687, label %1688, label %1723

1688:                                             ; preds = %1671
  %1689 = fmul double %1017, %1675
  %1690 = fmul double %1018, %1676
  %1691 = fadd double %1689, %1690
  %1692 = fmul double %1019, %1677
  %1693 = fadd double %1691, %1692
  %1694 = fmul double %1018, %1677
  %1695 = fmul double %1019, %1676
  %1696 = fsub double %1694, %1695
  %1697 = fmul double %1019, %1675
  %1698 = fmul double %1017, %1677
  %1699 = fsub double %1697, %1698
  %1700 = fmul double %1017, %1676
  %1701 = fmul double %1018, %1675
  %1702 = fsub double %1700, %1701
  %1703 = fmul double %1672, %1672
  %1704 = fmul double %1673, %1673
  %1705 = fadd double %1703, %1704
  %1706 = fmul double %1674, %1674
  %1707 = fadd double %1705, %1706
  %1708 = tail call double @llvm.sqrt.f64(double %1707)
  %1709 = fsub double %1059, %1062
  %1710 = fsub double %1060, %1063
  %1711 = fsub double %1061, %1064
  %1712 = fmul double %1709, %1709
  %1713 = fmul double %1710, %1710
  %1714 = fadd double %1712, %1713
  %1715 = fmul double %1711, %1711
  %1716 = fadd double %1714, %1715
  %1717 = fmul double %1708, %1708
  %1718 = fmul double %1011, %1672
  %1719 = fmul double %1012, %1673
  %1720 = fadd double %1718, %1719
  %1721 = fmul double %1013, %1674
  %1722 = fadd double %1720, %1721
  br label %1725

1723:                                             ; preds = %1780, %1671
  %1724 = phi i64 [ 0, %1671 ], [ %1781, %1780 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %56) #13
  br label %2044

1725:                                             ; preds = %1780, %1688
  %1726 = phi i64 [ 0, %1688 ], [ %1781, %1780 ]
  %1727 = phi i64 [ 0, %1688 ], [ %1782, %1780 ]
  %1728 = getelementptr inbounds %struct.Turns, ptr %56, i64 0, i32 1, i64 %1727
  %1729 = load double, ptr %1728, align 8
  %1730 = getelementptr inbounds i8, ptr %1728, i64 8
  %1731 = load double, ptr %1730, align 8
  %1732 = fsub double 1.000000e+00, %1729
  %1733 = fmul double %1693, %1732
  %1734 = fmul double %1675, %1729
  %1735 = fmul double %1696, %1731
  %1736 = fadd double %1734, %1735
  %1737 = fmul double %1017, %1733
  %1738 = fadd double %1737, %1736
  %1739 = fmul double %1676, %1729
  %1740 = fmul double %1699, %1731
  %1741 = fadd double %1739, %1740
  %1742 = fmul double %1018, %1733
  %1743 = fadd double %1742, %1741
  %1744 = fmul double %1677, %1729
  %1745 = fmul double %1702, %1731
  %1746 = fadd double %1744, %1745
  %1747 = fmul double %1019, %1733
  %1748 = fadd double %1746, %1747
  %1749 = fadd double %1065, %1738
  %1750 = fadd double %1066, %1743
  %1751 = fadd double %1067, %1748
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %58) #13
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %36)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %35)
  %1752 = fsub double %1749, %1062
  %1753 = fsub double %1750, %1063
  %1754 = fsub double %1751, %1064
  store double %1752, ptr %36, align 8
  store double %1753, ptr %269, align 8
  store double %1754, ptr %270, align 8
  store double %1709, ptr %35, align 8
  store double %1710, ptr %267, align 8
  store double %1711, ptr %268, align 8
  %1755 = fmul double %1752, %1752
  %1756 = fmul double %1753, %1753
  %1757 = fadd double %1755, %1756
  %1758 = fmul double %1754, %1754
  %1759 = fadd double %1758, %1757
  %1760 = fadd double %1716, %1759
  %1761 = fsub double %1760, %1717
  %1762 = fmul double %1761, 5.000000e-01
  call fastcc void @turns_to_height(ptr nonnull sret(%struct.Turns) align 8 %58, ptr noundef nonnull byval(%struct.Vector) align 8 %44, ptr noundef nonnull byval(%struct.Vector) align 8 %36, ptr noundef nonnull byval(%struct.Vector) align 8 %35, double noundef %1762)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %36)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %35)
  %1763 = load i64, ptr %58, align 8
  %1764 = icmp sgt i64 %1763, 0
  br i1 %1764, label %1765, label %1780

1765:                                             ; preds = %1725
  %1766 = fmul double %1014, %1752
  %1767 = fmul double %1015, %1753
  %1768 = fadd double %1766, %1767
  %1769 = fmul double %1016, %1754
  %1770 = fadd double %1769, %1768
  %1771 = fmul double %1015, %1754
  %1772 = fmul double %1016, %1753
  %1773 = fsub double %1771, %1772
  %1774 = fmul double %1016, %1752
  %1775 = fmul double %1014, %1754
  %1776 = fsub double %1774, %1775
  %1777 = fmul double %1014, %1753
  %1778 = fmul double %1015, %1752
  %1779 = fsub double %1777, %1778
  br label %1784

1780:                                             ; preds = %1784, %1725
  %1781 = phi i64 [ %1726, %1725 ], [ %1855, %1784 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %58) #13
  %1782 = add nuw nsw i64 %1727, 1
  %1783 = icmp eq i64 %1782, %1686
  br i1 %1783, label %1723, label %1725

1784:                                             ; preds = %1784, %1765
  %1785 = phi i64 [ %1726, %1765 ], [ %1855, %1784 ]
  %1786 = phi i64 [ 0, %1765 ], [ %1854, %1784 ]
  %1787 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1785
  %1788 = getelementptr inbounds %struct.Turns, ptr %58, i64 0, i32 1, i64 %1786
  %1789 = load double, ptr %1788, align 8
  %1790 = getelementptr inbounds { double, double }, ptr %1788, i64 0, i32 1
  %1791 = load double, ptr %1790, align 8
  %1792 = fsub double 1.000000e+00, %1789
  %1793 = fmul double %1770, %1792
  %1794 = fmul double %1752, %1789
  %1795 = fmul double %1773, %1791
  %1796 = fadd double %1794, %1795
  %1797 = fmul double %1014, %1793
  %1798 = fadd double %1797, %1796
  %1799 = fmul double %1753, %1789
  %1800 = fmul double %1776, %1791
  %1801 = fadd double %1799, %1800
  %1802 = fmul double %1015, %1793
  %1803 = fadd double %1802, %1801
  %1804 = fmul double %1754, %1789
  %1805 = fmul double %1779, %1791
  %1806 = fadd double %1804, %1805
  %1807 = fmul double %1016, %1793
  %1808 = fadd double %1806, %1807
  %1809 = fadd double %1062, %1798
  %1810 = fadd double %1063, %1803
  %1811 = fadd double %1064, %1808
  %1812 = fsub double %1809, %1059
  %1813 = fsub double %1810, %1060
  %1814 = fsub double %1811, %1061
  %1815 = fmul double %1012, %1814
  %1816 = fmul double %1013, %1813
  %1817 = fsub double %1815, %1816
  %1818 = fmul double %1013, %1812
  %1819 = fmul double %1011, %1814
  %1820 = fsub double %1818, %1819
  %1821 = fmul double %1011, %1813
  %1822 = fmul double %1012, %1812
  %1823 = fsub double %1821, %1822
  %1824 = fmul double %1672, %1817
  %1825 = fmul double %1673, %1820
  %1826 = fadd double %1824, %1825
  %1827 = fmul double %1674, %1823
  %1828 = fadd double %1827, %1826
  %1829 = fmul double %1672, %1812
  %1830 = fmul double %1673, %1813
  %1831 = fadd double %1829, %1830
  %1832 = fmul double %1674, %1814
  %1833 = fadd double %1832, %1831
  %1834 = fmul double %1011, %1812
  %1835 = fmul double %1012, %1813
  %1836 = fadd double %1834, %1835
  %1837 = fmul double %1013, %1814
  %1838 = fadd double %1837, %1836
  %1839 = fmul double %1722, %1838
  %1840 = fsub double %1833, %1839
  %1841 = fmul double %1828, %1828
  %1842 = fmul double %1840, %1840
  %1843 = fadd double %1841, %1842
  %1844 = tail call double @llvm.sqrt.f64(double %1843)
  %1845 = fcmp olt double %1844, 0x3D06849B86A12B9B
  %1846 = fdiv double %1840, %1844
  %1847 = fdiv double %1828, %1844
  %1848 = select i1 %1845, double 1.000000e+00, double %1846
  %1849 = select i1 %1845, double 0.000000e+00, double %1847
  store double %1848, ptr %1787, align 16
  %1850 = getelementptr inbounds i8, ptr %1787, i64 8
  store double %1849, ptr %1850, align 8
  %1851 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1785, i64 1
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(16) %1851, ptr noundef nonnull align 8 dereferenceable(16) %1788, i64 16, i1 false)
  %1852 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1785, i64 2
  store double %1729, ptr %1852, align 16
  %1853 = getelementptr inbounds i8, ptr %1852, i64 8
  store double %1731, ptr %1853, align 8
  %1854 = add nuw nsw i64 %1786, 1
  %1855 = add nsw i64 %1785, 1
  %1856 = icmp eq i64 %1854, %1763
  br i1 %1856, label %1780, label %1784

1857:                                             ; preds = %1006
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %59) #13
  %1858 = fsub double %1056, %1059
  store double %1858, ptr %60, align 8
  %1859 = fsub double %1057, %1060
  store double %1859, ptr %290, align 8
  %1860 = fsub double %1058, %1061
  store double %1860, ptr %291, align 8
  %1861 = fsub double %959, %1059
  %1862 = fsub double %960, %1060
  %1863 = fsub double %961, %1061
  %1864 = fmul double %1014, %1861
  %1865 = fmul double %1015, %1862
  %1866 = fadd double %1864, %1865
  %1867 = fmul double %1016, %1863
  %1868 = fadd double %1866, %1867
  call fastcc void @turns_to_height(ptr nonnull sret(%struct.Turns) align 8 %59, ptr noundef nonnull byval(%struct.Vector) align 8 %43, ptr noundef nonnull byval(%struct.Vector) align 8 %60, ptr noundef nonnull byval(%struct.Vector) align 8 %44, double noundef %1868)
  %1869 = load i64, ptr %59, align 8
  %1870 = icmp sgt i64 %1869, 0
  br i1 %1870, label %1871, label %1917

1871:                                             ; preds = %1857
  %1872 = fmul double %1011, %1858
  %1873 = fmul double %1012, %1859
  %1874 = fadd double %1872, %1873
  %1875 = fmul double %1013, %1860
  %1876 = fadd double %1874, %1875
  %1877 = fmul double %1012, %1860
  %1878 = fmul double %1013, %1859
  %1879 = fsub double %1877, %1878
  %1880 = fmul double %1013, %1858
  %1881 = fmul double %1011, %1860
  %1882 = fsub double %1880, %1881
  %1883 = fmul double %1011, %1859
  %1884 = fmul double %1012, %1858
  %1885 = fsub double %1883, %1884
  %1886 = fsub double %1062, %1065
  %1887 = fsub double %1063, %1066
  %1888 = fsub double %1064, %1067
  %1889 = fmul double %1886, %1886
  %1890 = fmul double %1887, %1887
  %1891 = fadd double %1889, %1890
  %1892 = fmul double %1888, %1888
  %1893 = fadd double %1891, %1892
  %1894 = fsub double %959, %1065
  %1895 = fsub double %960, %1066
  %1896 = fsub double %961, %1067
  %1897 = fmul double %1017, %1894
  %1898 = fmul double %1018, %1895
  %1899 = fadd double %1897, %1898
  %1900 = fmul double %1019, %1896
  %1901 = fadd double %1899, %1900
  %1902 = fmul double %1018, %1896
  %1903 = fmul double %1019, %1895
  %1904 = fsub double %1902, %1903
  %1905 = fmul double %1019, %1894
  %1906 = fmul double %1017, %1896
  %1907 = fsub double %1905, %1906
  %1908 = fmul double %1017, %1895
  %1909 = fmul double %1018, %1894
  %1910 = fsub double %1908, %1909
  %1911 = fmul double %1894, %1894
  %1912 = fmul double %1895, %1895
  %1913 = fadd double %1911, %1912
  %1914 = fmul double %1896, %1896
  %1915 = fadd double %1913, %1914
  %1916 = fadd double %1893, %1915
  br label %1919

1917:                                             ; preds = %1967, %1857
  %1918 = phi i64 [ 0, %1857 ], [ %1968, %1967 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %59) #13
  br label %2044

1919:                                             ; preds = %1967, %1871
  %1920 = phi i64 [ 0, %1871 ], [ %1968, %1967 ]
  %1921 = phi i64 [ 0, %1871 ], [ %1969, %1967 ]
  %1922 = getelementptr inbounds %struct.Turns, ptr %59, i64 0, i32 1, i64 %1921
  %1923 = load double, ptr %1922, align 8
  %1924 = getelementptr inbounds { double, double }, ptr %1922, i64 0, i32 1
  %1925 = load double, ptr %1924, align 8
  %1926 = fneg double %1925
  %1927 = fsub double 1.000000e+00, %1923
  %1928 = fmul double %1876, %1927
  %1929 = fmul double %1858, %1923
  %1930 = fmul double %1879, %1925
  %1931 = fadd double %1929, %1930
  %1932 = fmul double %1011, %1928
  %1933 = fadd double %1932, %1931
  %1934 = fmul double %1859, %1923
  %1935 = fmul double %1882, %1925
  %1936 = fadd double %1934, %1935
  %1937 = fmul double %1012, %1928
  %1938 = fadd double %1937, %1936
  %1939 = fmul double %1860, %1923
  %1940 = fmul double %1885, %1925
  %1941 = fadd double %1939, %1940
  %1942 = fmul double %1013, %1928
  %1943 = fadd double %1941, %1942
  %1944 = fadd double %1059, %1933
  %1945 = fadd double %1060, %1938
  %1946 = fadd double %1061, %1943
  %1947 = fsub double %1944, %1062
  %1948 = fsub double %1945, %1063
  %1949 = fsub double %1946, %1064
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %61) #13
  %1950 = fmul double %1947, %1947
  %1951 = fmul double %1948, %1948
  %1952 = fadd double %1950, %1951
  %1953 = fmul double %1949, %1949
  %1954 = fadd double %1953, %1952
  %1955 = tail call double @llvm.sqrt.f64(double %1954)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %34)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %33)
  store double %1894, ptr %34, align 8
  store double %1895, ptr %294, align 8
  store double %1896, ptr %295, align 8
  store double %1886, ptr %33, align 8
  store double %1887, ptr %292, align 8
  store double %1888, ptr %293, align 8
  %1956 = fmul double %1955, %1955
  %1957 = fsub double %1916, %1956
  %1958 = fmul double %1957, 5.000000e-01
  call fastcc void @turns_to_height(ptr nonnull sret(%struct.Turns) align 8 %61, ptr noundef nonnull byval(%struct.Vector) align 8 %45, ptr noundef nonnull byval(%struct.Vector) align 8 %34, ptr noundef nonnull byval(%struct.Vector) align 8 %33, double noundef %1958)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %34)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %33)
  %1959 = load i64, ptr %61, align 8
  %1960 = icmp sgt i64 %1959, 0
  br i1 %1960, label %1961, label %1967

1961:                                             ; preds = %1919
  %1962 = fmul double %1014, %1947
  %1963 = fmul double %1015, %1948
  %1964 = fadd double %1962, %1963
  %1965 = fmul double %1016, %1949
  %1966 = fadd double %1965, %1964
  br label %1971

1967:                                             ; preds = %1971, %1919
  %1968 = phi i64 [ %1920, %1919 ], [ %2042, %1971 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %61) #13
  %1969 = add nuw nsw i64 %1921, 1
  %1970 = icmp eq i64 %1969, %1869
  br i1 %1970, label %1917, label %1919

1971:                                             ; preds = %1971, %1961
  %1972 = phi i64 [ %1920, %1961 ], [ %2042, %1971 ]
  %1973 = phi i64 [ 0, %1961 ], [ %2041, %1971 ]
  %1974 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1972
  store double %1923, ptr %1974, align 16
  %1975 = getelementptr inbounds i8, ptr %1974, i64 8
  store double %1926, ptr %1975, align 8
  %1976 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1972, i64 2
  %1977 = getelementptr inbounds %struct.Turns, ptr %61, i64 0, i32 1, i64 %1973
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(16) %1976, ptr noundef nonnull align 8 dereferenceable(16) %1977, i64 16, i1 false)
  %1978 = getelementptr inbounds [3 x %struct.Turn], ptr %65, i64 %1972, i64 1
  %1979 = load double, ptr %1977, align 8
  %1980 = getelementptr inbounds { double, double }, ptr %1977, i64 0, i32 1
  %1981 = load double, ptr %1980, align 8
  %1982 = fsub double 1.000000e+00, %1979
  %1983 = fmul double %1901, %1982
  %1984 = fmul double %1894, %1979
  %1985 = fmul double %1904, %1981
  %1986 = fadd double %1984, %1985
  %1987 = fmul double %1017, %1983
  %1988 = fadd double %1987, %1986
  %1989 = fmul double %1895, %1979
  %1990 = fmul double %1907, %1981
  %1991 = fadd double %1989, %1990
  %1992 = fmul double %1018, %1983
  %1993 = fadd double %1992, %1991
  %1994 = fmul double %1896, %1979
  %1995 = fmul double %1910, %1981
  %1996 = fadd double %1994, %1995
  %1997 = fmul double %1019, %1983
  %1998 = fadd double %1996, %1997
  %1999 = fadd double %1065, %1988
  %2000 = fadd double %1066, %1993
  %2001 = fadd double %1067, %1998
  %2002 = fsub double %1999, %1062
  %2003 = fsub double %2000, %1063
  %2004 = fsub double %2001, %1064
  %2005 = fmul double %1015, %2004
  %2006 = fmul double %1016, %2003
  %2007 = fsub double %2005, %2006
  %2008 = fmul double %1016, %2002
  %2009 = fmul double %1014, %2004
  %2010 = fsub double %2008, %2009
  %2011 = fmul double %1014, %2003
  %2012 = fmul double %1015, %2002
  %2013 = fsub double %2011, %2012
  %2014 = fmul double %1947, %2007
  %2015 = fmul double %1948, %2010
  %2016 = fadd double %2014, %2015
  %2017 = fmul double %1949, %2013
  %2018 = fadd double %2017, %2016
  %2019 = fmul double %1947, %2002
  %2020 = fmul double %1948, %2003
  %2021 = fadd double %2019, %2020
  %2022 = fmul double %1949, %2004
  %2023 = fadd double %2022, %2021
  %2024 = fmul double %1014, %2002
  %2025 = fmul double %1015, %2003
  %2026 = fadd double %2024, %2025
  %2027 = fmul double %1016, %2004
  %2028 = fadd double %2027, %2026
  %2029 = fmul double %1966, %2028
  %2030 = fsub double %2023, %2029
  %2031 = fmul double %2018, %2018
  %2032 = fmul double %2030, %2030
  %2033 = fadd double %2031, %2032
  %2034 = tail call double @llvm.sqrt.f64(double %2033)
  %2035 = fcmp olt double %2034, 0x3D06849B86A12B9B
  %2036 = fdiv double %2030, %2034
  %2037 = fdiv double %2018, %2034
  %2038 = select i1 %2035, double 1.000000e+00, double %2036
  %2039 = select i1 %2035, double 0.000000e+00, double %2037
  store double %2038, ptr %1978, align 16
  %2040 = getelementptr inbounds i8, ptr %1978, i64 8
  store double %2039, ptr %2040, align 8
  %2041 = add nuw nsw i64 %1973, 1
  %2042 = add nsw i64 %1972, 1
  %2043 = icmp eq i64 %2041, %1959
  br i1 %2043, label %1967, label %1971

2044:                                             ; preds = %1917, %1723, %1620, %1523, %1474
  %2045 = phi i64 [ %1475, %1474 ], [ %1524, %1523 ], [ %1621, %1620 ], [ %1724, %1723 ], [ %1918, %1917 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %45) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %44) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %43) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %50)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %55)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %57)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %60)
  %2046 = icmp sgt i64 %2045, 0
  br i1 %2046, label %2047, label %2253

2047:                                             ; preds = %2044, %2249
  %2048 = phi i64 [ %2250, %2249 ], [ 0, %2044 ]
  %2049 = phi i64 [ %2251, %2249 ], [ 0, %2044 ]
  %2050 = mul nsw i64 %2048, 6
  %2051 = getelementptr inbounds double, ptr %79, i64 %2050
  %2052 = getelementptr inbounds [4 x [3 x %struct.Turn]], ptr %65, i64 0, i64 %2049
  br label %2053

2053:                                             ; preds = %2073, %2047
  %2054 = phi i1 [ false, %2047 ], [ %2076, %2073 ]
  %2055 = phi i64 [ 0, %2047 ], [ %2075, %2073 ]
  %2056 = getelementptr inbounds %struct.Turn, ptr %2052, i64 %2055
  %2057 = load double, ptr %2056, align 16
  %2058 = getelementptr inbounds { double, double }, ptr %2056, i64 0, i32 1
  %2059 = load double, ptr %2058, align 8
  %2060 = tail call double @atan2(double noundef %2059, double noundef %2057) #14
  %2061 = getelementptr inbounds double, ptr %88, i64 %2055
  %2062 = load double, ptr %2061, align 8
  %2063 = getelementptr inbounds double, ptr %89, i64 %2055
  %2064 = load double, ptr %2063, align 8
  %2065 = fsub double %2060, %2062
  %2066 = fadd double %2065, 1.000000e-05
  %2067 = fdiv double %2066, 0x401921FB54442D18
  %2068 = tail call double @llvm.floor.f64(double %2067)
  %2069 = fmul double %2068, 0x401921FB54442D18
  %2070 = fsub double %2060, %2069
  %2071 = fadd double %2064, 1.000000e-05
  %2072 = fcmp ugt double %2070, %2071
  br i1 %2072, label %2078, label %2073

2073:                                             ; preds = %2053
  %2074 = getelementptr inbounds double, ptr %2051, i64 %2055
  store double %2060, ptr %2074, align 8
  %2075 = add nuw nsw i64 %2055, 1
  %2076 = icmp ugt i64 %2055, 1
  %2077 = icmp eq i64 %2075, 3
  br i1 %2077, label %2078, label %2053

2078:                                             ; preds = %2073, %2053
  %2079 = phi i1 [ %2054, %2053 ], [ %2076, %2073 ]
  br i1 %2079, label %2080, label %2249

2080:                                             ; preds = %2078
  %2081 = load double, ptr %2051, align 16
  %2082 = getelementptr inbounds double, ptr %2051, i64 1
  %2083 = load double, ptr %2082, align 8
  %2084 = getelementptr inbounds double, ptr %2051, i64 2
  %2085 = load double, ptr %2084, align 16
  %2086 = getelementptr inbounds [4 x [3 x %struct.Turn]], ptr %65, i64 0, i64 %2049, i64 1
  %2087 = load double, ptr %2086, align 16
  %2088 = getelementptr inbounds { double, double }, ptr %2086, i64 0, i32 1
  %2089 = load double, ptr %2088, align 8
  %2090 = load double, ptr %2052, align 16
  %2091 = getelementptr inbounds { double, double }, ptr %2052, i64 0, i32 1
  %2092 = load double, ptr %2091, align 8
  %2093 = fsub double 1.000000e+00, %2090
  %2094 = fsub double 1.000000e+00, %2087
  %2095 = getelementptr inbounds [4 x [3 x %struct.Turn]], ptr %65, i64 0, i64 %2049, i64 2
  %2096 = load double, ptr %2095, align 16
  %2097 = getelementptr inbounds { double, double }, ptr %2095, i64 0, i32 1
  %2098 = load double, ptr %2097, align 8
  %2099 = fsub double 1.000000e+00, %2096
  br label %2103

2100:                                             ; preds = %2103
  %2101 = call fastcc i64 @orient(ptr noundef nonnull byval(%struct.Vector) align 8 %62, ptr noundef nonnull byval(%struct.Vector) align 8 %63, ptr noundef nonnull byval(%struct.Vector) align 8 %64, ptr noundef nonnull %67, ptr noundef nonnull %66)
  %2102 = icmp sgt i64 %2101, 0
  br i1 %2102, label %2206, label %2249

2103:                                             ; preds = %2103, %2080
  %2104 = phi i64 [ 0, %2080 ], [ %2204, %2103 ]
  %2105 = getelementptr inbounds [4 x double], ptr %80, i64 0, i64 %2104
  %2106 = load double, ptr %2105, align 8
  %2107 = getelementptr inbounds [4 x double], ptr %80, i64 1, i64 %2104
  %2108 = load double, ptr %2107, align 8
  %2109 = getelementptr inbounds [4 x double], ptr %80, i64 2, i64 %2104
  %2110 = load double, ptr %2109, align 8
  %2111 = fmul double %1011, %2106
  %2112 = fmul double %1012, %2108
  %2113 = fadd double %2111, %2112
  %2114 = fmul double %1013, %2110
  %2115 = fadd double %2113, %2114
  %2116 = fmul double %2093, %2115
  %2117 = fmul double %1012, %2110
  %2118 = fmul double %1013, %2108
  %2119 = fsub double %2117, %2118
  %2120 = fmul double %1013, %2106
  %2121 = fmul double %1011, %2110
  %2122 = fsub double %2120, %2121
  %2123 = fmul double %1011, %2108
  %2124 = fmul double %1012, %2106
  %2125 = fsub double %2123, %2124
  %2126 = fmul double %2090, %2106
  %2127 = fmul double %2092, %2119
  %2128 = fsub double %2126, %2127
  %2129 = fmul double %1011, %2116
  %2130 = fadd double %2129, %2128
  %2131 = fmul double %2090, %2108
  %2132 = fmul double %2092, %2122
  %2133 = fsub double %2131, %2132
  %2134 = fmul double %1012, %2116
  %2135 = fadd double %2134, %2133
  %2136 = fmul double %2090, %2110
  %2137 = fmul double %2092, %2125
  %2138 = fsub double %2136, %2137
  %2139 = fmul double %1013, %2116
  %2140 = fadd double %2138, %2139
  %2141 = fmul double %1014, %2130
  %2142 = fmul double %1015, %2135
  %2143 = fadd double %2141, %2142
  %2144 = fmul double %1016, %2140
  %2145 = fadd double %2144, %2143
  %2146 = fmul double %2094, %2145
  %2147 = fmul double %1015, %2140
  %2148 = fmul double %1016, %2135
  %2149 = fsub double %2147, %2148
  %2150 = fmul double %1016, %2130
  %2151 = fmul double %1014, %2140
  %2152 = fsub double %2150, %2151
  %2153 = fmul double %1014, %2135
  %2154 = fmul double %1015, %2130
  %2155 = fsub double %2153, %2154
  %2156 = fmul double %2087, %2130
  %2157 = fmul double %2089, %2149
  %2158 = fsub double %2156, %2157
  %2159 = fmul double %1014, %2146
  %2160 = fadd double %2158, %2159
  %2161 = fmul double %2087, %2135
  %2162 = fmul double %2089, %2152
  %2163 = fsub double %2161, %2162
  %2164 = fmul double %1015, %2146
  %2165 = fadd double %2163, %2164
  %2166 = fmul double %2087, %2140
  %2167 = fmul double %2089, %2155
  %2168 = fsub double %2166, %2167
  %2169 = fmul double %1016, %2146
  %2170 = fadd double %2168, %2169
  %2171 = fmul double %1017, %2160
  %2172 = fmul double %1018, %2165
  %2173 = fadd double %2171, %2172
  %2174 = fmul double %1019, %2170
  %2175 = fadd double %2174, %2173
  %2176 = fmul double %2099, %2175
  %2177 = fmul double %1018, %2170
  %2178 = fmul double %1019, %2165
  %2179 = fsub double %2177, %2178
  %2180 = fmul double %1019, %2160
  %2181 = fmul double %1017, %2170
  %2182 = fsub double %2180, %2181
  %2183 = fmul double %1017, %2165
  %2184 = fmul double %1018, %2160
  %2185 = fsub double %2183, %2184
  %2186 = fmul double %2096, %2160
  %2187 = fmul double %2098, %2179
  %2188 = fsub double %2186, %2187
  %2189 = fmul double %1017, %2176
  %2190 = fadd double %2188, %2189
  %2191 = fmul double %2096, %2165
  %2192 = fmul double %2098, %2182
  %2193 = fsub double %2191, %2192
  %2194 = fmul double %1018, %2176
  %2195 = fadd double %2193, %2194
  %2196 = fmul double %2096, %2170
  %2197 = fmul double %2098, %2185
  %2198 = fsub double %2196, %2197
  %2199 = fmul double %1019, %2176
  %2200 = fadd double %2198, %2199
  %2201 = getelementptr inbounds [4 x double], ptr %67, i64 0, i64 %2104
  store double %2190, ptr %2201, align 8
  %2202 = getelementptr inbounds [4 x double], ptr %67, i64 1, i64 %2104
  store double %2195, ptr %2202, align 8
  %2203 = getelementptr inbounds [4 x double], ptr %67, i64 2, i64 %2104
  store double %2200, ptr %2203, align 8
  %2204 = add nuw nsw i64 %2104, 1
  %2205 = icmp eq i64 %2204, 3
  br i1 %2205, label %2100, label %2103

2206:                                             ; preds = %2100, %2245
  %2207 = phi i64 [ %2246, %2245 ], [ %2048, %2100 ]
  %2208 = phi i64 [ %2247, %2245 ], [ 0, %2100 ]
  %2209 = mul nsw i64 %2207, 6
  %2210 = getelementptr inbounds double, ptr %79, i64 %2209
  %2211 = getelementptr inbounds [2 x [3 x %struct.Turn]], ptr %66, i64 0, i64 %2208
  %2212 = getelementptr inbounds double, ptr %2210, i64 3
  br label %2213

2213:                                             ; preds = %2234, %2206
  %2214 = phi i1 [ false, %2206 ], [ %2237, %2234 ]
  %2215 = phi i64 [ 0, %2206 ], [ %2236, %2234 ]
  %2216 = getelementptr inbounds %struct.Turn, ptr %2211, i64 %2215
  %2217 = load double, ptr %2216, align 16
  %2218 = getelementptr inbounds { double, double }, ptr %2216, i64 0, i32 1
  %2219 = load double, ptr %2218, align 8
  %2220 = tail call double @atan2(double noundef %2219, double noundef %2217) #14
  %2221 = add nuw nsw i64 %2215, 3
  %2222 = getelementptr inbounds double, ptr %88, i64 %2221
  %2223 = load double, ptr %2222, align 8
  %2224 = getelementptr inbounds double, ptr %89, i64 %2221
  %2225 = load double, ptr %2224, align 8
  %2226 = fsub double %2220, %2223
  %2227 = fadd double %2226, 1.000000e-05
  %2228 = fdiv double %2227, 0x401921FB54442D18
  %2229 = tail call double @llvm.floor.f64(double %2228)
  %2230 = fmul double %2229, 0x401921FB54442D18
  %2231 = fsub double %2220, %2230
  %2232 = fadd double %2225, 1.000000e-05
  %2233 = fcmp ugt double %2231, %2232
  br i1 %2233, label %2239, label %2234

2234:                                             ; preds = %2213
  %2235 = getelementptr inbounds double, ptr %2212, i64 %2215
  store double %2220, ptr %2235, align 8
  %2236 = add nuw nsw i64 %2215, 1
  %2237 = icmp ugt i64 %2215, 1
  %2238 = icmp eq i64 %2236, 3
  br i1 %2238, label %2239, label %2213

2239:                                             ; preds = %2234, %2213
  %2240 = phi i1 [ %2214, %2213 ], [ %2237, %2234 ]
  br i1 %2240, label %2241, label %2245

2241:                                             ; preds = %2239
  store double %2081, ptr %2210, align 16
  %2242 = getelementptr inbounds double, ptr %2210, i64 1
  store double %2083, ptr %2242, align 8
  %2243 = getelementptr inbounds double, ptr %2210, i64 2
  store double %2085, ptr %2243, align 16
  %2244 = add nsw i64 %2207, 1
  br label %2245

2245:                                             ; preds = %2241, %2239
  %2246 = phi i64 [ %2244, %2241 ], [ %2207, %2239 ]
  %2247 = add nuw nsw i64 %2208, 1
  %2248 = icmp eq i64 %2247, %2101
  br i1 %2248, label %2249, label %2206

2249:                                             ; preds = %2245, %2100, %2078
  %2250 = phi i64 [ %2048, %2078 ], [ %2048, %2100 ], [ %2246, %2245 ]
  %2251 = add nuw nsw i64 %2049, 1
  %2252 = icmp eq i64 %2251, %2045
  br i1 %2252, label %2253, label %2047

2253:                                             ; preds = %2249, %2044
  %2254 = phi i64 [ 0, %2044 ], [ %2250, %2249 ]
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %67) #13
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %66) #13
  call void @llvm.lifetime.end.p0(i64 192, ptr nonnull %65) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %64) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %63) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %62) #13
  br label %3458

2255:                                             ; preds = %1004
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %30)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %25) #13
  %2256 = load double, ptr %78, align 8
  store double %2256, ptr %25, align 8
  %2257 = load double, ptr %199, align 8
  store double %2257, ptr %198, align 8
  %2258 = load double, ptr %201, align 8
  store double %2258, ptr %200, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %26) #13
  %2259 = load double, ptr %202, align 8
  store double %2259, ptr %26, align 8
  %2260 = load double, ptr %204, align 8
  store double %2260, ptr %203, align 8
  %2261 = load double, ptr %206, align 8
  store double %2261, ptr %205, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %27) #13
  %2262 = load double, ptr %207, align 8
  store double %2262, ptr %27, align 8
  %2263 = load double, ptr %209, align 8
  store double %2263, ptr %208, align 8
  %2264 = load double, ptr %211, align 8
  store double %2264, ptr %210, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %28) #13
  %2265 = load double, ptr %212, align 8
  store double %2265, ptr %28, align 8
  %2266 = load double, ptr %214, align 8
  store double %2266, ptr %213, align 8
  %2267 = load double, ptr %216, align 8
  store double %2267, ptr %215, align 8
  %2268 = load double, ptr %87, align 8
  %2269 = load double, ptr %217, align 8
  %2270 = load double, ptr %218, align 8
  %2271 = load double, ptr %219, align 8
  %2272 = load double, ptr %220, align 8
  %2273 = load double, ptr %221, align 8
  %2274 = load double, ptr %222, align 8
  %2275 = load double, ptr %223, align 8
  %2276 = load double, ptr %224, align 8
  %2277 = load double, ptr %225, align 8
  %2278 = load double, ptr %226, align 8
  %2279 = load double, ptr %227, align 8
  %2280 = load double, ptr %228, align 8
  %2281 = load double, ptr %229, align 8
  %2282 = load double, ptr %230, align 8
  %2283 = fmul double %2259, %2280
  %2284 = fmul double %2260, %2281
  %2285 = fadd double %2283, %2284
  %2286 = fmul double %2261, %2282
  %2287 = fadd double %2285, %2286
  %2288 = load double, ptr %231, align 8
  %2289 = load double, ptr %232, align 8
  %2290 = load double, ptr %233, align 8
  %2291 = fmul double %2259, %2288
  %2292 = fmul double %2260, %2289
  %2293 = fadd double %2291, %2292
  %2294 = fmul double %2261, %2290
  %2295 = fadd double %2293, %2294
  %2296 = load double, ptr %80, align 16
  %2297 = fmul double %959, %2296
  %2298 = load double, ptr %183, align 8
  %2299 = fmul double %960, %2298
  %2300 = fadd double %2297, %2299
  %2301 = load double, ptr %184, align 16
  %2302 = fmul double %961, %2301
  %2303 = fadd double %2300, %2302
  %2304 = load double, ptr %185, align 16
  %2305 = fmul double %959, %2304
  %2306 = load double, ptr %186, align 8
  %2307 = fmul double %960, %2306
  %2308 = fadd double %2305, %2307
  %2309 = load double, ptr %187, align 16
  %2310 = fmul double %961, %2309
  %2311 = fadd double %2308, %2310
  %2312 = load double, ptr %188, align 16
  %2313 = fmul double %959, %2312
  %2314 = load double, ptr %189, align 8
  %2315 = fmul double %960, %2314
  %2316 = fadd double %2313, %2315
  %2317 = load double, ptr %190, align 16
  %2318 = fmul double %961, %2317
  %2319 = fadd double %2316, %2318
  %2320 = load double, ptr %180, align 8
  %2321 = load double, ptr %181, align 8
  %2322 = load double, ptr %182, align 8
  %2323 = fadd double %2303, %2320
  %2324 = fadd double %2311, %2321
  %2325 = fadd double %2319, %2322
  %2326 = tail call double @llvm.fabs.f64(double %2259)
  %2327 = fcmp olt double %2326, 6.000000e-01
  %2328 = fneg double %2261
  %2329 = fneg double %2259
  %2330 = select i1 %2327, double %2260, double %2329
  %2331 = select i1 %2327, double %2328, double 0.000000e+00
  %2332 = select i1 %2327, double 0.000000e+00, double %2261
  %2333 = fmul double %2332, %2332
  %2334 = fmul double %2331, %2331
  %2335 = fadd double %2334, %2333
  %2336 = fmul double %2330, %2330
  %2337 = fadd double %2336, %2335
  %2338 = tail call double @llvm.sqrt.f64(double %2337)
  %2339 = fdiv double %2332, %2338
  %2340 = fdiv double %2331, %2338
  %2341 = fdiv double %2330, %2338
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %29) #13
  %2342 = fsub double %2323, %2268
  store double %2342, ptr %30, align 8
  %2343 = fsub double %2324, %2269
  store double %2343, ptr %234, align 8
  %2344 = fsub double %2325, %2270
  store double %2344, ptr %235, align 8
  %2345 = fsub double %959, %2268
  %2346 = fsub double %960, %2269
  %2347 = fsub double %961, %2270
  %2348 = fmul double %2259, %2345
  %2349 = fmul double %2260, %2346
  %2350 = fadd double %2348, %2349
  %2351 = fmul double %2261, %2347
  %2352 = fadd double %2350, %2351
  call fastcc void @turns_to_height(ptr nonnull sret(%struct.Turns) align 8 %29, ptr noundef nonnull byval(%struct.Vector) align 8 %25, ptr noundef nonnull byval(%struct.Vector) align 8 %30, ptr noundef nonnull byval(%struct.Vector) align 8 %26, double noundef %2352)
  %2353 = load i64, ptr %29, align 8
  %2354 = icmp sgt i64 %2353, 0
  br i1 %2354, label %2355, label %2962

2355:                                             ; preds = %2255
  %2356 = fmul double %2256, %2342
  %2357 = fmul double %2257, %2343
  %2358 = fadd double %2356, %2357
  %2359 = fmul double %2258, %2344
  %2360 = fadd double %2358, %2359
  %2361 = fmul double %2257, %2344
  %2362 = fmul double %2258, %2343
  %2363 = fsub double %2361, %2362
  %2364 = fmul double %2258, %2342
  %2365 = fmul double %2256, %2344
  %2366 = fsub double %2364, %2365
  %2367 = fmul double %2256, %2343
  %2368 = fmul double %2257, %2342
  %2369 = fsub double %2367, %2368
  %2370 = fmul double %2256, %2259
  %2371 = fmul double %2257, %2260
  %2372 = fadd double %2370, %2371
  %2373 = fmul double %2258, %2261
  %2374 = fadd double %2372, %2373
  %2375 = fmul double %2257, %2261
  %2376 = fmul double %2258, %2260
  %2377 = fsub double %2375, %2376
  %2378 = fmul double %2258, %2259
  %2379 = fmul double %2256, %2261
  %2380 = fsub double %2378, %2379
  %2381 = fmul double %2256, %2260
  %2382 = fmul double %2257, %2259
  %2383 = fsub double %2381, %2382
  %2384 = fmul double %2259, %2262
  %2385 = fmul double %2260, %2263
  %2386 = fadd double %2384, %2385
  %2387 = fmul double %2261, %2264
  %2388 = fadd double %2386, %2387
  %2389 = fmul double %2261, %2263
  %2390 = fmul double %2260, %2264
  %2391 = fsub double %2389, %2390
  %2392 = fmul double %2259, %2264
  %2393 = fmul double %2261, %2262
  %2394 = fsub double %2392, %2393
  %2395 = fmul double %2260, %2262
  %2396 = fmul double %2259, %2263
  %2397 = fsub double %2395, %2396
  %2398 = fmul double %2262, %2339
  %2399 = fmul double %2340, %2263
  %2400 = fadd double %2398, %2399
  %2401 = fmul double %2341, %2264
  %2402 = fadd double %2400, %2401
  %2403 = fmul double %2341, %2263
  %2404 = fmul double %2340, %2264
  %2405 = fsub double %2403, %2404
  %2406 = fmul double %2339, %2264
  %2407 = fmul double %2262, %2341
  %2408 = fsub double %2406, %2407
  %2409 = fmul double %2262, %2340
  %2410 = fmul double %2339, %2263
  %2411 = fsub double %2409, %2410
  %2412 = fmul double %2260, %2341
  %2413 = fmul double %2261, %2340
  %2414 = fsub double %2412, %2413
  %2415 = fmul double %2261, %2339
  %2416 = fmul double %2259, %2341
  %2417 = fsub double %2415, %2416
  %2418 = fmul double %2259, %2340
  %2419 = fmul double %2260, %2339
  %2420 = fsub double %2418, %2419
  %2421 = fmul double %2259, %2339
  %2422 = fmul double %2260, %2340
  %2423 = fadd double %2421, %2422
  %2424 = fmul double %2261, %2341
  %2425 = fadd double %2424, %2423
  %2426 = fsub double %959, %2277
  %2427 = fsub double %960, %2278
  %2428 = fsub double %961, %2279
  %2429 = fmul double %2259, %2426
  %2430 = fmul double %2260, %2427
  %2431 = fadd double %2429, %2430
  %2432 = fmul double %2261, %2428
  %2433 = fadd double %2431, %2432
  %2434 = fmul double %2260, %2428
  %2435 = fmul double %2261, %2427
  %2436 = fsub double %2434, %2435
  %2437 = fmul double %2261, %2426
  %2438 = fmul double %2259, %2428
  %2439 = fsub double %2437, %2438
  %2440 = fmul double %2259, %2427
  %2441 = fmul double %2260, %2426
  %2442 = fsub double %2440, %2441
  %2443 = fsub double %2277, %2274
  %2444 = fsub double %2278, %2275
  %2445 = fsub double %2279, %2276
  %2446 = fsub double %2271, %2274
  %2447 = fsub double %2272, %2275
  %2448 = fsub double %2273, %2276
  %2449 = fmul double %2443, %2443
  %2450 = fmul double %2444, %2444
  %2451 = fadd double %2449, %2450
  %2452 = fmul double %2445, %2445
  %2453 = fadd double %2451, %2452
  %2454 = fmul double %2446, %2446
  %2455 = fmul double %2447, %2447
  %2456 = fadd double %2454, %2455
  %2457 = fmul double %2448, %2448
  %2458 = fadd double %2456, %2457
  %2459 = fadd double %2458, %2453
  %2460 = fmul double %2259, %2443
  %2461 = fmul double %2260, %2444
  %2462 = fadd double %2460, %2461
  %2463 = fmul double %2261, %2445
  %2464 = fadd double %2462, %2463
  %2465 = fmul double %2260, %2445
  %2466 = fmul double %2261, %2444
  %2467 = fsub double %2465, %2466
  %2468 = fmul double %2261, %2443
  %2469 = fmul double %2259, %2445
  %2470 = fsub double %2468, %2469
  %2471 = fmul double %2259, %2444
  %2472 = fmul double %2260, %2443
  %2473 = fsub double %2471, %2472
  %2474 = load double, ptr %88, align 8
  %2475 = load double, ptr %89, align 8
  %2476 = fadd double %2475, 1.000000e-05
  %2477 = fmul double %2265, %2296
  %2478 = fmul double %2266, %2298
  %2479 = fadd double %2477, %2478
  %2480 = fmul double %2267, %2301
  %2481 = fadd double %2479, %2480
  %2482 = fmul double %2265, %2304
  %2483 = fmul double %2266, %2306
  %2484 = fadd double %2482, %2483
  %2485 = fmul double %2267, %2309
  %2486 = fadd double %2484, %2485
  %2487 = fmul double %2265, %2312
  %2488 = fmul double %2266, %2314
  %2489 = fadd double %2487, %2488
  %2490 = fmul double %2267, %2317
  %2491 = fadd double %2489, %2490
  %2492 = load double, ptr %236, align 8
  %2493 = load double, ptr %237, align 8
  %2494 = fadd double %2493, 1.000000e-05
  %2495 = load double, ptr %238, align 8
  %2496 = load double, ptr %239, align 8
  %2497 = fadd double %2496, 1.000000e-05
  %2498 = load double, ptr %244, align 8
  %2499 = load double, ptr %245, align 8
  %2500 = fadd double %2499, 1.000000e-05
  %2501 = load double, ptr %246, align 8
  %2502 = load double, ptr %247, align 8
  %2503 = fadd double %2502, 1.000000e-05
  %2504 = load double, ptr %248, align 8
  %2505 = load double, ptr %249, align 8
  %2506 = fadd double %2505, 1.000000e-05
  br label %2507

2507:                                             ; preds = %2958, %2355
  %2508 = phi i64 [ 0, %2355 ], [ %2959, %2958 ]
  %2509 = phi i64 [ 0, %2355 ], [ %2960, %2958 ]
  %2510 = getelementptr inbounds %struct.Turns, ptr %29, i64 0, i32 1, i64 %2509
  %2511 = load double, ptr %2510, align 8
  %2512 = getelementptr inbounds { double, double }, ptr %2510, i64 0, i32 1
  %2513 = load double, ptr %2512, align 8
  %2514 = fneg double %2513
  %2515 = tail call double @atan2(double noundef %2514, double noundef %2511) #14
  %2516 = fsub double %2515, %2474
  %2517 = fadd double %2516, 1.000000e-05
  %2518 = fdiv double %2517, 0x401921FB54442D18
  %2519 = tail call double @llvm.floor.f64(double %2518)
  %2520 = fmul double %2519, 0x401921FB54442D18
  %2521 = fsub double %2515, %2520
  %2522 = fcmp ugt double %2521, %2476
  br i1 %2522, label %2958, label %2523

2523:                                             ; preds = %2507
  %2524 = fsub double 1.000000e+00, %2511
  %2525 = fmul double %2360, %2524
  %2526 = fmul double %2342, %2511
  %2527 = fmul double %2363, %2513
  %2528 = fadd double %2526, %2527
  %2529 = fmul double %2256, %2525
  %2530 = fadd double %2529, %2528
  %2531 = fmul double %2343, %2511
  %2532 = fmul double %2366, %2513
  %2533 = fadd double %2531, %2532
  %2534 = fmul double %2257, %2525
  %2535 = fadd double %2534, %2533
  %2536 = fmul double %2344, %2511
  %2537 = fmul double %2369, %2513
  %2538 = fadd double %2536, %2537
  %2539 = fmul double %2258, %2525
  %2540 = fadd double %2538, %2539
  %2541 = fadd double %2268, %2530
  %2542 = fadd double %2269, %2535
  %2543 = fadd double %2270, %2540
  %2544 = fmul double %2374, %2524
  %2545 = fmul double %2259, %2511
  %2546 = fmul double %2377, %2513
  %2547 = fsub double %2545, %2546
  %2548 = fmul double %2256, %2544
  %2549 = fadd double %2548, %2547
  %2550 = fmul double %2260, %2511
  %2551 = fmul double %2380, %2513
  %2552 = fsub double %2550, %2551
  %2553 = fmul double %2257, %2544
  %2554 = fadd double %2553, %2552
  %2555 = fmul double %2261, %2511
  %2556 = fmul double %2383, %2513
  %2557 = fsub double %2555, %2556
  %2558 = fmul double %2258, %2544
  %2559 = fadd double %2557, %2558
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %31) #13
  %2560 = fmul double %2481, %2549
  %2561 = fmul double %2486, %2554
  %2562 = fadd double %2560, %2561
  %2563 = fmul double %2491, %2559
  %2564 = fadd double %2563, %2562
  call fastcc void @turns_to_height(ptr nonnull sret(%struct.Turns) align 8 %31, ptr noundef nonnull byval(%struct.Vector) align 8 %27, ptr noundef nonnull byval(%struct.Vector) align 8 %28, ptr noundef nonnull byval(%struct.Vector) align 8 %26, double noundef %2564)
  %2565 = load i64, ptr %31, align 8
  %2566 = icmp sgt i64 %2565, 0
  br i1 %2566, label %2567, label %2597

2567:                                             ; preds = %2523
  %2568 = fmul double %2296, %2549
  %2569 = fmul double %2304, %2554
  %2570 = fadd double %2568, %2569
  %2571 = fmul double %2312, %2559
  %2572 = fadd double %2571, %2570
  %2573 = fmul double %2298, %2549
  %2574 = fmul double %2306, %2554
  %2575 = fadd double %2573, %2574
  %2576 = fmul double %2314, %2559
  %2577 = fadd double %2576, %2575
  %2578 = fmul double %2301, %2549
  %2579 = fmul double %2309, %2554
  %2580 = fadd double %2578, %2579
  %2581 = fmul double %2317, %2559
  %2582 = fadd double %2581, %2580
  %2583 = fmul double %2266, %2582
  %2584 = fmul double %2267, %2577
  %2585 = fsub double %2583, %2584
  %2586 = fmul double %2267, %2572
  %2587 = fmul double %2265, %2582
  %2588 = fsub double %2586, %2587
  %2589 = fmul double %2265, %2577
  %2590 = fmul double %2266, %2572
  %2591 = fsub double %2589, %2590
  %2592 = fmul double %2265, %2572
  %2593 = fmul double %2266, %2577
  %2594 = fadd double %2592, %2593
  %2595 = fmul double %2267, %2582
  %2596 = fadd double %2595, %2594
  br label %2599

2597:                                             ; preds = %2954, %2523
  %2598 = phi i64 [ %2508, %2523 ], [ %2955, %2954 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %31) #13
  br label %2958

2599:                                             ; preds = %2567, %2954
  %2600 = phi i64 [ %2955, %2954 ], [ %2508, %2567 ]
  %2601 = phi i64 [ %2956, %2954 ], [ 0, %2567 ]
  %2602 = getelementptr inbounds %struct.Turns, ptr %31, i64 0, i32 1, i64 %2601
  %2603 = load double, ptr %2602, align 8
  %2604 = getelementptr inbounds i8, ptr %2602, i64 8
  %2605 = load double, ptr %2604, align 8
  %2606 = tail call double @atan2(double noundef %2605, double noundef %2603) #14
  %2607 = fsub double %2606, %2492
  %2608 = fadd double %2607, 1.000000e-05
  %2609 = fdiv double %2608, 0x401921FB54442D18
  %2610 = tail call double @llvm.floor.f64(double %2609)
  %2611 = fmul double %2610, 0x401921FB54442D18
  %2612 = fsub double %2606, %2611
  %2613 = fcmp ugt double %2612, %2494
  br i1 %2613, label %2954, label %2614

2614:                                             ; preds = %2599
  %2615 = fsub double 1.000000e+00, %2603
  %2616 = fmul double %2388, %2615
  %2617 = fmul double %2259, %2603
  %2618 = fmul double %2391, %2605
  %2619 = fsub double %2617, %2618
  %2620 = fmul double %2262, %2616
  %2621 = fadd double %2620, %2619
  %2622 = fmul double %2260, %2603
  %2623 = fmul double %2394, %2605
  %2624 = fsub double %2622, %2623
  %2625 = fmul double %2263, %2616
  %2626 = fadd double %2625, %2624
  %2627 = fmul double %2261, %2603
  %2628 = fmul double %2397, %2605
  %2629 = fsub double %2627, %2628
  %2630 = fmul double %2264, %2616
  %2631 = fadd double %2629, %2630
  %2632 = fmul double %2585, %2621
  %2633 = fmul double %2588, %2626
  %2634 = fadd double %2632, %2633
  %2635 = fmul double %2591, %2631
  %2636 = fadd double %2635, %2634
  %2637 = fmul double %2572, %2621
  %2638 = fmul double %2577, %2626
  %2639 = fadd double %2637, %2638
  %2640 = fmul double %2582, %2631
  %2641 = fadd double %2640, %2639
  %2642 = fmul double %2265, %2621
  %2643 = fmul double %2266, %2626
  %2644 = fadd double %2642, %2643
  %2645 = fmul double %2267, %2631
  %2646 = fadd double %2645, %2644
  %2647 = fmul double %2596, %2646
  %2648 = fsub double %2641, %2647
  %2649 = fmul double %2636, %2636
  %2650 = fmul double %2648, %2648
  %2651 = fadd double %2649, %2650
  %2652 = tail call double @llvm.sqrt.f64(double %2651)
  %2653 = fcmp olt double %2652, 0x3D06849B86A12B9B
  %2654 = fdiv double %2648, %2652
  %2655 = fdiv double %2636, %2652
  %2656 = select i1 %2653, double 1.000000e+00, double %2654
  %2657 = select i1 %2653, double 0.000000e+00, double %2655
  %2658 = tail call double @atan2(double noundef %2657, double noundef %2656) #14
  %2659 = fmul double %2646, %2646
  %2660 = fcmp ogt double %2659, 0x3FEFFFFFFFFFFFA6
  %2661 = select i1 %2660, i64 32, i64 1
  %2662 = sitofp i64 %2661 to double
  %2663 = fmul double %2402, %2615
  %2664 = fmul double %2339, %2603
  %2665 = fmul double %2405, %2605
  %2666 = fsub double %2664, %2665
  %2667 = fmul double %2262, %2663
  %2668 = fadd double %2667, %2666
  %2669 = fmul double %2340, %2603
  %2670 = fmul double %2408, %2605
  %2671 = fsub double %2669, %2670
  %2672 = fmul double %2263, %2663
  %2673 = fadd double %2672, %2671
  %2674 = fmul double %2341, %2603
  %2675 = fmul double %2411, %2605
  %2676 = fsub double %2674, %2675
  %2677 = fmul double %2264, %2663
  %2678 = fadd double %2676, %2677
  %2679 = fmul double %2265, %2668
  %2680 = fmul double %2266, %2673
  %2681 = fadd double %2679, %2680
  %2682 = fmul double %2267, %2678
  %2683 = fadd double %2682, %2681
  %2684 = fmul double %2266, %2678
  %2685 = fmul double %2267, %2673
  %2686 = fsub double %2684, %2685
  %2687 = fmul double %2267, %2668
  %2688 = fmul double %2265, %2678
  %2689 = fsub double %2687, %2688
  %2690 = fmul double %2265, %2673
  %2691 = fmul double %2266, %2668
  %2692 = fsub double %2690, %2691
  br label %2693

2693:                                             ; preds = %2948, %2614
  %2694 = phi i64 [ 0, %2614 ], [ %2950, %2948 ]
  %2695 = shl nuw nsw i64 %2694, 1
  %2696 = sitofp i64 %2695 to double
  %2697 = fmul double %2696, 0x400921FB54442D18
  %2698 = fdiv double %2697, %2662
  %2699 = fadd double %2658, %2698
  %2700 = fsub double %2699, %2495
  %2701 = fadd double %2700, 1.000000e-05
  %2702 = fdiv double %2701, 0x401921FB54442D18
  %2703 = tail call double @llvm.floor.f64(double %2702)
  %2704 = fmul double %2703, 0x401921FB54442D18
  %2705 = fsub double %2699, %2704
  %2706 = fcmp ugt double %2705, %2497
  br i1 %2706, label %2948, label %2707

2707:                                             ; preds = %2693
  %2708 = tail call double @llvm.cos.f64(double %2699)
  %2709 = tail call double @llvm.sin.f64(double %2699)
  %2710 = fsub double 1.000000e+00, %2708
  %2711 = fmul double %2683, %2710
  %2712 = fmul double %2668, %2708
  %2713 = fmul double %2686, %2709
  %2714 = fsub double %2712, %2713
  %2715 = fmul double %2265, %2711
  %2716 = fadd double %2714, %2715
  %2717 = fmul double %2673, %2708
  %2718 = fmul double %2689, %2709
  %2719 = fsub double %2717, %2718
  %2720 = fmul double %2266, %2711
  %2721 = fadd double %2719, %2720
  %2722 = fmul double %2678, %2708
  %2723 = fmul double %2692, %2709
  %2724 = fsub double %2722, %2723
  %2725 = fmul double %2267, %2711
  %2726 = fadd double %2724, %2725
  %2727 = fmul double %2296, %2716
  %2728 = fmul double %2298, %2721
  %2729 = fadd double %2727, %2728
  %2730 = fmul double %2301, %2726
  %2731 = fadd double %2730, %2729
  %2732 = fmul double %2304, %2716
  %2733 = fmul double %2306, %2721
  %2734 = fadd double %2732, %2733
  %2735 = fmul double %2309, %2726
  %2736 = fadd double %2735, %2734
  %2737 = fmul double %2312, %2716
  %2738 = fmul double %2314, %2721
  %2739 = fadd double %2737, %2738
  %2740 = fmul double %2317, %2726
  %2741 = fadd double %2740, %2739
  %2742 = fmul double %2256, %2731
  %2743 = fmul double %2257, %2736
  %2744 = fadd double %2742, %2743
  %2745 = fmul double %2258, %2741
  %2746 = fadd double %2745, %2744
  %2747 = fmul double %2524, %2746
  %2748 = fmul double %2257, %2741
  %2749 = fmul double %2258, %2736
  %2750 = fsub double %2748, %2749
  %2751 = fmul double %2258, %2731
  %2752 = fmul double %2256, %2741
  %2753 = fsub double %2751, %2752
  %2754 = fmul double %2256, %2736
  %2755 = fmul double %2257, %2731
  %2756 = fsub double %2754, %2755
  %2757 = fmul double %2511, %2731
  %2758 = fmul double %2513, %2750
  %2759 = fadd double %2757, %2758
  %2760 = fmul double %2256, %2747
  %2761 = fadd double %2759, %2760
  %2762 = fmul double %2511, %2736
  %2763 = fmul double %2513, %2753
  %2764 = fadd double %2762, %2763
  %2765 = fmul double %2257, %2747
  %2766 = fadd double %2764, %2765
  %2767 = fmul double %2511, %2741
  %2768 = fmul double %2513, %2756
  %2769 = fadd double %2767, %2768
  %2770 = fmul double %2258, %2747
  %2771 = fadd double %2769, %2770
  %2772 = fmul double %2414, %2761
  %2773 = fmul double %2417, %2766
  %2774 = fadd double %2772, %2773
  %2775 = fmul double %2420, %2771
  %2776 = fadd double %2775, %2774
  %2777 = fmul double %2339, %2761
  %2778 = fmul double %2340, %2766
  %2779 = fadd double %2777, %2778
  %2780 = fmul double %2341, %2771
  %2781 = fadd double %2780, %2779
  %2782 = fmul double %2259, %2761
  %2783 = fmul double %2260, %2766
  %2784 = fadd double %2782, %2783
  %2785 = fmul double %2261, %2771
  %2786 = fadd double %2785, %2784
  %2787 = fmul double %2425, %2786
  %2788 = fsub double %2781, %2787
  %2789 = fmul double %2776, %2776
  %2790 = fmul double %2788, %2788
  %2791 = fadd double %2789, %2790
  %2792 = tail call double @llvm.sqrt.f64(double %2791)
  %2793 = fcmp olt double %2792, 0x3D06849B86A12B9B
  %2794 = fdiv double %2788, %2792
  %2795 = fdiv double %2776, %2792
  %2796 = select i1 %2793, double 1.000000e+00, double %2794
  %2797 = select i1 %2793, double 0.000000e+00, double %2795
  %2798 = fsub double 1.000000e+00, %2796
  %2799 = fmul double %2433, %2798
  %2800 = fmul double %2426, %2796
  %2801 = fmul double %2436, %2797
  %2802 = fadd double %2800, %2801
  %2803 = fmul double %2259, %2799
  %2804 = fadd double %2802, %2803
  %2805 = fmul double %2427, %2796
  %2806 = fmul double %2439, %2797
  %2807 = fadd double %2805, %2806
  %2808 = fmul double %2260, %2799
  %2809 = fadd double %2807, %2808
  %2810 = fmul double %2428, %2796
  %2811 = fmul double %2442, %2797
  %2812 = fadd double %2810, %2811
  %2813 = fmul double %2261, %2799
  %2814 = fadd double %2812, %2813
  %2815 = fsub double %2541, %2804
  %2816 = fsub double %2542, %2809
  %2817 = fsub double %2543, %2814
  %2818 = fsub double %2815, %2271
  %2819 = fsub double %2816, %2272
  %2820 = fsub double %2817, %2273
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %32) #13
  %2821 = fmul double %2818, %2818
  %2822 = fmul double %2819, %2819
  %2823 = fadd double %2821, %2822
  %2824 = fmul double %2820, %2820
  %2825 = fadd double %2824, %2823
  %2826 = tail call double @llvm.sqrt.f64(double %2825)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %24)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %23)
  store double %2443, ptr %24, align 8
  store double %2444, ptr %242, align 8
  store double %2445, ptr %243, align 8
  store double %2446, ptr %23, align 8
  store double %2447, ptr %240, align 8
  store double %2448, ptr %241, align 8
  %2827 = fmul double %2826, %2826
  %2828 = fsub double %2459, %2827
  %2829 = fmul double %2828, 5.000000e-01
  call fastcc void @turns_to_height(ptr nonnull sret(%struct.Turns) align 8 %32, ptr noundef nonnull byval(%struct.Vector) align 8 %26, ptr noundef nonnull byval(%struct.Vector) align 8 %24, ptr noundef nonnull byval(%struct.Vector) align 8 %23, double noundef %2829)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %24)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %23)
  %2830 = load i64, ptr %32, align 8
  %2831 = icmp sgt i64 %2830, 0
  br i1 %2831, label %2832, label %2839

2832:                                             ; preds = %2707
  %2833 = fmul double %2259, %2818
  %2834 = fmul double %2260, %2819
  %2835 = fadd double %2833, %2834
  %2836 = fmul double %2261, %2820
  %2837 = fadd double %2836, %2835
  %2838 = tail call double @atan2(double noundef %2797, double noundef %2796) #14
  br label %2841

2839:                                             ; preds = %2944, %2707
  %2840 = phi i64 [ %2600, %2707 ], [ %2945, %2944 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %32) #13
  br label %2948

2841:                                             ; preds = %2944, %2832
  %2842 = phi i64 [ %2600, %2832 ], [ %2945, %2944 ]
  %2843 = phi i64 [ 0, %2832 ], [ %2946, %2944 ]
  %2844 = getelementptr inbounds %struct.Turns, ptr %32, i64 0, i32 1, i64 %2843
  %2845 = load double, ptr %2844, align 8
  %2846 = getelementptr inbounds i8, ptr %2844, i64 8
  %2847 = load double, ptr %2846, align 8
  %2848 = fsub double 1.000000e+00, %2845
  %2849 = fmul double %2464, %2848
  %2850 = fmul double %2443, %2845
  %2851 = fmul double %2467, %2847
  %2852 = fadd double %2850, %2851
  %2853 = fmul double %2259, %2849
  %2854 = fadd double %2853, %2852
  %2855 = fmul double %2444, %2845
  %2856 = fmul double %2470, %2847
  %2857 = fadd double %2855, %2856
  %2858 = fmul double %2260, %2849
  %2859 = fadd double %2858, %2857
  %2860 = fmul double %2445, %2845
  %2861 = fmul double %2473, %2847
  %2862 = fadd double %2860, %2861
  %2863 = fmul double %2261, %2849
  %2864 = fadd double %2862, %2863
  %2865 = fadd double %2274, %2854
  %2866 = fadd double %2275, %2859
  %2867 = fadd double %2276, %2864
  %2868 = fsub double %2865, %2271
  %2869 = fsub double %2866, %2272
  %2870 = fsub double %2867, %2273
  %2871 = fmul double %2260, %2870
  %2872 = fmul double %2261, %2869
  %2873 = fsub double %2871, %2872
  %2874 = fmul double %2261, %2868
  %2875 = fmul double %2259, %2870
  %2876 = fsub double %2874, %2875
  %2877 = fmul double %2259, %2869
  %2878 = fmul double %2260, %2868
  %2879 = fsub double %2877, %2878
  %2880 = fmul double %2818, %2873
  %2881 = fmul double %2819, %2876
  %2882 = fadd double %2880, %2881
  %2883 = fmul double %2820, %2879
  %2884 = fadd double %2883, %2882
  %2885 = fmul double %2818, %2868
  %2886 = fmul double %2819, %2869
  %2887 = fadd double %2885, %2886
  %2888 = fmul double %2820, %2870
  %2889 = fadd double %2888, %2887
  %2890 = fmul double %2259, %2868
  %2891 = fmul double %2260, %2869
  %2892 = fadd double %2890, %2891
  %2893 = fmul double %2261, %2870
  %2894 = fadd double %2893, %2892
  %2895 = fmul double %2837, %2894
  %2896 = fsub double %2889, %2895
  %2897 = fmul double %2884, %2884
  %2898 = fmul double %2896, %2896
  %2899 = fadd double %2897, %2898
  %2900 = tail call double @llvm.sqrt.f64(double %2899)
  %2901 = fcmp olt double %2900, 0x3D06849B86A12B9B
  %2902 = fdiv double %2896, %2900
  %2903 = fdiv double %2884, %2900
  %2904 = select i1 %2901, double 1.000000e+00, double %2902
  %2905 = select i1 %2901, double 0.000000e+00, double %2903
  %2906 = tail call double @atan2(double noundef %2905, double noundef %2904) #14
  %2907 = tail call double @atan2(double noundef %2847, double noundef %2845) #14
  %2908 = fmul double %2287, %2907
  %2909 = fsub double %2838, %2906
  %2910 = fsub double %2909, %2907
  %2911 = fmul double %2295, %2910
  %2912 = fsub double %2906, %2498
  %2913 = fadd double %2912, 1.000000e-05
  %2914 = fdiv double %2913, 0x401921FB54442D18
  %2915 = tail call double @llvm.floor.f64(double %2914)
  %2916 = fmul double %2915, 0x401921FB54442D18
  %2917 = fsub double %2906, %2916
  %2918 = fcmp ugt double %2917, %2500
  br i1 %2918, label %2944, label %2919

2919:                                             ; preds = %2841
  %2920 = fsub double %2908, %2501
  %2921 = fadd double %2920, 1.000000e-05
  %2922 = fdiv double %2921, 0x401921FB54442D18
  %2923 = tail call double @llvm.floor.f64(double %2922)
  %2924 = fmul double %2923, 0x401921FB54442D18
  %2925 = fsub double %2908, %2924
  %2926 = fcmp ugt double %2925, %2503
  br i1 %2926, label %2944, label %2927

2927:                                             ; preds = %2919
  %2928 = fsub double %2911, %2504
  %2929 = fadd double %2928, 1.000000e-05
  %2930 = fdiv double %2929, 0x401921FB54442D18
  %2931 = tail call double @llvm.floor.f64(double %2930)
  %2932 = fmul double %2931, 0x401921FB54442D18
  %2933 = fsub double %2911, %2932
  %2934 = fcmp ugt double %2933, %2506
  br i1 %2934, label %2944, label %2935

2935:                                             ; preds = %2927
  %2936 = add nsw i64 %2842, 1
  %2937 = mul nsw i64 %2842, 6
  %2938 = getelementptr inbounds double, ptr %79, i64 %2937
  store double %2515, ptr %2938, align 16
  %2939 = getelementptr inbounds double, ptr %2938, i64 1
  store double %2906, ptr %2939, align 8
  %2940 = getelementptr inbounds double, ptr %2938, i64 2
  store double %2908, ptr %2940, align 16
  %2941 = getelementptr inbounds double, ptr %2938, i64 3
  store double %2911, ptr %2941, align 8
  %2942 = getelementptr inbounds double, ptr %2938, i64 4
  store double %2606, ptr %2942, align 16
  %2943 = getelementptr inbounds double, ptr %2938, i64 5
  store double %2699, ptr %2943, align 8
  br label %2944

2944:                                             ; preds = %2935, %2927, %2919, %2841
  %2945 = phi i64 [ %2936, %2935 ], [ %2842, %2927 ], [ %2842, %2919 ], [ %2842, %2841 ]
  %2946 = add nuw nsw i64 %2843, 1
  %2947 = icmp eq i64 %2946, %2830
  br i1 %2947, label %2839, label %2841

2948:                                             ; preds = %2839, %2693
  %2949 = phi i64 [ %2840, %2839 ], [ %2600, %2693 ]
  %2950 = add nuw nsw i64 %2694, 1
  %2951 = icmp ult i64 %2950, %2661
  %2952 = icmp eq i64 %2949, %2600
  %2953 = select i1 %2951, i1 %2952, i1 false
  br i1 %2953, label %2693, label %2954

2954:                                             ; preds = %2948, %2599
  %2955 = phi i64 [ %2600, %2599 ], [ %2949, %2948 ]
  %2956 = add nuw nsw i64 %2601, 1
  %2957 = icmp eq i64 %2956, %2565
  br i1 %2957, label %2597, label %2599

2958:                                             ; preds = %2597, %2507
  %2959 = phi i64 [ %2598, %2597 ], [ %2508, %2507 ]
  %2960 = add nuw nsw i64 %2509, 1
  %2961 = icmp eq i64 %2960, %2353
  br i1 %2961, label %2962, label %2507

2962:                                             ; preds = %2958, %2255
  %2963 = phi i64 [ 0, %2255 ], [ %2959, %2958 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %29) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %28) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %27) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %26) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %25) #13
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %30)
  br label %3458

2964:                                             ; preds = %1004
  %2965 = getelementptr inbounds double, ptr %375, i64 %546
  %2966 = load double, ptr %2965, align 8
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %17)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %18)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %19)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %20)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %21)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %22)
  %2967 = load double, ptr %80, align 16
  %2968 = fmul double %959, %2967
  %2969 = load double, ptr %183, align 8
  %2970 = fmul double %960, %2969
  %2971 = fadd double %2968, %2970
  %2972 = load double, ptr %184, align 16
  %2973 = fmul double %961, %2972
  %2974 = fadd double %2971, %2973
  %2975 = load double, ptr %185, align 16
  %2976 = fmul double %959, %2975
  %2977 = load double, ptr %186, align 8
  %2978 = fmul double %960, %2977
  %2979 = fadd double %2976, %2978
  %2980 = load double, ptr %187, align 16
  %2981 = fmul double %961, %2980
  %2982 = fadd double %2979, %2981
  %2983 = load double, ptr %188, align 16
  %2984 = fmul double %959, %2983
  %2985 = load double, ptr %189, align 8
  %2986 = fmul double %960, %2985
  %2987 = fadd double %2984, %2986
  %2988 = load double, ptr %190, align 16
  %2989 = fmul double %961, %2988
  %2990 = fadd double %2987, %2989
  %2991 = load double, ptr %180, align 8
  %2992 = load double, ptr %181, align 8
  %2993 = load double, ptr %182, align 8
  %2994 = fadd double %2974, %2991
  %2995 = fadd double %2982, %2992
  %2996 = fadd double %2990, %2993
  %2997 = fsub double %2994, %423
  %2998 = fsub double %2995, %424
  %2999 = fsub double %2996, %425
  %3000 = fmul double %2997, %2997
  %3001 = fmul double %2998, %2998
  %3002 = fadd double %3000, %3001
  %3003 = fmul double %2999, %2999
  %3004 = fadd double %3002, %3003
  %3005 = tail call double @llvm.sqrt.f64(double %3004)
  %3006 = fcmp olt double %3005, 1.000000e-09
  br i1 %3006, label %3456, label %3007

3007:                                             ; preds = %2964
  %3008 = fdiv double %2997, %3005
  %3009 = fdiv double %2998, %3005
  %3010 = fdiv double %2999, %3005
  %3011 = load double, ptr %231, align 8
  %3012 = load double, ptr %232, align 8
  %3013 = load double, ptr %233, align 8
  %3014 = load double, ptr %225, align 8
  %3015 = load double, ptr %226, align 8
  %3016 = load double, ptr %227, align 8
  %3017 = tail call double @llvm.cos.f64(double %2966)
  %3018 = tail call double @llvm.sin.f64(double %2966)
  %3019 = load double, ptr %78, align 8
  %3020 = load double, ptr %199, align 8
  %3021 = load double, ptr %201, align 8
  %3022 = fmul double %3008, %3019
  %3023 = fmul double %3009, %3020
  %3024 = fadd double %3022, %3023
  %3025 = fmul double %3010, %3021
  %3026 = fadd double %3024, %3025
  %3027 = fmul double %3008, %3026
  %3028 = fmul double %3009, %3026
  %3029 = fmul double %3010, %3026
  %3030 = fsub double %3019, %3027
  %3031 = fsub double %3020, %3028
  %3032 = fsub double %3021, %3029
  %3033 = fmul double %3030, %3030
  %3034 = fmul double %3031, %3031
  %3035 = fadd double %3033, %3034
  %3036 = fmul double %3032, %3032
  %3037 = fadd double %3036, %3035
  %3038 = tail call double @llvm.sqrt.f64(double %3037)
  %3039 = fcmp olt double %3038, 1.000000e-09
  br i1 %3039, label %3040, label %3057

3040:                                             ; preds = %3007
  %3041 = tail call double @llvm.fabs.f64(double %3008)
  %3042 = fcmp olt double %3041, 6.000000e-01
  %3043 = fneg double %3010
  %3044 = fneg double %3008
  %3045 = select i1 %3042, double %3009, double %3044
  %3046 = select i1 %3042, double %3043, double 0.000000e+00
  %3047 = select i1 %3042, double 0.000000e+00, double %3010
  %3048 = fmul double %3047, %3047
  %3049 = fmul double %3046, %3046
  %3050 = fadd double %3049, %3048
  %3051 = fmul double %3045, %3045
  %3052 = fadd double %3051, %3050
  %3053 = tail call double @llvm.sqrt.f64(double %3052)
  %3054 = fdiv double %3047, %3053
  %3055 = fdiv double %3046, %3053
  %3056 = fdiv double %3045, %3053
  br label %3061

3057:                                             ; preds = %3007
  %3058 = fdiv double %3030, %3038
  %3059 = fdiv double %3031, %3038
  %3060 = fdiv double %3032, %3038
  br label %3061

3061:                                             ; preds = %3057, %3040
  %3062 = phi double [ %3054, %3040 ], [ %3058, %3057 ]
  %3063 = phi double [ %3055, %3040 ], [ %3059, %3057 ]
  %3064 = phi double [ %3056, %3040 ], [ %3060, %3057 ]
  %3065 = fmul double %3008, %3062
  %3066 = fmul double %3009, %3063
  %3067 = fadd double %3065, %3066
  %3068 = fmul double %3010, %3064
  %3069 = fadd double %3067, %3068
  %3070 = fsub double 1.000000e+00, %3017
  %3071 = fmul double %3070, %3069
  %3072 = fmul double %3009, %3064
  %3073 = fmul double %3010, %3063
  %3074 = fsub double %3072, %3073
  %3075 = fmul double %3010, %3062
  %3076 = fmul double %3008, %3064
  %3077 = fsub double %3075, %3076
  %3078 = fmul double %3008, %3063
  %3079 = fmul double %3009, %3062
  %3080 = fsub double %3078, %3079
  %3081 = fmul double %3017, %3062
  %3082 = fmul double %3018, %3074
  %3083 = fadd double %3081, %3082
  %3084 = fmul double %3008, %3071
  %3085 = fadd double %3084, %3083
  %3086 = fmul double %3017, %3063
  %3087 = fmul double %3018, %3077
  %3088 = fadd double %3086, %3087
  %3089 = fmul double %3009, %3071
  %3090 = fadd double %3089, %3088
  %3091 = fmul double %3017, %3064
  %3092 = fmul double %3018, %3080
  %3093 = fadd double %3091, %3092
  %3094 = fmul double %3010, %3071
  %3095 = fadd double %3093, %3094
  %3096 = fmul double %3009, %3095
  %3097 = fmul double %3010, %3090
  %3098 = fsub double %3096, %3097
  %3099 = fmul double %3010, %3085
  %3100 = fmul double %3008, %3095
  %3101 = fsub double %3099, %3100
  %3102 = fmul double %3008, %3090
  %3103 = fmul double %3009, %3085
  %3104 = fsub double %3102, %3103
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %10) #13
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %11) #13
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %12) #13
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %9)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %8)
  call void @llvm.lifetime.start.p0(i64 24, ptr nonnull %7)
  store double %3011, ptr %9, align 8
  store double %3012, ptr %300, align 8
  store double %3013, ptr %301, align 8
  %3105 = fsub double %959, %3014
  %3106 = fsub double %960, %3015
  %3107 = fsub double %961, %3016
  store double %3105, ptr %8, align 8
  store double %3106, ptr %298, align 8
  store double %3107, ptr %299, align 8
  %3108 = fsub double %423, %3014
  %3109 = fsub double %424, %3015
  %3110 = fsub double %425, %3016
  store double %3108, ptr %7, align 8
  store double %3109, ptr %296, align 8
  store double %3110, ptr %297, align 8
  %3111 = fmul double %3105, %3105
  %3112 = fmul double %3106, %3106
  %3113 = fadd double %3111, %3112
  %3114 = fmul double %3107, %3107
  %3115 = fadd double %3113, %3114
  %3116 = fmul double %3108, %3108
  %3117 = fmul double %3109, %3109
  %3118 = fadd double %3116, %3117
  %3119 = fmul double %3110, %3110
  %3120 = fadd double %3118, %3119
  %3121 = fadd double %3115, %3120
  %3122 = fmul double %3005, %3005
  %3123 = fsub double %3121, %3122
  %3124 = fmul double %3123, 5.000000e-01
  call fastcc void @turns_to_height(ptr nonnull sret(%struct.Turns) align 8 %12, ptr noundef nonnull byval(%struct.Vector) align 8 %9, ptr noundef nonnull byval(%struct.Vector) align 8 %8, ptr noundef nonnull byval(%struct.Vector) align 8 %7, double noundef %3124)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %9)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %8)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %7)
  %3125 = load i64, ptr %12, align 8
  %3126 = icmp sgt i64 %3125, 0
  br i1 %3126, label %3127, label %3160

3127:                                             ; preds = %3061
  %3128 = fmul double %3011, %3105
  %3129 = fmul double %3012, %3106
  %3130 = fadd double %3128, %3129
  %3131 = fmul double %3013, %3107
  %3132 = fadd double %3130, %3131
  %3133 = fmul double %3012, %3107
  %3134 = fmul double %3013, %3106
  %3135 = fsub double %3133, %3134
  %3136 = fmul double %3013, %3105
  %3137 = fmul double %3011, %3107
  %3138 = fsub double %3136, %3137
  %3139 = fmul double %3011, %3106
  %3140 = fmul double %3012, %3105
  %3141 = fsub double %3139, %3140
  %3142 = load double, ptr %248, align 8
  %3143 = load double, ptr %249, align 8
  %3144 = fadd double %3143, 1.000000e-05
  %3145 = load double, ptr %207, align 8
  %3146 = load double, ptr %209, align 8
  %3147 = load double, ptr %211, align 8
  %3148 = load double, ptr %212, align 8
  %3149 = load double, ptr %214, align 8
  %3150 = load double, ptr %216, align 8
  %3151 = load double, ptr %330, align 8
  %3152 = load double, ptr %332, align 8
  %3153 = load double, ptr %334, align 8
  %3154 = load double, ptr %202, align 8
  %3155 = load double, ptr %204, align 8
  %3156 = load double, ptr %206, align 8
  %3157 = load double, ptr %228, align 8
  %3158 = load double, ptr %229, align 8
  %3159 = load double, ptr %230, align 8
  br label %3162

3160:                                             ; preds = %3452, %3061
  %3161 = phi i64 [ 0, %3061 ], [ %3453, %3452 ]
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %12) #13
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %11) #13
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %10) #13
  br label %3456

3162:                                             ; preds = %3452, %3127
  %3163 = phi i64 [ 0, %3127 ], [ %3453, %3452 ]
  %3164 = phi i64 [ 0, %3127 ], [ %3454, %3452 ]
  %3165 = getelementptr inbounds %struct.Turns, ptr %12, i64 0, i32 1, i64 %3164
  %3166 = load double, ptr %3165, align 8
  %3167 = getelementptr inbounds i8, ptr %3165, i64 8
  %3168 = load double, ptr %3167, align 8
  %3169 = tail call double @atan2(double noundef %3168, double noundef %3166) #14
  %3170 = fsub double %3169, %3142
  %3171 = fadd double %3170, 1.000000e-05
  %3172 = fdiv double %3171, 0x401921FB54442D18
  %3173 = tail call double @llvm.floor.f64(double %3172)
  %3174 = fmul double %3173, 0x401921FB54442D18
  %3175 = fsub double %3169, %3174
  %3176 = fcmp ugt double %3175, %3144
  br i1 %3176, label %3452, label %3177

3177:                                             ; preds = %3162
  %3178 = fsub double 1.000000e+00, %3166
  %3179 = fmul double %3132, %3178
  %3180 = fmul double %3105, %3166
  %3181 = fmul double %3135, %3168
  %3182 = fadd double %3180, %3181
  %3183 = fmul double %3011, %3179
  %3184 = fadd double %3183, %3182
  %3185 = fmul double %3106, %3166
  %3186 = fmul double %3138, %3168
  %3187 = fadd double %3185, %3186
  %3188 = fmul double %3012, %3179
  %3189 = fadd double %3188, %3187
  %3190 = fmul double %3107, %3166
  %3191 = fmul double %3141, %3168
  %3192 = fadd double %3190, %3191
  %3193 = fmul double %3013, %3179
  %3194 = fadd double %3192, %3193
  %3195 = fadd double %3014, %3184
  %3196 = fadd double %3015, %3189
  %3197 = fadd double %3016, %3194
  %3198 = fsub double %3195, %423
  %3199 = fsub double %3196, %424
  %3200 = fsub double %3197, %425
  %3201 = fmul double %3198, %3198
  %3202 = fmul double %3199, %3199
  %3203 = fadd double %3201, %3202
  %3204 = fmul double %3200, %3200
  %3205 = fadd double %3204, %3203
  %3206 = tail call double @llvm.sqrt.f64(double %3205)
  %3207 = fdiv double %3198, %3206
  %3208 = fdiv double %3199, %3206
  %3209 = fdiv double %3200, %3206
  %3210 = fmul double %3011, %3207
  %3211 = fmul double %3012, %3208
  %3212 = fadd double %3210, %3211
  %3213 = fmul double %3013, %3209
  %3214 = fadd double %3213, %3212
  %3215 = fmul double %3207, %3214
  %3216 = fmul double %3208, %3214
  %3217 = fmul double %3209, %3214
  %3218 = fsub double %3011, %3215
  %3219 = fsub double %3012, %3216
  %3220 = fsub double %3013, %3217
  %3221 = fmul double %3218, %3218
  %3222 = fmul double %3219, %3219
  %3223 = fadd double %3221, %3222
  %3224 = fmul double %3220, %3220
  %3225 = fadd double %3224, %3223
  %3226 = tail call double @llvm.sqrt.f64(double %3225)
  %3227 = fcmp olt double %3226, 1.000000e-09
  br i1 %3227, label %3228, label %3245

3228:                                             ; preds = %3177
  %3229 = tail call double @llvm.fabs.f64(double %3207)
  %3230 = fcmp olt double %3229, 6.000000e-01
  %3231 = fneg double %3209
  %3232 = fneg double %3207
  %3233 = select i1 %3230, double %3208, double %3232
  %3234 = select i1 %3230, double %3231, double 0.000000e+00
  %3235 = select i1 %3230, double 0.000000e+00, double %3209
  %3236 = fmul double %3235, %3235
  %3237 = fmul double %3234, %3234
  %3238 = fadd double %3237, %3236
  %3239 = fmul double %3233, %3233
  %3240 = fadd double %3239, %3238
  %3241 = tail call double @llvm.sqrt.f64(double %3240)
  %3242 = fdiv double %3235, %3241
  %3243 = fdiv double %3234, %3241
  %3244 = fdiv double %3233, %3241
  br label %3249

3245:                                             ; preds = %3177
  %3246 = fdiv double %3218, %3226
  %3247 = fdiv double %3219, %3226
  %3248 = fdiv double %3220, %3226
  br label %3249

3249:                                             ; preds = %3245, %3228
  %3250 = phi double [ %3242, %3228 ], [ %3246, %3245 ]
  %3251 = phi double [ %3243, %3228 ], [ %3247, %3245 ]
  %3252 = phi double [ %3244, %3228 ], [ %3248, %3245 ]
  %3253 = fmul double %3208, %3252
  %3254 = fmul double %3209, %3251
  %3255 = fsub double %3253, %3254
  %3256 = fmul double %3209, %3250
  %3257 = fmul double %3207, %3252
  %3258 = fsub double %3256, %3257
  %3259 = fmul double %3207, %3251
  %3260 = fmul double %3208, %3250
  %3261 = fsub double %3259, %3260
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %13) #13
  store double %3207, ptr %13, align 16
  store double %3208, ptr %302, align 8
  store double %3209, ptr %303, align 16
  store double %3250, ptr %304, align 8
  store double %3251, ptr %305, align 16
  store double %3252, ptr %306, align 8
  store double %3255, ptr %307, align 16
  store double %3258, ptr %308, align 8
  store double %3261, ptr %309, align 16
  call void @llvm.lifetime.start.p0(i64 72, ptr nonnull %14) #13
  store double %3008, ptr %14, align 16
  store double %3009, ptr %310, align 8
  store double %3010, ptr %311, align 16
  store double %3085, ptr %312, align 8
  store double %3090, ptr %313, align 16
  store double %3095, ptr %314, align 8
  store double %3098, ptr %315, align 16
  store double %3101, ptr %316, align 8
  store double %3104, ptr %317, align 16
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %15) #13
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(96) %15, i8 0, i64 96, i1 false)
  call void @llvm.lifetime.start.p0(i64 96, ptr nonnull %16) #13
  br label %3272

3262:                                             ; preds = %3280
  %3263 = load double, ptr %15, align 16
  %3264 = load double, ptr %318, align 16
  %3265 = load double, ptr %319, align 16
  %3266 = load double, ptr %320, align 8
  %3267 = load double, ptr %321, align 8
  %3268 = load double, ptr %322, align 8
  %3269 = load double, ptr %323, align 16
  %3270 = load double, ptr %324, align 16
  %3271 = load double, ptr %325, align 16
  br label %3305

3272:                                             ; preds = %3280, %3249
  %3273 = phi i64 [ 0, %3249 ], [ %3281, %3280 ]
  %3274 = getelementptr inbounds [3 x double], ptr %14, i64 0, i64 %3273
  %3275 = load double, ptr %3274, align 8
  %3276 = getelementptr inbounds [3 x [3 x double]], ptr %14, i64 0, i64 1, i64 %3273
  %3277 = load double, ptr %3276, align 8
  %3278 = getelementptr inbounds [3 x [3 x double]], ptr %14, i64 0, i64 2, i64 %3273
  %3279 = load double, ptr %3278, align 8
  br label %3283

3280:                                             ; preds = %3283
  %3281 = add nuw nsw i64 %3273, 1
  %3282 = icmp eq i64 %3281, 3
  br i1 %3282, label %3262, label %3272

3283:                                             ; preds = %3283, %3272
  %3284 = phi i64 [ 0, %3272 ], [ %3297, %3283 ]
  %3285 = getelementptr inbounds [3 x double], ptr %13, i64 0, i64 %3284
  %3286 = load double, ptr %3285, align 8
  %3287 = fmul double %3275, %3286
  %3288 = getelementptr inbounds [3 x [3 x double]], ptr %13, i64 0, i64 1, i64 %3284
  %3289 = load double, ptr %3288, align 8
  %3290 = fmul double %3277, %3289
  %3291 = fadd double %3287, %3290
  %3292 = getelementptr inbounds [3 x [3 x double]], ptr %13, i64 0, i64 2, i64 %3284
  %3293 = load double, ptr %3292, align 8
  %3294 = fmul double %3279, %3293
  %3295 = fadd double %3291, %3294
  %3296 = getelementptr inbounds [3 x [4 x double]], ptr %15, i64 0, i64 %3273, i64 %3284
  store double %3295, ptr %3296, align 8
  %3297 = add nuw nsw i64 %3284, 1
  %3298 = icmp eq i64 %3297, 3
  br i1 %3298, label %3280, label %3283

3299:                                             ; preds = %3305
  store double %3145, ptr %17, align 8
  store double %3146, ptr %326, align 8
  store double %3147, ptr %327, align 8
  store double %3148, ptr %18, align 8
  store double %3149, ptr %328, align 8
  store double %3150, ptr %329, align 8
  store double %3151, ptr %19, align 8
  store double %3152, ptr %331, align 8
  store double %3153, ptr %333, align 8
  %3300 = call fastcc i64 @orient(ptr noundef nonnull byval(%struct.Vector) align 8 %17, ptr noundef nonnull byval(%struct.Vector) align 8 %18, ptr noundef nonnull byval(%struct.Vector) align 8 %19, ptr noundef nonnull %16, ptr noundef nonnull %11)
  store double %3019, ptr %20, align 8
  store double %3020, ptr %335, align 8
  store double %3021, ptr %336, align 8
  store double %3154, ptr %21, align 8
  store double %3155, ptr %337, align 8
  store double %3156, ptr %338, align 8
  store double %3157, ptr %22, align 8
  store double %3158, ptr %339, align 8
  store double %3159, ptr %340, align 8
  %3301 = call fastcc i64 @orient(ptr noundef nonnull byval(%struct.Vector) align 8 %20, ptr noundef nonnull byval(%struct.Vector) align 8 %21, ptr noundef nonnull byval(%struct.Vector) align 8 %22, ptr noundef nonnull %15, ptr noundef nonnull %10)
  %3302 = icmp sgt i64 %3301, 0
  br i1 %3302, label %3303, label %3363

3303:                                             ; preds = %3299
  %3304 = icmp sgt i64 %3300, 0
  br label %3365

3305:                                             ; preds = %3305, %3262
  %3306 = phi i64 [ 0, %3262 ], [ %3361, %3305 ]
  %3307 = getelementptr inbounds [4 x double], ptr %80, i64 0, i64 %3306
  %3308 = load double, ptr %3307, align 8
  %3309 = getelementptr inbounds [4 x double], ptr %80, i64 1, i64 %3306
  %3310 = load double, ptr %3309, align 8
  %3311 = getelementptr inbounds [4 x double], ptr %80, i64 2, i64 %3306
  %3312 = load double, ptr %3311, align 8
  %3313 = fmul double %3263, %3308
  %3314 = fmul double %3264, %3310
  %3315 = fadd double %3313, %3314
  %3316 = fmul double %3265, %3312
  %3317 = fadd double %3315, %3316
  %3318 = fmul double %3266, %3308
  %3319 = fmul double %3267, %3310
  %3320 = fadd double %3318, %3319
  %3321 = fmul double %3268, %3312
  %3322 = fadd double %3320, %3321
  %3323 = fmul double %3269, %3308
  %3324 = fmul double %3270, %3310
  %3325 = fadd double %3323, %3324
  %3326 = fmul double %3271, %3312
  %3327 = fadd double %3325, %3326
  %3328 = fmul double %3011, %3317
  %3329 = fmul double %3012, %3322
  %3330 = fadd double %3328, %3329
  %3331 = fmul double %3013, %3327
  %3332 = fadd double %3331, %3330
  %3333 = fmul double %3178, %3332
  %3334 = fmul double %3012, %3327
  %3335 = fmul double %3013, %3322
  %3336 = fsub double %3334, %3335
  %3337 = fmul double %3013, %3317
  %3338 = fmul double %3011, %3327
  %3339 = fsub double %3337, %3338
  %3340 = fmul double %3011, %3322
  %3341 = fmul double %3012, %3317
  %3342 = fsub double %3340, %3341
  %3343 = fmul double %3166, %3317
  %3344 = fmul double %3168, %3336
  %3345 = fsub double %3343, %3344
  %3346 = fmul double %3011, %3333
  %3347 = fadd double %3345, %3346
  %3348 = fmul double %3166, %3322
  %3349 = fmul double %3168, %3339
  %3350 = fsub double %3348, %3349
  %3351 = fmul double %3012, %3333
  %3352 = fadd double %3350, %3351
  %3353 = fmul double %3166, %3327
  %3354 = fmul double %3168, %3342
  %3355 = fsub double %3353, %3354
  %3356 = fmul double %3013, %3333
  %3357 = fadd double %3355, %3356
  %3358 = getelementptr inbounds [4 x double], ptr %16, i64 0, i64 %3306
  store double %3347, ptr %3358, align 8
  %3359 = getelementptr inbounds [4 x double], ptr %16, i64 1, i64 %3306
  store double %3352, ptr %3359, align 8
  %3360 = getelementptr inbounds [4 x double], ptr %16, i64 2, i64 %3306
  store double %3357, ptr %3360, align 8
  %3361 = add nuw nsw i64 %3306, 1
  %3362 = icmp eq i64 %3361, 3
  br i1 %3362, label %3299, label %3305

3363:                                             ; preds = %3448, %3299
  %3364 = phi i64 [ %3163, %3299 ], [ %3449, %3448 ]
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %16) #13
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %15) #13
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %14) #13
  call void @llvm.lifetime.end.p0(i64 72, ptr nonnull %13) #13
  br label %3452

3365:                                             ; preds = %3448, %3303
  %3366 = phi i64 [ %3163, %3303 ], [ %3449, %3448 ]
  %3367 = phi i64 [ 0, %3303 ], [ %3450, %3448 ]
  %3368 = mul nsw i64 %3366, 7
  %3369 = getelementptr inbounds double, ptr %79, i64 %3368
  %3370 = getelementptr inbounds [2 x [3 x %struct.Turn]], ptr %10, i64 0, i64 %3367
  br label %3371

3371:                                             ; preds = %3391, %3365
  %3372 = phi i1 [ false, %3365 ], [ %3394, %3391 ]
  %3373 = phi i64 [ 0, %3365 ], [ %3393, %3391 ]
  %3374 = getelementptr inbounds %struct.Turn, ptr %3370, i64 %3373
  %3375 = load double, ptr %3374, align 16
  %3376 = getelementptr inbounds { double, double }, ptr %3374, i64 0, i32 1
  %3377 = load double, ptr %3376, align 8
  %3378 = tail call double @atan2(double noundef %3377, double noundef %3375) #14
  %3379 = getelementptr inbounds double, ptr %88, i64 %3373
  %3380 = load double, ptr %3379, align 8
  %3381 = getelementptr inbounds double, ptr %89, i64 %3373
  %3382 = load double, ptr %3381, align 8
  %3383 = fsub double %3378, %3380
  %3384 = fadd double %3383, 1.000000e-05
  %3385 = fdiv double %3384, 0x401921FB54442D18
  %3386 = tail call double @llvm.floor.f64(double %3385)
  %3387 = fmul double %3386, 0x401921FB54442D18
  %3388 = fsub double %3378, %3387
  %3389 = fadd double %3382, 1.000000e-05
  %3390 = fcmp ugt double %3388, %3389
  br i1 %3390, label %3396, label %3391

3391:                                             ; preds = %3371
  %3392 = getelementptr inbounds double, ptr %3369, i64 %3373
  store double %3378, ptr %3392, align 8
  %3393 = add nuw nsw i64 %3373, 1
  %3394 = icmp ugt i64 %3373, 1
  %3395 = icmp eq i64 %3393, 3
  br i1 %3395, label %3396, label %3371

3396:                                             ; preds = %3391, %3371
  %3397 = phi i1 [ %3372, %3371 ], [ %3394, %3391 ]
  br i1 %3397, label %3398, label %3448

3398:                                             ; preds = %3396
  %3399 = load double, ptr %3369, align 8
  %3400 = getelementptr inbounds double, ptr %3369, i64 1
  %3401 = load double, ptr %3400, align 8
  %3402 = getelementptr inbounds double, ptr %3369, i64 2
  %3403 = load double, ptr %3402, align 8
  br i1 %3304, label %3404, label %3448

3404:                                             ; preds = %3398, %3444
  %3405 = phi i64 [ %3446, %3444 ], [ 0, %3398 ]
  %3406 = phi i64 [ %3445, %3444 ], [ %3366, %3398 ]
  %3407 = mul nsw i64 %3406, 7
  %3408 = getelementptr inbounds double, ptr %79, i64 %3407
  %3409 = getelementptr inbounds [2 x [3 x %struct.Turn]], ptr %11, i64 0, i64 %3405
  %3410 = getelementptr inbounds double, ptr %3408, i64 4
  br label %3411

3411:                                             ; preds = %3432, %3404
  %3412 = phi i1 [ false, %3404 ], [ %3435, %3432 ]
  %3413 = phi i64 [ 0, %3404 ], [ %3434, %3432 ]
  %3414 = getelementptr inbounds %struct.Turn, ptr %3409, i64 %3413
  %3415 = load double, ptr %3414, align 16
  %3416 = getelementptr inbounds { double, double }, ptr %3414, i64 0, i32 1
  %3417 = load double, ptr %3416, align 8
  %3418 = tail call double @atan2(double noundef %3417, double noundef %3415) #14
  %3419 = add nuw nsw i64 %3413, 4
  %3420 = getelementptr inbounds double, ptr %88, i64 %3419
  %3421 = load double, ptr %3420, align 8
  %3422 = getelementptr inbounds double, ptr %89, i64 %3419
  %3423 = load double, ptr %3422, align 8
  %3424 = fsub double %3418, %3421
  %3425 = fadd double %3424, 1.000000e-05
  %3426 = fdiv double %3425, 0x401921FB54442D18
  %3427 = tail call double @llvm.floor.f64(double %3426)
  %3428 = fmul double %3427, 0x401921FB54442D18
  %3429 = fsub double %3418, %3428
  %3430 = fadd double %3423, 1.000000e-05
  %3431 = fcmp ugt double %3429, %3430
  br i1 %3431, label %3437, label %3432

3432:                                             ; preds = %3411
  %3433 = getelementptr inbounds double, ptr %3410, i64 %3413
  store double %3418, ptr %3433, align 8
  %3434 = add nuw nsw i64 %3413, 1
  %3435 = icmp ugt i64 %3413, 1
  %3436 = icmp eq i64 %3434, 3
  br i1 %3436, label %3437, label %3411

3437:                                             ; preds = %3432, %3411
  %3438 = phi i1 [ %3412, %3411 ], [ %3435, %3432 ]
  br i1 %3438, label %3439, label %3444

3439:                                             ; preds = %3437
  store double %3399, ptr %3408, align 8
  %3440 = getelementptr inbounds double, ptr %3408, i64 1
  store double %3401, ptr %3440, align 8
  %3441 = getelementptr inbounds double, ptr %3408, i64 2
  store double %3403, ptr %3441, align 8
  %3442 = getelementptr inbounds double, ptr %3408, i64 3
  store double %3169, ptr %3442, align 8
  %3443 = add nsw i64 %3406, 1
  br label %3444

3444:                                             ; preds = %3439, %3437
  %3445 = phi i64 [ %3443, %3439 ], [ %3406, %3437 ]
  %3446 = add nuw nsw i64 %3405, 1
  %3447 = icmp eq i64 %3446, %3300
  br i1 %3447, label %3448, label %3404

3448:                                             ; preds = %3444, %3398, %3396
  %3449 = phi i64 [ %3366, %3396 ], [ %3366, %3398 ], [ %3445, %3444 ]
  %3450 = add nuw nsw i64 %3367, 1
  %3451 = icmp eq i64 %3450, %3301
  br i1 %3451, label %3363, label %3365

3452:                                             ; preds = %3363, %3162
  %3453 = phi i64 [ %3364, %3363 ], [ %3163, %3162 ]
  %3454 = add nuw nsw i64 %3164, 1
  %3455 = icmp eq i64 %3454, %3125
  br i1 %3455, label %3160, label %3162

3456:                                             ; preds = %2964, %3160
  %3457 = phi i64 [ %3161, %3160 ], [ 0, %2964 ]
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %17)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %18)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %19)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %20)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %21)
  call void @llvm.lifetime.end.p0(i64 24, ptr nonnull %22)
  br label %3458

3458:                                             ; preds = %2962, %3456, %2253
  %3459 = phi i64 [ %2254, %2253 ], [ %2963, %2962 ], [ %3457, %3456 ]
  %3460 = icmp sgt i64 %3459, 0
  br i1 %3460, label %3461, label %3610

3461:                                             ; preds = %3458
  %3462 = load ptr, ptr %5, align 8
  %3463 = load i64, ptr %159, align 8
  br label %3464

3464:                                             ; preds = %3461, %3605
  %3465 = phi i64 [ %3463, %3461 ], [ %3606, %3605 ]
  %3466 = phi i64 [ 0, %3461 ], [ %3607, %3605 ]
  %3467 = load i64, ptr %86, align 8
  %3468 = mul nsw i64 %3467, %3466
  %3469 = getelementptr inbounds double, ptr %79, i64 %3468
  %3470 = load i64, ptr %0, align 8
  %3471 = add nsw i64 %3465, 1
  store i64 %3471, ptr %159, align 8
  %3472 = mul nsw i64 %3470, %3465
  %3473 = getelementptr inbounds double, ptr %3462, i64 %3472
  %3474 = icmp sgt i64 %3467, 0
  br i1 %3474, label %3475, label %3478

3475:                                             ; preds = %3464
  %3476 = load ptr, ptr %172, align 8
  %3477 = load ptr, ptr %196, align 8
  br label %3483

3478:                                             ; preds = %3515, %3464
  %3479 = load i64, ptr %170, align 8
  %3480 = icmp sgt i64 %3479, 0
  br i1 %3480, label %3481, label %3520

3481:                                             ; preds = %3478
  %3482 = load ptr, ptr %171, align 8
  br label %3525

3483:                                             ; preds = %3515, %3475
  %3484 = phi i64 [ 0, %3475 ], [ %3518, %3515 ]
  %3485 = getelementptr inbounds i64, ptr %3477, i64 %3484
  %3486 = load i64, ptr %3485, align 8
  %3487 = getelementptr inbounds i8, ptr %3476, i64 %3486
  %3488 = load i8, ptr %3487, align 1
  %3489 = icmp eq i8 %3488, 0
  br i1 %3489, label %3498, label %3490

3490:                                             ; preds = %3483
  %3491 = getelementptr inbounds double, ptr %3469, i64 %3484
  %3492 = load double, ptr %3491, align 8
  %3493 = fadd double %3492, 0x400921FB54442D18
  %3494 = fdiv double %3493, 0x401921FB54442D18
  %3495 = tail call double @llvm.floor.f64(double %3494)
  %3496 = fmul double %3495, 0x401921FB54442D18
  %3497 = fsub double %3492, %3496
  store double %3497, ptr %3491, align 8
  br label %3515

3498:                                             ; preds = %3483
  %3499 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 3, i64 %3484
  %3500 = load double, ptr %3499, align 8
  %3501 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 2, i64 %3484
  %3502 = load double, ptr %3501, align 8
  %3503 = getelementptr inbounds double, ptr %3469, i64 %3484
  %3504 = load double, ptr %3503, align 8
  %3505 = fsub double %3504, %3502
  %3506 = fadd double %3505, 1.000000e-05
  %3507 = fdiv double %3506, 0x401921FB54442D18
  %3508 = tail call double @llvm.floor.f64(double %3507)
  %3509 = fmul double %3508, 0x401921FB54442D18
  %3510 = fsub double %3504, %3509
  %3511 = fcmp ogt double %3510, %3502
  %3512 = select i1 %3511, double %3510, double %3502
  %3513 = fcmp olt double %3512, %3500
  %3514 = select i1 %3513, double %3512, double %3500
  store double %3514, ptr %3503, align 8
  br label %3515

3515:                                             ; preds = %3498, %3490
  %3516 = phi double [ %3514, %3498 ], [ %3497, %3490 ]
  %3517 = getelementptr inbounds double, ptr %3473, i64 %3486
  store double %3516, ptr %3517, align 8
  %3518 = add nuw nsw i64 %3484, 1
  %3519 = icmp eq i64 %3518, %3467
  br i1 %3519, label %3478, label %3483

3520:                                             ; preds = %3525, %3478
  br i1 %3474, label %3521, label %3536

3521:                                             ; preds = %3520
  %3522 = load ptr, ptr %172, align 8
  %3523 = load ptr, ptr %196, align 8
  %3524 = icmp sgt i64 %3470, 0
  br label %3538

3525:                                             ; preds = %3525, %3481
  %3526 = phi i64 [ 0, %3481 ], [ %3532, %3525 ]
  %3527 = getelementptr inbounds double, ptr %375, i64 %3526
  %3528 = load double, ptr %3527, align 8
  %3529 = getelementptr inbounds i64, ptr %3482, i64 %3526
  %3530 = load i64, ptr %3529, align 8
  %3531 = getelementptr inbounds double, ptr %3473, i64 %3530
  store double %3528, ptr %3531, align 8
  %3532 = add nuw nsw i64 %3526, 1
  %3533 = icmp eq i64 %3532, %3479
  br i1 %3533, label %3520, label %3525

3534:                                             ; preds = %3594
  %3535 = icmp slt i64 %3465, %3596
  br i1 %3535, label %3536, label %3605

3536:                                             ; preds = %3534, %3520
  %3537 = load ptr, ptr %341, align 8
  br label %3599

3538:                                             ; preds = %3594, %3521
  %3539 = phi i64 [ %3471, %3521 ], [ %3595, %3594 ]
  %3540 = phi i64 [ %3471, %3521 ], [ %3596, %3594 ]
  %3541 = phi i64 [ 0, %3521 ], [ %3597, %3594 ]
  %3542 = getelementptr inbounds i64, ptr %3523, i64 %3541
  %3543 = load i64, ptr %3542, align 8
  %3544 = getelementptr inbounds i8, ptr %3522, i64 %3543
  %3545 = load i8, ptr %3544, align 1
  %3546 = icmp eq i8 %3545, 0
  br i1 %3546, label %3547, label %3594

3547:                                             ; preds = %3538
  %3548 = getelementptr inbounds double, ptr %3469, i64 %3541
  %3549 = load double, ptr %3548, align 8
  %3550 = getelementptr inbounds %struct.Chain, ptr %78, i64 0, i32 3, i64 %3541
  %3551 = fadd double %3549, 0x401921FB54442D18
  %3552 = load double, ptr %3550, align 8
  %3553 = fadd double %3552, 1.000000e-05
  %3554 = fcmp ugt double %3551, %3553
  br i1 %3554, label %3594, label %3555

3555:                                             ; preds = %3547
  %3556 = icmp slt i64 %3465, %3540
  br label %3566

3557:                                             ; preds = %3586
  %3558 = load double, ptr %3550, align 8
  br label %3559

3559:                                             ; preds = %3566, %3557
  %3560 = phi i64 [ %3567, %3566 ], [ %3574, %3557 ]
  %3561 = phi double [ %3568, %3566 ], [ %3558, %3557 ]
  %3562 = phi i64 [ %3569, %3566 ], [ %3574, %3557 ]
  %3563 = fadd double %3570, 0x401921FB54442D18
  %3564 = fadd double %3561, 1.000000e-05
  %3565 = fcmp ugt double %3563, %3564
  br i1 %3565, label %3594, label %3566

3566:                                             ; preds = %3559, %3555
  %3567 = phi i64 [ %3539, %3555 ], [ %3560, %3559 ]
  %3568 = phi double [ %3552, %3555 ], [ %3561, %3559 ]
  %3569 = phi i64 [ %3540, %3555 ], [ %3562, %3559 ]
  %3570 = phi double [ %3551, %3555 ], [ %3563, %3559 ]
  br i1 %3556, label %3571, label %3559

3571:                                             ; preds = %3566, %3586
  %3572 = phi i64 [ %3574, %3586 ], [ %3569, %3566 ]
  %3573 = phi i64 [ %3592, %3586 ], [ %3465, %3566 ]
  %3574 = add nsw i64 %3572, 1
  store i64 %3574, ptr %159, align 8
  %3575 = mul nsw i64 %3572, %3470
  %3576 = getelementptr inbounds double, ptr %3462, i64 %3575
  %3577 = mul nsw i64 %3573, %3470
  %3578 = getelementptr inbounds double, ptr %3462, i64 %3577
  br i1 %3524, label %3579, label %3586

3579:                                             ; preds = %3571, %3579
  %3580 = phi i64 [ %3584, %3579 ], [ 0, %3571 ]
  %3581 = getelementptr inbounds double, ptr %3578, i64 %3580
  %3582 = load double, ptr %3581, align 8
  %3583 = getelementptr inbounds double, ptr %3576, i64 %3580
  store double %3582, ptr %3583, align 8
  %3584 = add nuw nsw i64 %3580, 1
  %3585 = icmp eq i64 %3584, %3470
  br i1 %3585, label %3586, label %3579

3586:                                             ; preds = %3579, %3571
  %3587 = load double, ptr %3550, align 8
  %3588 = fcmp olt double %3570, %3587
  %3589 = select i1 %3588, double %3570, double %3587
  %3590 = load i64, ptr %3542, align 8
  %3591 = getelementptr inbounds double, ptr %3576, i64 %3590
  store double %3589, ptr %3591, align 8
  %3592 = add nsw i64 %3573, 1
  %3593 = icmp eq i64 %3592, %3540
  br i1 %3593, label %3557, label %3571

3594:                                             ; preds = %3559, %3547, %3538
  %3595 = phi i64 [ %3539, %3538 ], [ %3539, %3547 ], [ %3560, %3559 ]
  %3596 = phi i64 [ %3540, %3538 ], [ %3540, %3547 ], [ %3562, %3559 ]
  %3597 = add nuw nsw i64 %3541, 1
  %3598 = icmp eq i64 %3597, %3467
  br i1 %3598, label %3534, label %3538

3599:                                             ; preds = %3599, %3536
  %3600 = phi i64 [ %3465, %3536 ], [ %3602, %3599 ]
  %3601 = getelementptr inbounds i64, ptr %3537, i64 %3600
  store i64 %371, ptr %3601, align 8
  %3602 = add nsw i64 %3600, 1
  %3603 = load i64, ptr %159, align 8
  %3604 = icmp slt i64 %3602, %3603
  br i1 %3604, label %3599, label %3605

3605:                                             ; preds = %3599, %3534
  %3606 = phi i64 [ %3595, %3534 ], [ %3603, %3599 ]
  %3607 = add nuw nsw i64 %3466, 1
  %3608 = icmp eq i64 %3607, %3459
  br i1 %3608, label %3610, label %3464

3609:                                             ; preds = %364
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %80) #13
  br label %3617

3610:                                             ; preds = %3605, %3458, %957
  %3611 = phi double [ %420, %957 ], [ %959, %3458 ], [ %959, %3605 ]
  %3612 = phi double [ %421, %957 ], [ %960, %3458 ], [ %960, %3605 ]
  %3613 = phi double [ %422, %957 ], [ %961, %3458 ], [ %961, %3605 ]
  call void @llvm.lifetime.end.p0(i64 96, ptr nonnull %80) #13
  %3614 = add nsw i64 %371, 1
  %3615 = load i64, ptr %153, align 8
  %3616 = icmp slt i64 %3614, %3615
  br i1 %3616, label %364, label %3617

3617:                                             ; preds = %3610, %148, %3609
  %3618 = phi i64 [ %371, %3609 ], [ %154, %148 ], [ %3615, %3610 ]
  call void @llvm.lifetime.end.p0(i64 504, ptr nonnull %79) #13
  call void @llvm.lifetime.end.p0(i64 504, ptr nonnull %78) #13
  ret i64 %3618
}

declare void @llvm.lifetime.start.p0(i64 immarg, ptr nocapture) #1

declare void @llvm.memset.p0.i64(ptr nocapture writeonly, i8, i64, i1 immarg) #2

declare void @llvm.lifetime.end.p0(i64 immarg, ptr nocapture) #1

define dso_local i64 @manipplan_arrangement(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef writeonly %2) local_unnamed_addr #3 {
  %4 = alloca %struct.Arrangement, align 8
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %4) #13
  call fastcc void @arrangement(ptr nonnull sret(%struct.Arrangement) align 8 %4, ptr noundef %0, ptr noundef %1)
  %5 = getelementptr inbounds %struct.Arrangement, ptr %4, i64 0, i32 1
  %6 = load double, ptr %5, align 8
  %7 = getelementptr inbounds %struct.Arrangement, ptr %4, i64 0, i32 1, i32 1
  %8 = load double, ptr %7, align 8
  %9 = getelementptr inbounds %struct.Arrangement, ptr %4, i64 0, i32 1, i32 2
  %10 = load double, ptr %9, align 8
  store double %6, ptr %2, align 8
  %11 = getelementptr inbounds double, ptr %2, i64 1
  store double %8, ptr %11, align 8
  %12 = getelementptr inbounds double, ptr %2, i64 2
  store double %10, ptr %12, align 8
  %13 = getelementptr inbounds %struct.Arrangement, ptr %4, i64 0, i32 2
  %14 = load double, ptr %13, align 8
  %15 = getelementptr inbounds double, ptr %2, i64 3
  store double %14, ptr %15, align 8
  %16 = load i64, ptr %4, align 8
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %4) #13
  ret i64 %16
}

define internal fastcc void @arrangement(ptr noalias nocapture writeonly sret(%struct.Arrangement) align 8 %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2) unnamed_addr #3 {
  br label %4

4:                                                ; preds = %3, %92
  %5 = phi i1 [ true, %3 ], [ false, %92 ]
  %6 = phi i64 [ 0, %3 ], [ 1, %92 ]
  %7 = mul nuw nsw i64 %6, 3
  %8 = getelementptr inbounds double, ptr %1, i64 %7
  %9 = load double, ptr %8, align 8
  %10 = add nuw nsw i64 %7, 1
  %11 = getelementptr inbounds double, ptr %1, i64 %10
  %12 = load double, ptr %11, align 8
  %13 = add nuw nsw i64 %7, 2
  %14 = getelementptr inbounds double, ptr %1, i64 %13
  %15 = load double, ptr %14, align 8
  %16 = mul nuw nsw i64 %6, 3
  %17 = add nuw nsw i64 %16, 3
  %18 = getelementptr inbounds double, ptr %1, i64 %17
  %19 = load double, ptr %18, align 8
  %20 = or i64 %16, 4
  %21 = getelementptr inbounds double, ptr %1, i64 %20
  %22 = load double, ptr %21, align 8
  %23 = add nuw nsw i64 %16, 5
  %24 = getelementptr inbounds double, ptr %1, i64 %23
  %25 = load double, ptr %24, align 8
  %26 = fmul double %12, %25
  %27 = fmul double %15, %22
  %28 = fsub double %26, %27
  %29 = fmul double %15, %19
  %30 = fmul double %9, %25
  %31 = fsub double %29, %30
  %32 = fmul double %9, %22
  %33 = fmul double %12, %19
  %34 = fsub double %32, %33
  %35 = fmul double %28, %28
  %36 = fmul double %31, %31
  %37 = fadd double %35, %36
  %38 = fmul double %34, %34
  %39 = fadd double %38, %37
  %40 = fcmp ogt double %39, 0x3DDB7CDFD9D7BDBC
  br i1 %40, label %41, label %92

41:                                               ; preds = %4
  %42 = getelementptr inbounds double, ptr %2, i64 %17
  %43 = load double, ptr %42, align 8
  %44 = getelementptr inbounds double, ptr %2, i64 %20
  %45 = load double, ptr %44, align 8
  %46 = getelementptr inbounds double, ptr %2, i64 %23
  %47 = load double, ptr %46, align 8
  %48 = getelementptr inbounds double, ptr %2, i64 %7
  %49 = load double, ptr %48, align 8
  %50 = getelementptr inbounds double, ptr %2, i64 %10
  %51 = load double, ptr %50, align 8
  %52 = getelementptr inbounds double, ptr %2, i64 %13
  %53 = load double, ptr %52, align 8
  %54 = fsub double %43, %49
  %55 = fsub double %45, %51
  %56 = fsub double %47, %53
  %57 = fmul double %28, %54
  %58 = fmul double %31, %55
  %59 = fadd double %57, %58
  %60 = fmul double %34, %56
  %61 = fadd double %59, %60
  %62 = tail call double @llvm.fabs.f64(double %61)
  %63 = tail call double @llvm.sqrt.f64(double %39)
  %64 = fdiv double %62, %63
  %65 = fcmp uge double %64, 1.000000e-05
  br i1 %65, label %92, label %66

66:                                               ; preds = %41
  %67 = fmul double %25, %55
  %68 = fmul double %22, %56
  %69 = fsub double %67, %68
  %70 = fmul double %19, %56
  %71 = fmul double %25, %54
  %72 = fsub double %70, %71
  %73 = fmul double %22, %54
  %74 = fmul double %19, %55
  %75 = fsub double %73, %74
  %76 = fmul double %28, %69
  %77 = fmul double %31, %72
  %78 = fadd double %76, %77
  %79 = fmul double %34, %75
  %80 = fadd double %79, %78
  %81 = fdiv double %80, %39
  store i64 %6, ptr %0, align 8
  %82 = getelementptr inbounds %struct.Arrangement, ptr %0, i64 0, i32 1
  %83 = fmul double %9, %81
  %84 = fmul double %12, %81
  %85 = fmul double %15, %81
  %86 = fadd double %49, %83
  store double %86, ptr %82, align 8
  %87 = getelementptr inbounds %struct.Arrangement, ptr %0, i64 0, i32 1, i32 1
  %88 = fadd double %51, %84
  store double %88, ptr %87, align 8
  %89 = getelementptr inbounds %struct.Arrangement, ptr %0, i64 0, i32 1, i32 2
  %90 = fadd double %53, %85
  store double %90, ptr %89, align 8
  %91 = getelementptr inbounds %struct.Arrangement, ptr %0, i64 0, i32 2
  store double %64, ptr %91, align 8
  br label %139

92:                                               ; preds = %41, %4
  br i1 %5, label %4, label %93

93:                                               ; preds = %92, %96
  %94 = phi i64 [ %106, %96 ], [ 0, %92 ]
  %95 = icmp eq i64 %94, 2
  br i1 %95, label %137, label %96

96:                                               ; preds = %93
  %97 = mul nuw nsw i64 %94, 3
  %98 = getelementptr inbounds double, ptr %1, i64 %97
  %99 = load double, ptr %98, align 8
  %100 = add nuw nsw i64 %97, 1
  %101 = getelementptr inbounds double, ptr %1, i64 %100
  %102 = load double, ptr %101, align 8
  %103 = add nuw nsw i64 %97, 2
  %104 = getelementptr inbounds double, ptr %1, i64 %103
  %105 = load double, ptr %104, align 8
  %106 = add nuw nsw i64 %94, 1
  %107 = mul nuw nsw i64 %106, 3
  %108 = getelementptr inbounds double, ptr %1, i64 %107
  %109 = load double, ptr %108, align 8
  %110 = add nuw nsw i64 %107, 1
  %111 = getelementptr inbounds double, ptr %1, i64 %110
  %112 = load double, ptr %111, align 8
  %113 = add nuw nsw i64 %107, 2
  %114 = getelementptr inbounds double, ptr %1, i64 %113
  %115 = load double, ptr %114, align 8
  %116 = fmul double %102, %115
  %117 = fmul double %105, %112
  %118 = fsub double %116, %117
  %119 = fmul double %105, %109
  %120 = fmul double %99, %115
  %121 = fsub double %119, %120
  %122 = fmul double %99, %112
  %123 = fmul double %102, %109
  %124 = fsub double %122, %123
  %125 = fmul double %118, %118
  %126 = fmul double %121, %121
  %127 = fadd double %125, %126
  %128 = fmul double %124, %124
  %129 = fadd double %128, %127
  %130 = tail call double @llvm.sqrt.f64(double %129)
  %131 = fcmp uge double %130, 1.000000e-05
  br i1 %131, label %93, label %132

132:                                              ; preds = %96
  %133 = icmp eq i64 %94, 0
  %134 = select i1 %133, i64 2, i64 3
  store i64 %134, ptr %0, align 8
  %135 = getelementptr inbounds %struct.Arrangement, ptr %0, i64 0, i32 1
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %135, i8 0, i64 24, i1 false)
  %136 = getelementptr inbounds %struct.Arrangement, ptr %0, i64 0, i32 2
  store double %130, ptr %136, align 8
  br label %139

137:                                              ; preds = %93
  %138 = getelementptr inbounds i8, ptr %0, i64 8
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(40) %138, i8 0, i64 32, i1 false)
  store i64 4, ptr %0, align 8
  br label %139

139:                                              ; preds = %132, %66, %137
  ret void
}

define dso_local i64 @manipplan_quartic(ptr nocapture noundef readonly %0, ptr nocapture noundef writeonly %1) local_unnamed_addr #4 {
  %3 = alloca [4 x %struct.Complex], align 16
  call void @llvm.lifetime.start.p0(i64 64, ptr nonnull %3) #13
  %4 = call fastcc i32 @quartic_roots(ptr noundef %0, ptr noundef nonnull %3)
  %5 = zext i32 %4 to i64
  %6 = icmp eq i32 %4, 0
  br i1 %6, label %7, label %8

7:                                                ; preds = %8, %2
  call void @llvm.lifetime.end.p0(i64 64, ptr nonnull %3) #13
  ret i64 %5

8:                                                ; preds = %2, %8
  %9 = phi i64 [ %18, %8 ], [ 0, %2 ]
  %10 = getelementptr inbounds [4 x %struct.Complex], ptr %3, i64 0, i64 %9
  %11 = load double, ptr %10, align 16
  %12 = shl nuw nsw i64 %9, 1
  %13 = getelementptr inbounds double, ptr %1, i64 %12
  store double %11, ptr %13, align 8
  %14 = getelementptr inbounds [4 x %struct.Complex], ptr %3, i64 0, i64 %9, i32 1
  %15 = load double, ptr %14, align 8
  %16 = or i64 %12, 1
  %17 = getelementptr inbounds double, ptr %1, i64 %16
  store double %15, ptr %17, align 8
  %18 = add nuw nsw i64 %9, 1
  %19 = icmp eq i64 %18, %5
  br i1 %19, label %7, label %8
}

define internal fastcc i32 @quartic_roots(ptr nocapture noundef readonly %0, ptr nocapture noundef writeonly %1) unnamed_addr #4 {
  %3 = alloca [4 x %struct.Complex], align 16
  %4 = alloca [4 x %struct.Complex], align 16
  %5 = alloca [4 x [4 x double]], align 16
  %6 = alloca [4 x [4 x %struct.Complex]], align 16
  call void @llvm.lifetime.start.p0(i64 128, ptr nonnull %5) #13
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(128) %5, i8 0, i64 128, i1 false)
  call void @llvm.lifetime.start.p0(i64 256, ptr nonnull %6) #13
  br label %7

7:                                                ; preds = %2, %21
  %8 = phi i64 [ 0, %2 ], [ %22, %21 ]
  %9 = getelementptr inbounds double, ptr %0, i64 %8
  %10 = load double, ptr %9, align 8
  %11 = tail call double @llvm.fabs.f64(double %10)
  %12 = fcmp olt double %11, 0x7FF0000000000000
  br i1 %12, label %13, label %427

13:                                               ; preds = %7
  %14 = fneg double %10
  %15 = getelementptr inbounds [4 x [4 x double]], ptr %5, i64 0, i64 %8, i64 3
  store double %14, ptr %15, align 8
  %16 = icmp eq i64 %8, 0
  br i1 %16, label %21, label %17

17:                                               ; preds = %13
  %18 = add nuw i64 %8, 4294967295
  %19 = and i64 %18, 4294967295
  %20 = getelementptr inbounds [4 x [4 x double]], ptr %5, i64 0, i64 %8, i64 %19
  store double 1.000000e+00, ptr %20, align 8
  br label %21

21:                                               ; preds = %13, %17
  %22 = add nuw nsw i64 %8, 1
  %23 = icmp eq i64 %22, 4
  br i1 %23, label %24, label %7

24:                                               ; preds = %21, %29
  %25 = phi i32 [ %30, %29 ], [ 0, %21 ]
  br label %26

26:                                               ; preds = %103, %24
  %27 = phi i64 [ 0, %24 ], [ %105, %103 ]
  %28 = phi i32 [ 0, %24 ], [ %104, %103 ]
  br label %42

29:                                               ; preds = %103
  %30 = add nuw nsw i32 %25, 1
  %31 = icmp ne i32 %104, 0
  %32 = icmp ult i32 %25, 99
  %33 = select i1 %31, i1 %32, i1 false
  br i1 %33, label %24, label %107

34:                                               ; preds = %56
  %35 = fcmp ogt double %57, 0.000000e+00
  %36 = fcmp ogt double %58, 0.000000e+00
  %37 = select i1 %35, i1 %36, i1 false
  %38 = fcmp olt double %57, 0x7FF0000000000000
  %39 = and i1 %38, %37
  %40 = fcmp olt double %58, 0x7FF0000000000000
  %41 = select i1 %39, i1 %40, i1 false
  br i1 %41, label %61, label %103

42:                                               ; preds = %56, %26
  %43 = phi i64 [ 0, %26 ], [ %59, %56 ]
  %44 = phi double [ 0.000000e+00, %26 ], [ %58, %56 ]
  %45 = phi double [ 0.000000e+00, %26 ], [ %57, %56 ]
  %46 = icmp eq i64 %43, %27
  br i1 %46, label %56, label %47

47:                                               ; preds = %42
  %48 = getelementptr inbounds [4 x double], ptr %5, i64 %27, i64 %43
  %49 = load double, ptr %48, align 8
  %50 = tail call double @llvm.fabs.f64(double %49)
  %51 = fadd double %45, %50
  %52 = getelementptr inbounds [4 x double], ptr %5, i64 %43, i64 %27
  %53 = load double, ptr %52, align 8
  %54 = tail call double @llvm.fabs.f64(double %53)
  %55 = fadd double %44, %54
  br label %56

56:                                               ; preds = %47, %42
  %57 = phi double [ %51, %47 ], [ %45, %42 ]
  %58 = phi double [ %55, %47 ], [ %44, %42 ]
  %59 = add nuw nsw i64 %43, 1
  %60 = icmp eq i64 %59, 4
  br i1 %60, label %34, label %42

61:                                               ; preds = %34
  %62 = fadd double %57, %58
  %63 = fmul double %57, 5.000000e-01
  %64 = fcmp olt double %58, %63
  br i1 %64, label %70, label %65

65:                                               ; preds = %70, %61
  %66 = phi double [ %58, %61 ], [ %74, %70 ]
  %67 = phi double [ 1.000000e+00, %61 ], [ %73, %70 ]
  %68 = fmul double %57, 2.000000e+00
  %69 = fcmp ult double %66, %68
  br i1 %69, label %82, label %76

70:                                               ; preds = %61, %70
  %71 = phi double [ %73, %70 ], [ 1.000000e+00, %61 ]
  %72 = phi double [ %74, %70 ], [ %58, %61 ]
  %73 = fmul double %71, 2.000000e+00
  %74 = fmul double %72, 4.000000e+00
  %75 = fcmp olt double %74, %63
  br i1 %75, label %70, label %65

76:                                               ; preds = %65, %76
  %77 = phi double [ %79, %76 ], [ %67, %65 ]
  %78 = phi double [ %80, %76 ], [ %66, %65 ]
  %79 = fmul double %77, 5.000000e-01
  %80 = fmul double %78, 2.500000e-01
  %81 = fcmp ult double %80, %68
  br i1 %81, label %82, label %76

82:                                               ; preds = %76, %65
  %83 = phi double [ %66, %65 ], [ %80, %76 ]
  %84 = phi double [ %67, %65 ], [ %79, %76 ]
  %85 = fadd double %57, %83
  %86 = fdiv double %85, %84
  %87 = fmul double %62, 0x3FEE666666666666
  %88 = fcmp olt double %86, %87
  br i1 %88, label %89, label %103

89:                                               ; preds = %82, %89
  %90 = phi i64 [ %94, %89 ], [ 0, %82 ]
  %91 = getelementptr inbounds [4 x double], ptr %5, i64 %27, i64 %90
  %92 = load double, ptr %91, align 8
  %93 = fdiv double %92, %84
  store double %93, ptr %91, align 8
  %94 = add nuw nsw i64 %90, 1
  %95 = icmp eq i64 %94, 4
  br i1 %95, label %96, label %89

96:                                               ; preds = %89, %96
  %97 = phi i64 [ %101, %96 ], [ 0, %89 ]
  %98 = getelementptr inbounds [4 x double], ptr %5, i64 %97, i64 %27
  %99 = load double, ptr %98, align 8
  %100 = fmul double %84, %99
  store double %100, ptr %98, align 8
  %101 = add nuw nsw i64 %97, 1
  %102 = icmp eq i64 %101, 4
  br i1 %102, label %103, label %96

103:                                              ; preds = %96, %82, %34
  %104 = phi i32 [ %28, %34 ], [ %28, %82 ], [ 1, %96 ]
  %105 = add nuw nsw i64 %27, 1
  %106 = icmp eq i64 %105, 4
  br i1 %106, label %29, label %26

107:                                              ; preds = %29, %109
  %108 = phi i64 [ %110, %109 ], [ 0, %29 ]
  br label %112

109:                                              ; preds = %112
  %110 = add nuw nsw i64 %108, 1
  %111 = icmp eq i64 %110, 4
  br i1 %111, label %120, label %107

112:                                              ; preds = %107, %112
  %113 = phi i64 [ 0, %107 ], [ %118, %112 ]
  %114 = getelementptr inbounds [4 x [4 x %struct.Complex]], ptr %6, i64 0, i64 %108, i64 %113
  %115 = getelementptr inbounds [4 x [4 x double]], ptr %5, i64 0, i64 %108, i64 %113
  %116 = load double, ptr %115, align 8
  store double %116, ptr %114, align 16
  %117 = getelementptr inbounds i8, ptr %114, i64 8
  store double 0.000000e+00, ptr %117, align 8
  %118 = add nuw nsw i64 %113, 1
  %119 = icmp eq i64 %118, 4
  br i1 %119, label %109, label %112

120:                                              ; preds = %109, %417
  %121 = phi i32 [ %419, %417 ], [ 1, %109 ]
  %122 = phi i32 [ %418, %417 ], [ 3, %109 ]
  %123 = zext i32 %122 to i64
  br label %124

124:                                              ; preds = %120, %128
  %125 = phi i64 [ %123, %120 ], [ %134, %128 ]
  %126 = trunc i64 %125 to i32
  %127 = icmp sgt i32 %126, 0
  br i1 %127, label %128, label %150

128:                                              ; preds = %124
  %129 = getelementptr inbounds [4 x [4 x %struct.Complex]], ptr %6, i64 0, i64 %125, i64 %125
  %130 = load double, ptr %129, align 16
  %131 = getelementptr inbounds { double, double }, ptr %129, i64 0, i32 1
  %132 = load double, ptr %131, align 8
  %133 = tail call double @hypot(double noundef %130, double noundef %132) #14
  %134 = add nsw i64 %125, -1
  %135 = getelementptr inbounds [4 x [4 x %struct.Complex]], ptr %6, i64 0, i64 %134, i64 %134
  %136 = load double, ptr %135, align 16
  %137 = getelementptr inbounds { double, double }, ptr %135, i64 0, i32 1
  %138 = load double, ptr %137, align 8
  %139 = tail call double @hypot(double noundef %136, double noundef %138) #14
  %140 = fadd double %133, %139
  %141 = getelementptr inbounds [4 x [4 x %struct.Complex]], ptr %6, i64 0, i64 %125, i64 %134
  %142 = load double, ptr %141, align 16
  %143 = getelementptr inbounds { double, double }, ptr %141, i64 0, i32 1
  %144 = load double, ptr %143, align 8
  %145 = tail call double @hypot(double noundef %142, double noundef %144) #14
  %146 = fmul double %140, 2.300000e-16
  %147 = fcmp ugt double %145, %146
  br i1 %147, label %124, label %148

148:                                              ; preds = %128
  %149 = trunc i64 %125 to i32
  br label %150

150:                                              ; preds = %124, %148
  %151 = phi i32 [ %149, %148 ], [ 0, %124 ]
  %152 = icmp eq i32 %151, %122
  br i1 %152, label %153, label %155

153:                                              ; preds = %150
  %154 = add nsw i32 %122, -1
  br label %417

155:                                              ; preds = %150
  %156 = icmp ugt i32 %121, 200
  br i1 %156, label %427, label %157

157:                                              ; preds = %155
  %158 = add nsw i32 %122, -1
  %159 = zext i32 %158 to i64
  %160 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %159, i64 %159
  %161 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %123, i64 %123
  %162 = load double, ptr %160, align 16
  %163 = getelementptr inbounds { double, double }, ptr %160, i64 0, i32 1
  %164 = load double, ptr %163, align 8
  %165 = load double, ptr %161, align 16
  %166 = getelementptr inbounds { double, double }, ptr %161, i64 0, i32 1
  %167 = load double, ptr %166, align 8
  %168 = fsub double %162, %165
  %169 = fsub double %164, %167
  %170 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %159, i64 %123
  %171 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %123, i64 %159
  %172 = load double, ptr %170, align 16
  %173 = getelementptr inbounds { double, double }, ptr %170, i64 0, i32 1
  %174 = load double, ptr %173, align 8
  %175 = load double, ptr %171, align 16
  %176 = getelementptr inbounds { double, double }, ptr %171, i64 0, i32 1
  %177 = load double, ptr %176, align 8
  %178 = fmul double %172, %175
  %179 = fmul double %174, %177
  %180 = fsub double %178, %179
  %181 = fmul double %172, %177
  %182 = fmul double %174, %175
  %183 = fadd double %182, %181
  %184 = fmul double %168, 5.000000e-01
  %185 = fmul double %169, 5.000000e-01
  %186 = fmul double %184, %184
  %187 = fmul double %185, %185
  %188 = fsub double %186, %187
  %189 = fmul double %184, %185
  %190 = fadd double %189, %189
  %191 = fadd double %188, %180
  %192 = fadd double %190, %183
  %193 = tail call double @hypot(double noundef %191, double noundef %192) #14
  %194 = tail call double @llvm.fabs.f64(double %191)
  %195 = fadd double %193, %194
  %196 = fmul double %195, 5.000000e-01
  %197 = tail call double @llvm.sqrt.f64(double %196)
  %198 = fcmp ogt double %197, 0.000000e+00
  %199 = tail call double @llvm.fabs.f64(double %192)
  %200 = fmul double %199, 5.000000e-01
  %201 = fdiv double %200, %197
  %202 = select i1 %198, double %201, double 0.000000e+00
  %203 = fcmp ult double %191, 0.000000e+00
  %204 = tail call double @llvm.copysign.f64(double %202, double %192)
  %205 = tail call double @llvm.copysign.f64(double %197, double %192)
  %206 = select i1 %203, double %202, double %197
  %207 = select i1 %203, double %205, double %204
  %208 = fmul double %184, %206
  %209 = fmul double %185, %207
  %210 = fadd double %208, %209
  %211 = fcmp olt double %210, 0.000000e+00
  %212 = fneg double %206
  %213 = fneg double %207
  %214 = select i1 %211, double %212, double %206
  %215 = select i1 %211, double %213, double %207
  %216 = fadd double %184, %214
  %217 = fadd double %185, %215
  %218 = fmul double %216, %216
  %219 = fmul double %217, %217
  %220 = fadd double %218, %219
  %221 = fcmp ogt double %220, 0.000000e+00
  br i1 %221, label %222, label %233

222:                                              ; preds = %157
  %223 = fmul double %180, %216
  %224 = fmul double %183, %217
  %225 = fadd double %223, %224
  %226 = fmul double %183, %216
  %227 = fmul double %180, %217
  %228 = fsub double %226, %227
  %229 = fdiv double %225, %220
  %230 = fdiv double %228, %220
  %231 = fsub double %165, %229
  %232 = fsub double %167, %230
  br label %233

233:                                              ; preds = %157, %222
  %234 = phi double [ %231, %222 ], [ %165, %157 ]
  %235 = phi double [ %232, %222 ], [ %167, %157 ]
  %236 = trunc i32 %121 to i8
  %237 = urem i8 %236, 11
  %238 = icmp eq i8 %237, 10
  br i1 %238, label %239, label %242

239:                                              ; preds = %233
  %240 = tail call double @hypot(double noundef %175, double noundef %177) #14
  %241 = fadd double %234, %240
  br label %242

242:                                              ; preds = %239, %233
  %243 = phi double [ %241, %239 ], [ %234, %233 ]
  call void @llvm.lifetime.start.p0(i64 64, ptr nonnull %3) #13
  call void @llvm.lifetime.start.p0(i64 64, ptr nonnull %4) #13
  %244 = icmp sgt i32 %151, %122
  br i1 %244, label %248, label %245

245:                                              ; preds = %242
  %246 = zext i32 %151 to i64
  %247 = add i32 %122, 1
  br label %253

248:                                              ; preds = %253, %242
  %249 = icmp slt i32 %151, %122
  br i1 %249, label %250, label %358

250:                                              ; preds = %248
  %251 = sext i32 %151 to i64
  %252 = sext i32 %122 to i64
  br label %268

253:                                              ; preds = %253, %245
  %254 = phi i64 [ %246, %245 ], [ %261, %253 ]
  %255 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %254, i64 %254
  %256 = load double, ptr %255, align 16
  %257 = getelementptr inbounds { double, double }, ptr %255, i64 0, i32 1
  %258 = load double, ptr %257, align 8
  %259 = fsub double %256, %243
  %260 = fsub double %258, %235
  store double %259, ptr %255, align 16
  store double %260, ptr %257, align 8
  %261 = add nuw nsw i64 %254, 1
  %262 = trunc i64 %261 to i32
  %263 = icmp eq i32 %247, %262
  br i1 %263, label %248, label %253

264:                                              ; preds = %299
  %265 = icmp eq i64 %275, %252
  br i1 %265, label %266, label %268

266:                                              ; preds = %264
  %267 = add i32 %151, 2
  br label %339

268:                                              ; preds = %264, %250
  %269 = phi i64 [ %251, %250 ], [ %275, %264 ]
  %270 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %269, i64 %269
  %271 = load double, ptr %270, align 16
  %272 = getelementptr inbounds { double, double }, ptr %270, i64 0, i32 1
  %273 = load double, ptr %272, align 8
  %274 = tail call double @hypot(double noundef %271, double noundef %273) #14
  %275 = add nsw i64 %269, 1
  %276 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %275, i64 %269
  %277 = load double, ptr %276, align 16
  %278 = getelementptr inbounds { double, double }, ptr %276, i64 0, i32 1
  %279 = load double, ptr %278, align 8
  %280 = tail call double @hypot(double noundef %277, double noundef %279) #14
  %281 = tail call double @hypot(double noundef %274, double noundef %280) #14
  %282 = getelementptr inbounds [4 x %struct.Complex], ptr %3, i64 0, i64 %269
  %283 = fcmp ogt double %281, 0.000000e+00
  br i1 %283, label %284, label %291

284:                                              ; preds = %268
  %285 = fdiv double %271, %281
  %286 = fdiv double %273, %281
  %287 = getelementptr inbounds [4 x %struct.Complex], ptr %4, i64 0, i64 %269
  %288 = fdiv double %277, %281
  %289 = fdiv double %279, %281
  store double %288, ptr %287, align 16
  %290 = getelementptr inbounds i8, ptr %287, i64 8
  store double %289, ptr %290, align 8
  br label %293

291:                                              ; preds = %268
  %292 = getelementptr inbounds [4 x %struct.Complex], ptr %4, i64 0, i64 %269
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(16) %292, i8 0, i64 16, i1 false)
  br label %293

293:                                              ; preds = %291, %284
  %294 = phi double [ %285, %284 ], [ 1.000000e+00, %291 ]
  %295 = phi double [ %286, %284 ], [ 0.000000e+00, %291 ]
  %296 = phi double [ %289, %284 ], [ 0.000000e+00, %291 ]
  %297 = phi double [ %288, %284 ], [ 0.000000e+00, %291 ]
  store double %294, ptr %282, align 16
  %298 = getelementptr inbounds i8, ptr %282, i64 8
  store double %295, ptr %298, align 8
  br label %299

299:                                              ; preds = %299, %293
  %300 = phi i64 [ %269, %293 ], [ %337, %299 ]
  %301 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %269, i64 %300
  %302 = load double, ptr %301, align 16
  %303 = getelementptr inbounds i8, ptr %301, i64 8
  %304 = load double, ptr %303, align 8
  %305 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %275, i64 %300
  %306 = load double, ptr %305, align 16
  %307 = getelementptr inbounds i8, ptr %305, i64 8
  %308 = load double, ptr %307, align 8
  %309 = fmul double %294, %302
  %310 = fmul double %295, %304
  %311 = fadd double %309, %310
  %312 = fmul double %294, %304
  %313 = fmul double %295, %302
  %314 = fsub double %312, %313
  %315 = fmul double %297, %306
  %316 = fmul double %296, %308
  %317 = fadd double %315, %316
  %318 = fmul double %297, %308
  %319 = fmul double %296, %306
  %320 = fsub double %318, %319
  %321 = fadd double %311, %317
  %322 = fadd double %314, %320
  store double %321, ptr %301, align 16
  store double %322, ptr %303, align 8
  %323 = fmul double %294, %306
  %324 = fmul double %295, %308
  %325 = fsub double %323, %324
  %326 = fmul double %294, %308
  %327 = fmul double %295, %306
  %328 = fadd double %327, %326
  %329 = fmul double %297, %302
  %330 = fmul double %296, %304
  %331 = fsub double %329, %330
  %332 = fmul double %297, %304
  %333 = fmul double %296, %302
  %334 = fadd double %333, %332
  %335 = fsub double %325, %331
  %336 = fsub double %328, %334
  store double %335, ptr %305, align 16
  store double %336, ptr %307, align 8
  %337 = add nsw i64 %300, 1
  %338 = icmp slt i64 %300, %252
  br i1 %338, label %299, label %264

339:                                              ; preds = %266, %362
  %340 = phi i32 [ %267, %266 ], [ %364, %362 ]
  %341 = phi i64 [ %251, %266 ], [ %348, %362 ]
  %342 = tail call i32 @llvm.smin.i32(i32 %122, i32 %340)
  %343 = sext i32 %342 to i64
  %344 = trunc i64 %341 to i32
  %345 = add i32 %344, 2
  %346 = tail call i32 @llvm.smin.i32(i32 %345, i32 %122)
  %347 = icmp slt i32 %346, %151
  %348 = add nsw i64 %341, 1
  br i1 %347, label %362, label %349

349:                                              ; preds = %339
  %350 = getelementptr inbounds [4 x %struct.Complex], ptr %3, i64 0, i64 %341
  %351 = load double, ptr %350, align 16
  %352 = getelementptr inbounds { double, double }, ptr %350, i64 0, i32 1
  %353 = load double, ptr %352, align 8
  %354 = getelementptr inbounds [4 x %struct.Complex], ptr %4, i64 0, i64 %341
  %355 = load double, ptr %354, align 16
  %356 = getelementptr inbounds { double, double }, ptr %354, i64 0, i32 1
  %357 = load double, ptr %356, align 8
  br label %365

358:                                              ; preds = %362, %248
  br i1 %244, label %416, label %359

359:                                              ; preds = %358
  %360 = sext i32 %151 to i64
  %361 = add i32 %122, 1
  br label %405

362:                                              ; preds = %365, %339
  %363 = icmp eq i64 %348, %252
  %364 = add i32 %340, 1
  br i1 %363, label %358, label %339

365:                                              ; preds = %365, %349
  %366 = phi i64 [ %251, %349 ], [ %403, %365 ]
  %367 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %366, i64 %341
  %368 = load double, ptr %367, align 16
  %369 = getelementptr inbounds i8, ptr %367, i64 8
  %370 = load double, ptr %369, align 8
  %371 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %366, i64 %348
  %372 = load double, ptr %371, align 16
  %373 = getelementptr inbounds i8, ptr %371, i64 8
  %374 = load double, ptr %373, align 8
  %375 = fmul double %351, %368
  %376 = fmul double %353, %370
  %377 = fsub double %375, %376
  %378 = fmul double %353, %368
  %379 = fmul double %351, %370
  %380 = fadd double %378, %379
  %381 = fmul double %355, %372
  %382 = fmul double %357, %374
  %383 = fsub double %381, %382
  %384 = fmul double %357, %372
  %385 = fmul double %355, %374
  %386 = fadd double %384, %385
  %387 = fadd double %377, %383
  %388 = fadd double %380, %386
  store double %387, ptr %367, align 16
  store double %388, ptr %369, align 8
  %389 = fmul double %351, %372
  %390 = fmul double %353, %374
  %391 = fadd double %389, %390
  %392 = fmul double %351, %374
  %393 = fmul double %353, %372
  %394 = fsub double %392, %393
  %395 = fmul double %355, %368
  %396 = fmul double %357, %370
  %397 = fadd double %395, %396
  %398 = fmul double %355, %370
  %399 = fmul double %357, %368
  %400 = fsub double %398, %399
  %401 = fsub double %391, %397
  %402 = fsub double %394, %400
  store double %401, ptr %371, align 16
  store double %402, ptr %373, align 8
  %403 = add nsw i64 %366, 1
  %404 = icmp eq i64 %366, %343
  br i1 %404, label %362, label %365

405:                                              ; preds = %405, %359
  %406 = phi i64 [ %360, %359 ], [ %413, %405 ]
  %407 = getelementptr inbounds [4 x %struct.Complex], ptr %6, i64 %406, i64 %406
  %408 = load double, ptr %407, align 16
  %409 = getelementptr inbounds { double, double }, ptr %407, i64 0, i32 1
  %410 = load double, ptr %409, align 8
  %411 = fadd double %243, %408
  %412 = fadd double %235, %410
  store double %411, ptr %407, align 16
  store double %412, ptr %409, align 8
  %413 = add nsw i64 %406, 1
  %414 = trunc i64 %413 to i32
  %415 = icmp eq i32 %361, %414
  br i1 %415, label %416, label %405

416:                                              ; preds = %405, %358
  call void @llvm.lifetime.end.p0(i64 64, ptr nonnull %4) #13
  call void @llvm.lifetime.end.p0(i64 64, ptr nonnull %3) #13
  br label %417

417:                                              ; preds = %153, %416
  %418 = phi i32 [ %122, %416 ], [ %154, %153 ]
  %419 = add nuw nsw i32 %121, 1
  %420 = icmp slt i32 %418, 1
  br i1 %420, label %421, label %120

421:                                              ; preds = %417, %421
  %422 = phi i64 [ %425, %421 ], [ 0, %417 ]
  %423 = getelementptr inbounds %struct.Complex, ptr %1, i64 %422
  %424 = getelementptr inbounds [4 x [4 x %struct.Complex]], ptr %6, i64 0, i64 %422, i64 %422
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %423, ptr noundef nonnull align 16 dereferenceable(16) %424, i64 16, i1 false)
  %425 = add nuw nsw i64 %422, 1
  %426 = icmp eq i64 %425, 4
  br i1 %426, label %427, label %421

427:                                              ; preds = %7, %155, %421
  %428 = phi i32 [ 4, %421 ], [ 0, %155 ], [ 0, %7 ]
  call void @llvm.lifetime.end.p0(i64 256, ptr nonnull %6) #13
  call void @llvm.lifetime.end.p0(i64 128, ptr nonnull %5) #13
  ret i32 %428
}

define dso_local void @manipplan_swivels(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, ptr nocapture noundef readonly %4, i64 noundef %5, ptr nocapture noundef writeonly %6) local_unnamed_addr #3 {
  %8 = icmp sgt i64 %5, 0
  br i1 %8, label %9, label %22

9:                                                ; preds = %7
  %10 = getelementptr inbounds double, ptr %2, i64 1
  %11 = getelementptr inbounds double, ptr %2, i64 2
  %12 = getelementptr inbounds double, ptr %3, i64 1
  %13 = getelementptr inbounds double, ptr %3, i64 2
  %14 = getelementptr inbounds double, ptr %0, i64 9
  %15 = getelementptr inbounds double, ptr %0, i64 10
  %16 = getelementptr inbounds double, ptr %0, i64 11
  %17 = getelementptr inbounds double, ptr %1, i64 9
  %18 = getelementptr inbounds double, ptr %1, i64 10
  %19 = getelementptr inbounds double, ptr %1, i64 11
  %20 = getelementptr inbounds double, ptr %0, i64 1
  %21 = getelementptr inbounds double, ptr %0, i64 2
  br label %23

22:                                               ; preds = %262, %7
  ret void

23:                                               ; preds = %9, %262
  %24 = phi i64 [ 0, %9 ], [ %287, %262 ]
  %25 = load double, ptr %2, align 8
  %26 = load double, ptr %10, align 8
  %27 = load double, ptr %11, align 8
  %28 = load double, ptr %3, align 8
  %29 = load double, ptr %12, align 8
  %30 = load double, ptr %13, align 8
  %31 = mul nuw nsw i64 %24, 7
  %32 = getelementptr inbounds double, ptr %4, i64 %31
  %33 = load double, ptr %14, align 8
  %34 = load double, ptr %15, align 8
  %35 = load double, ptr %16, align 8
  %36 = load double, ptr %17, align 8
  %37 = load double, ptr %18, align 8
  %38 = load double, ptr %19, align 8
  %39 = getelementptr inbounds double, ptr %32, i64 3
  %40 = load double, ptr %39, align 8
  %41 = tail call double @llvm.cos.f64(double %40)
  %42 = tail call double @llvm.sin.f64(double %40)
  %43 = fsub double %28, %36
  %44 = fsub double %29, %37
  %45 = fsub double %30, %38
  %46 = fmul double %33, %43
  %47 = fmul double %34, %44
  %48 = fadd double %46, %47
  %49 = fmul double %35, %45
  %50 = fadd double %48, %49
  %51 = fsub double 1.000000e+00, %41
  %52 = fmul double %51, %50
  %53 = fmul double %34, %45
  %54 = fmul double %35, %44
  %55 = fsub double %53, %54
  %56 = fmul double %35, %43
  %57 = fmul double %33, %45
  %58 = fsub double %56, %57
  %59 = fmul double %33, %44
  %60 = fmul double %34, %43
  %61 = fsub double %59, %60
  %62 = fmul double %43, %41
  %63 = fmul double %42, %55
  %64 = fadd double %62, %63
  %65 = fmul double %33, %52
  %66 = fadd double %65, %64
  %67 = fmul double %44, %41
  %68 = fmul double %42, %58
  %69 = fadd double %67, %68
  %70 = fmul double %34, %52
  %71 = fadd double %70, %69
  %72 = fmul double %45, %41
  %73 = fmul double %42, %61
  %74 = fadd double %72, %73
  %75 = fmul double %35, %52
  %76 = fadd double %74, %75
  %77 = fadd double %36, %66
  %78 = fadd double %37, %71
  %79 = fadd double %38, %76
  %80 = fsub double %77, %25
  %81 = fsub double %78, %26
  %82 = fsub double %79, %27
  br label %178

83:                                               ; preds = %178
  %84 = fmul double %219, %219
  %85 = fmul double %224, %224
  %86 = fadd double %84, %85
  %87 = fmul double %229, %229
  %88 = fadd double %87, %86
  %89 = tail call double @llvm.sqrt.f64(double %88)
  %90 = fdiv double %219, %89
  %91 = fdiv double %224, %89
  %92 = fdiv double %229, %89
  %93 = load double, ptr %0, align 8
  %94 = load double, ptr %20, align 8
  %95 = load double, ptr %21, align 8
  %96 = fmul double %90, %93
  %97 = fmul double %91, %94
  %98 = fadd double %96, %97
  %99 = fmul double %92, %95
  %100 = fadd double %98, %99
  %101 = fmul double %90, %100
  %102 = fmul double %91, %100
  %103 = fmul double %92, %100
  %104 = fsub double %93, %101
  %105 = fsub double %94, %102
  %106 = fsub double %95, %103
  %107 = fmul double %104, %104
  %108 = fmul double %105, %105
  %109 = fadd double %107, %108
  %110 = fmul double %106, %106
  %111 = fadd double %110, %109
  %112 = tail call double @llvm.sqrt.f64(double %111)
  %113 = fcmp olt double %112, 1.000000e-09
  br i1 %113, label %114, label %131

114:                                              ; preds = %83
  %115 = tail call double @llvm.fabs.f64(double %90)
  %116 = fcmp olt double %115, 6.000000e-01
  %117 = fneg double %92
  %118 = fneg double %90
  %119 = select i1 %116, double %91, double %118
  %120 = select i1 %116, double %117, double 0.000000e+00
  %121 = select i1 %116, double 0.000000e+00, double %92
  %122 = fmul double %121, %121
  %123 = fmul double %120, %120
  %124 = fadd double %123, %122
  %125 = fmul double %119, %119
  %126 = fadd double %125, %124
  %127 = tail call double @llvm.sqrt.f64(double %126)
  %128 = fdiv double %121, %127
  %129 = fdiv double %120, %127
  %130 = fdiv double %119, %127
  br label %135

131:                                              ; preds = %83
  %132 = fdiv double %104, %112
  %133 = fdiv double %105, %112
  %134 = fdiv double %106, %112
  br label %135

135:                                              ; preds = %131, %114
  %136 = phi double [ %128, %114 ], [ %132, %131 ]
  %137 = phi double [ %129, %114 ], [ %133, %131 ]
  %138 = phi double [ %130, %114 ], [ %134, %131 ]
  %139 = fmul double %249, %90
  %140 = fmul double %254, %91
  %141 = fadd double %139, %140
  %142 = fmul double %259, %92
  %143 = fadd double %142, %141
  %144 = fmul double %90, %143
  %145 = fmul double %91, %143
  %146 = fmul double %92, %143
  %147 = fsub double %249, %144
  %148 = fsub double %254, %145
  %149 = fsub double %259, %146
  %150 = fmul double %147, %147
  %151 = fmul double %148, %148
  %152 = fadd double %150, %151
  %153 = fmul double %149, %149
  %154 = fadd double %153, %152
  %155 = tail call double @llvm.sqrt.f64(double %154)
  %156 = fcmp olt double %155, 1.000000e-09
  br i1 %156, label %157, label %174

157:                                              ; preds = %135
  %158 = tail call double @llvm.fabs.f64(double %90)
  %159 = fcmp olt double %158, 6.000000e-01
  %160 = fneg double %92
  %161 = fneg double %90
  %162 = select i1 %159, double %91, double %161
  %163 = select i1 %159, double %160, double 0.000000e+00
  %164 = select i1 %159, double 0.000000e+00, double %92
  %165 = fmul double %164, %164
  %166 = fmul double %163, %163
  %167 = fadd double %166, %165
  %168 = fmul double %162, %162
  %169 = fadd double %168, %167
  %170 = tail call double @llvm.sqrt.f64(double %169)
  %171 = fdiv double %164, %170
  %172 = fdiv double %163, %170
  %173 = fdiv double %162, %170
  br label %262

174:                                              ; preds = %135
  %175 = fdiv double %147, %155
  %176 = fdiv double %148, %155
  %177 = fdiv double %149, %155
  br label %262

178:                                              ; preds = %178, %23
  %179 = phi i64 [ 2, %23 ], [ %260, %178 ]
  %180 = phi double [ %35, %23 ], [ %259, %178 ]
  %181 = phi double [ %34, %23 ], [ %254, %178 ]
  %182 = phi double [ %33, %23 ], [ %249, %178 ]
  %183 = phi double [ %82, %23 ], [ %229, %178 ]
  %184 = phi double [ %81, %23 ], [ %224, %178 ]
  %185 = phi double [ %80, %23 ], [ %219, %178 ]
  %186 = getelementptr inbounds double, ptr %32, i64 %179
  %187 = load double, ptr %186, align 8
  %188 = tail call double @llvm.cos.f64(double %187)
  %189 = tail call double @llvm.sin.f64(double %187)
  %190 = mul nuw nsw i64 %179, 3
  %191 = getelementptr inbounds double, ptr %0, i64 %190
  %192 = load double, ptr %191, align 8
  %193 = add nuw nsw i64 %190, 1
  %194 = getelementptr inbounds double, ptr %0, i64 %193
  %195 = load double, ptr %194, align 8
  %196 = add nuw nsw i64 %190, 2
  %197 = getelementptr inbounds double, ptr %0, i64 %196
  %198 = load double, ptr %197, align 8
  %199 = fmul double %185, %192
  %200 = fmul double %184, %195
  %201 = fadd double %199, %200
  %202 = fmul double %183, %198
  %203 = fadd double %201, %202
  %204 = fsub double 1.000000e+00, %188
  %205 = fmul double %204, %203
  %206 = fmul double %183, %195
  %207 = fmul double %184, %198
  %208 = fsub double %206, %207
  %209 = fmul double %185, %198
  %210 = fmul double %183, %192
  %211 = fsub double %209, %210
  %212 = fmul double %184, %192
  %213 = fmul double %185, %195
  %214 = fsub double %212, %213
  %215 = fmul double %185, %188
  %216 = fmul double %189, %208
  %217 = fadd double %215, %216
  %218 = fmul double %192, %205
  %219 = fadd double %218, %217
  %220 = fmul double %184, %188
  %221 = fmul double %189, %211
  %222 = fadd double %220, %221
  %223 = fmul double %195, %205
  %224 = fadd double %223, %222
  %225 = fmul double %183, %188
  %226 = fmul double %189, %214
  %227 = fadd double %225, %226
  %228 = fmul double %198, %205
  %229 = fadd double %227, %228
  %230 = fmul double %182, %192
  %231 = fmul double %181, %195
  %232 = fadd double %230, %231
  %233 = fmul double %180, %198
  %234 = fadd double %232, %233
  %235 = fmul double %204, %234
  %236 = fmul double %180, %195
  %237 = fmul double %181, %198
  %238 = fsub double %236, %237
  %239 = fmul double %182, %198
  %240 = fmul double %180, %192
  %241 = fsub double %239, %240
  %242 = fmul double %181, %192
  %243 = fmul double %182, %195
  %244 = fsub double %242, %243
  %245 = fmul double %182, %188
  %246 = fmul double %189, %238
  %247 = fadd double %245, %246
  %248 = fmul double %192, %235
  %249 = fadd double %248, %247
  %250 = fmul double %181, %188
  %251 = fmul double %189, %241
  %252 = fadd double %250, %251
  %253 = fmul double %195, %235
  %254 = fadd double %253, %252
  %255 = fmul double %180, %188
  %256 = fmul double %189, %244
  %257 = fadd double %255, %256
  %258 = fmul double %198, %235
  %259 = fadd double %257, %258
  %260 = add nsw i64 %179, -1
  %261 = icmp eq i64 %179, 0
  br i1 %261, label %83, label %178

262:                                              ; preds = %157, %174
  %263 = phi double [ %171, %157 ], [ %175, %174 ]
  %264 = phi double [ %172, %157 ], [ %176, %174 ]
  %265 = phi double [ %173, %157 ], [ %177, %174 ]
  %266 = fmul double %137, %265
  %267 = fmul double %138, %264
  %268 = fsub double %266, %267
  %269 = fmul double %138, %263
  %270 = fmul double %136, %265
  %271 = fsub double %269, %270
  %272 = fmul double %136, %264
  %273 = fmul double %137, %263
  %274 = fsub double %272, %273
  %275 = fmul double %90, %268
  %276 = fmul double %91, %271
  %277 = fadd double %275, %276
  %278 = fmul double %92, %274
  %279 = fadd double %278, %277
  %280 = fmul double %136, %263
  %281 = fmul double %137, %264
  %282 = fadd double %280, %281
  %283 = fmul double %138, %265
  %284 = fadd double %282, %283
  %285 = tail call double @atan2(double noundef %279, double noundef %284) #14
  %286 = getelementptr inbounds double, ptr %6, i64 %24
  store double %285, ptr %286, align 8
  %287 = add nuw nsw i64 %24, 1
  %288 = icmp eq i64 %287, %5
  br i1 %288, label %22, label %23
}

define dso_local void @manipplan_refine(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef %3, i64 noundef %4, i64 noundef %5, double noundef %6, ptr noundef %7, ptr nocapture noundef %8) local_unnamed_addr #0 {
  %10 = alloca %struct.State, align 8
  %11 = icmp sgt i64 %4, 0
  br i1 %11, label %12, label %18

12:                                               ; preds = %9
  %13 = getelementptr inbounds %struct.State, ptr %10, i64 0, i32 1
  %14 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 7
  %15 = getelementptr inbounds %struct.State, ptr %10, i64 0, i32 2
  %16 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 5
  %17 = icmp sgt i64 %5, 0
  br label %19

18:                                               ; preds = %85, %9
  ret void

19:                                               ; preds = %12, %85
  %20 = phi i64 [ 0, %12 ], [ %86, %85 ]
  %21 = getelementptr inbounds i64, ptr %2, i64 %20
  %22 = load i64, ptr %21, align 8
  %23 = shl nsw i64 %22, 4
  %24 = getelementptr inbounds double, ptr %1, i64 %23
  %25 = load i64, ptr %0, align 8
  %26 = mul nsw i64 %25, %20
  %27 = getelementptr inbounds double, ptr %3, i64 %26
  call void @llvm.lifetime.start.p0(i64 160, ptr nonnull %10) #13
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(160) %10, i8 0, i64 160, i1 false)
  store ptr %7, ptr %13, align 8
  %28 = load ptr, ptr %14, align 8
  %29 = icmp eq ptr %28, null
  %30 = mul nsw i64 %25, 7
  %31 = select i1 %29, i64 0, i64 %30
  %32 = getelementptr double, ptr %7, i64 %31
  store ptr %32, ptr %15, align 8
  %33 = mul nsw i64 %25, 6
  %34 = getelementptr double, ptr %7, i64 %33
  %35 = call fastcc double @look(ptr noundef nonnull %0, ptr noundef %24, ptr noundef %27, ptr noundef nonnull %10)
  %36 = load i64, ptr %0, align 8
  %37 = icmp sgt i64 %36, 0
  br i1 %37, label %39, label %38

38:                                               ; preds = %39, %19
  br i1 %17, label %50, label %85

39:                                               ; preds = %19, %39
  %40 = phi i64 [ %47, %39 ], [ 0, %19 ]
  %41 = load ptr, ptr %16, align 8
  %42 = getelementptr inbounds i8, ptr %41, i64 %40
  %43 = load i8, ptr %42, align 1
  %44 = icmp eq i8 %43, 0
  %45 = zext i1 %44 to i8
  %46 = getelementptr inbounds i8, ptr %8, i64 %40
  store i8 %45, ptr %46, align 1
  %47 = add nuw nsw i64 %40, 1
  %48 = load i64, ptr %0, align 8
  %49 = icmp slt i64 %47, %48
  br i1 %49, label %39, label %38

50:                                               ; preds = %38, %80
  %51 = phi double [ %82, %80 ], [ 0x3D06849B86A12B9B, %38 ]
  %52 = phi i64 [ %83, %80 ], [ 0, %38 ]
  %53 = phi double [ %81, %80 ], [ %35, %38 ]
  %54 = fcmp ugt double %53, %6
  %55 = fcmp ule double %51, 1.000000e-02
  %56 = select i1 %54, i1 %55, i1 false
  br i1 %56, label %57, label %85

57:                                               ; preds = %50
  %58 = load i64, ptr %0, align 8
  %59 = call fastcc i32 @step(i64 noundef %58, ptr noundef nonnull %10, ptr noundef %8, double noundef 0.000000e+00, double noundef %51, ptr noundef %27, ptr noundef %34)
  %60 = icmp eq i32 %59, 0
  br i1 %60, label %85, label %61

61:                                               ; preds = %57
  %62 = call fastcc double @look(ptr noundef nonnull %0, ptr noundef %24, ptr noundef %34, ptr noundef nonnull %10)
  %63 = fcmp olt double %62, %53
  br i1 %63, label %64, label %77

64:                                               ; preds = %61
  %65 = fdiv double %51, 1.000000e+02
  %66 = fcmp ogt double %65, 0x3D06849B86A12B9B
  %67 = select i1 %66, double %65, double 0x3D06849B86A12B9B
  %68 = load i64, ptr %0, align 8
  %69 = icmp sgt i64 %68, 0
  br i1 %69, label %70, label %80

70:                                               ; preds = %64, %70
  %71 = phi i64 [ %75, %70 ], [ 0, %64 ]
  %72 = getelementptr inbounds double, ptr %34, i64 %71
  %73 = load double, ptr %72, align 8
  %74 = getelementptr inbounds double, ptr %27, i64 %71
  store double %73, ptr %74, align 8
  %75 = add nuw nsw i64 %71, 1
  %76 = icmp eq i64 %75, %68
  br i1 %76, label %80, label %70

77:                                               ; preds = %61
  %78 = fmul double %51, 1.000000e+01
  %79 = call fastcc double @look(ptr noundef nonnull %0, ptr noundef %24, ptr noundef %27, ptr noundef nonnull %10)
  br label %80

80:                                               ; preds = %70, %77, %64
  %81 = phi double [ %53, %77 ], [ %62, %64 ], [ %62, %70 ]
  %82 = phi double [ %78, %77 ], [ %67, %64 ], [ %67, %70 ]
  %83 = add nuw nsw i64 %52, 1
  %84 = icmp eq i64 %83, %5
  br i1 %84, label %85, label %50

85:                                               ; preds = %50, %57, %80, %38
  call void @llvm.lifetime.end.p0(i64 160, ptr nonnull %10) #13
  %86 = add nuw nsw i64 %20, 1
  %87 = icmp eq i64 %86, %4
  br i1 %87, label %18, label %19
}

define dso_local void @manipplan_search(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef readonly %3, ptr nocapture noundef %4, i64 noundef %5, i64 noundef %6, double noundef %7, ptr nocapture noundef writeonly %8, ptr noundef %9, ptr nocapture noundef %10) local_unnamed_addr #0 {
  %12 = alloca %struct.State, align 8
  %13 = icmp sgt i64 %5, 0
  br i1 %13, label %14, label %21

14:                                               ; preds = %11
  %15 = getelementptr inbounds %struct.State, ptr %12, i64 0, i32 1
  %16 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 7
  %17 = getelementptr inbounds %struct.State, ptr %12, i64 0, i32 2
  %18 = getelementptr inbounds %struct.State, ptr %12, i64 0, i32 3
  %19 = icmp sgt i64 %6, 0
  %20 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 5
  br label %22

21:                                               ; preds = %169, %11
  ret void

22:                                               ; preds = %14, %169
  %23 = phi i64 [ 0, %14 ], [ %172, %169 ]
  %24 = load i64, ptr %0, align 8
  %25 = mul nsw i64 %24, %23
  %26 = getelementptr inbounds double, ptr %4, i64 %25
  call void @llvm.lifetime.start.p0(i64 160, ptr nonnull %12) #13
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(160) %12, i8 0, i64 160, i1 false)
  store ptr %9, ptr %15, align 8
  %27 = load ptr, ptr %16, align 8
  %28 = icmp eq ptr %27, null
  %29 = mul nsw i64 %24, 7
  %30 = select i1 %28, i64 0, i64 %29
  %31 = getelementptr double, ptr %9, i64 %30
  store ptr %31, ptr %17, align 8
  %32 = call fastcc double @look(ptr noundef nonnull %0, ptr noundef %1, ptr noundef %26, ptr noundef nonnull %12)
  br label %33

33:                                               ; preds = %33, %22
  %34 = phi i64 [ 0, %22 ], [ %40, %33 ]
  %35 = phi double [ 0.000000e+00, %22 ], [ %39, %33 ]
  %36 = getelementptr inbounds double, ptr %18, i64 %34
  %37 = load double, ptr %36, align 8
  %38 = fmul double %37, %37
  %39 = fadd double %35, %38
  %40 = add nuw nsw i64 %34, 1
  %41 = icmp eq i64 %40, 6
  br i1 %41, label %42, label %33

42:                                               ; preds = %33
  %43 = mul nsw i64 %24, 6
  %44 = getelementptr double, ptr %9, i64 %43
  %45 = fcmp ugt double %32, %7
  %46 = select i1 %19, i1 %45, i1 false
  br i1 %46, label %47, label %169

47:                                               ; preds = %42
  %48 = load i64, ptr %0, align 8
  br label %49

49:                                               ; preds = %160, %47
  %50 = phi i64 [ %48, %47 ], [ %161, %160 ]
  %51 = phi double [ 1.000000e-02, %47 ], [ %162, %160 ]
  %52 = phi double [ %32, %47 ], [ %163, %160 ]
  %53 = phi i64 [ 0, %47 ], [ %165, %160 ]
  %54 = phi double [ %39, %47 ], [ %164, %160 ]
  %55 = icmp sgt i64 %50, 0
  br i1 %55, label %56, label %60

56:                                               ; preds = %49
  %57 = load ptr, ptr %15, align 8
  br label %58

58:                                               ; preds = %98, %56
  %59 = phi i64 [ 0, %56 ], [ %102, %98 ]
  br label %73

60:                                               ; preds = %98, %49
  %61 = phi i64 [ %50, %49 ], [ %103, %98 ]
  %62 = fmul double %51, %54
  %63 = call fastcc i32 @step(i64 noundef %61, ptr noundef nonnull %12, ptr noundef %10, double noundef %62, double noundef 0x3D06849B86A12B9B, ptr noundef %26, ptr noundef %44)
  %64 = icmp eq i32 %63, 0
  br i1 %64, label %169, label %65

65:                                               ; preds = %60
  %66 = load i64, ptr %0, align 8
  %67 = icmp sgt i64 %66, 0
  br i1 %67, label %118, label %105

68:                                               ; preds = %73
  %69 = load ptr, ptr %20, align 8
  %70 = getelementptr inbounds i8, ptr %69, i64 %59
  %71 = load i8, ptr %70, align 1
  %72 = icmp eq i8 %71, 0
  br i1 %72, label %98, label %84

73:                                               ; preds = %73, %58
  %74 = phi i64 [ 0, %58 ], [ %82, %73 ]
  %75 = phi double [ 0.000000e+00, %58 ], [ %81, %73 ]
  %76 = getelementptr inbounds [6 x double], ptr %57, i64 %59, i64 %74
  %77 = load double, ptr %76, align 8
  %78 = getelementptr inbounds %struct.State, ptr %12, i64 0, i32 3, i64 %74
  %79 = load double, ptr %78, align 8
  %80 = fmul double %77, %79
  %81 = fadd double %75, %80
  %82 = add nuw nsw i64 %74, 1
  %83 = icmp eq i64 %82, 6
  br i1 %83, label %68, label %73

84:                                               ; preds = %68
  %85 = getelementptr inbounds double, ptr %26, i64 %59
  %86 = load double, ptr %85, align 8
  %87 = getelementptr inbounds double, ptr %2, i64 %59
  %88 = load double, ptr %87, align 8
  %89 = fcmp ole double %86, %88
  %90 = fcmp olt double %81, 0.000000e+00
  %91 = select i1 %89, i1 %90, i1 false
  br i1 %91, label %98, label %92

92:                                               ; preds = %84
  %93 = getelementptr inbounds double, ptr %3, i64 %59
  %94 = load double, ptr %93, align 8
  %95 = fcmp oge double %86, %94
  %96 = fcmp ogt double %81, 0.000000e+00
  %97 = select i1 %95, i1 %96, i1 false
  br label %98

98:                                               ; preds = %92, %84, %68
  %99 = phi i1 [ true, %68 ], [ %97, %92 ], [ true, %84 ]
  %100 = zext i1 %99 to i8
  %101 = getelementptr inbounds i8, ptr %10, i64 %59
  store i8 %100, ptr %101, align 1
  %102 = add nuw nsw i64 %59, 1
  %103 = load i64, ptr %0, align 8
  %104 = icmp slt i64 %102, %103
  br i1 %104, label %58, label %60

105:                                              ; preds = %134, %65
  %106 = call fastcc double @look(ptr noundef nonnull %0, ptr noundef %1, ptr noundef %44, ptr noundef nonnull %12)
  br label %107

107:                                              ; preds = %107, %105
  %108 = phi i64 [ 0, %105 ], [ %114, %107 ]
  %109 = phi double [ 0.000000e+00, %105 ], [ %113, %107 ]
  %110 = getelementptr inbounds double, ptr %18, i64 %108
  %111 = load double, ptr %110, align 8
  %112 = fmul double %111, %111
  %113 = fadd double %109, %112
  %114 = add nuw nsw i64 %108, 1
  %115 = icmp eq i64 %114, 6
  br i1 %115, label %116, label %107

116:                                              ; preds = %107
  %117 = fcmp olt double %113, %54
  br i1 %117, label %137, label %155

118:                                              ; preds = %65, %134
  %119 = phi i64 [ %135, %134 ], [ 0, %65 ]
  %120 = getelementptr inbounds i8, ptr %10, i64 %119
  %121 = load i8, ptr %120, align 1
  %122 = icmp eq i8 %121, 0
  br i1 %122, label %123, label %134

123:                                              ; preds = %118
  %124 = getelementptr inbounds double, ptr %44, i64 %119
  %125 = load double, ptr %124, align 8
  %126 = getelementptr inbounds double, ptr %2, i64 %119
  %127 = load double, ptr %126, align 8
  %128 = fcmp ogt double %125, %127
  %129 = select i1 %128, double %125, double %127
  %130 = getelementptr inbounds double, ptr %3, i64 %119
  %131 = load double, ptr %130, align 8
  %132 = fcmp olt double %129, %131
  %133 = select i1 %132, double %129, double %131
  store double %133, ptr %124, align 8
  br label %134

134:                                              ; preds = %123, %118
  %135 = add nuw nsw i64 %119, 1
  %136 = icmp eq i64 %135, %66
  br i1 %136, label %105, label %118

137:                                              ; preds = %116
  %138 = fmul double %54, 0x3FEFF7CED916872B
  %139 = fcmp ule double %113, %138
  %140 = fcmp ule double %51, 1.000000e+03
  %141 = select i1 %139, i1 true, i1 %140
  %142 = load i64, ptr %0, align 8
  %143 = icmp sgt i64 %142, 0
  br i1 %143, label %148, label %144

144:                                              ; preds = %148, %137
  %145 = fmul double %51, 2.500000e-01
  %146 = fcmp ogt double %145, 0x3EB0C6F7A0B5ED8D
  %147 = select i1 %146, double %145, double 0x3EB0C6F7A0B5ED8D
  br i1 %141, label %160, label %169

148:                                              ; preds = %137, %148
  %149 = phi i64 [ %153, %148 ], [ 0, %137 ]
  %150 = getelementptr inbounds double, ptr %44, i64 %149
  %151 = load double, ptr %150, align 8
  %152 = getelementptr inbounds double, ptr %26, i64 %149
  store double %151, ptr %152, align 8
  %153 = add nuw nsw i64 %149, 1
  %154 = icmp eq i64 %153, %142
  br i1 %154, label %144, label %148

155:                                              ; preds = %116
  %156 = fmul double %51, 8.000000e+00
  %157 = call fastcc double @look(ptr noundef nonnull %0, ptr noundef %1, ptr noundef %26, ptr noundef nonnull %12)
  %158 = fcmp ogt double %156, 1.000000e+06
  %159 = load i64, ptr %0, align 8
  br i1 %158, label %169, label %160

160:                                              ; preds = %155, %144
  %161 = phi i64 [ %142, %144 ], [ %159, %155 ]
  %162 = phi double [ %147, %144 ], [ %156, %155 ]
  %163 = phi double [ %106, %144 ], [ %157, %155 ]
  %164 = phi double [ %113, %144 ], [ %54, %155 ]
  %165 = add nuw nsw i64 %53, 1
  %166 = icmp slt i64 %165, %6
  %167 = fcmp ugt double %163, %7
  %168 = select i1 %166, i1 %167, i1 false
  br i1 %168, label %49, label %169

169:                                              ; preds = %60, %144, %155, %160, %42
  %170 = phi double [ %32, %42 ], [ %163, %160 ], [ %52, %60 ], [ %157, %155 ], [ %106, %144 ]
  call void @llvm.lifetime.end.p0(i64 160, ptr nonnull %12) #13
  %171 = getelementptr inbounds double, ptr %8, i64 %23
  store double %170, ptr %171, align 8
  %172 = add nuw nsw i64 %23, 1
  %173 = icmp eq i64 %172, %5
  br i1 %173, label %21, label %22
}

define dso_local i64 @manipplan_are_poses(ptr noundef readonly %0, i64 noundef %1, double noundef %2) local_unnamed_addr #5 {
  %4 = shl nsw i64 %1, 4
  %5 = getelementptr inbounds double, ptr %0, i64 %4
  %6 = icmp slt i64 %1, 1
  br i1 %6, label %105, label %10

7:                                                ; preds = %72
  %8 = getelementptr inbounds double, ptr %11, i64 16
  %9 = icmp ult ptr %8, %5
  br i1 %9, label %10, label %105

10:                                               ; preds = %3, %7
  %11 = phi ptr [ %8, %7 ], [ %0, %3 ]
  br label %15

12:                                               ; preds = %15
  %13 = add nuw nsw i64 %16, 1
  %14 = icmp eq i64 %13, 16
  br i1 %14, label %24, label %15

15:                                               ; preds = %10, %12
  %16 = phi i64 [ 0, %10 ], [ %13, %12 ]
  %17 = getelementptr inbounds double, ptr %11, i64 %16
  %18 = load double, ptr %17, align 8
  %19 = tail call double @llvm.fabs.f64(double %18) #15
  %20 = fcmp ueq double %19, 0x7FF0000000000000
  br i1 %20, label %105, label %12

21:                                               ; preds = %24
  %22 = add nuw nsw i64 %25, 1
  %23 = icmp eq i64 %22, 4
  br i1 %23, label %34, label %24

24:                                               ; preds = %12, %21
  %25 = phi i64 [ %22, %21 ], [ 0, %12 ]
  %26 = add nuw nsw i64 %25, 12
  %27 = getelementptr inbounds double, ptr %11, i64 %26
  %28 = load double, ptr %27, align 8
  %29 = icmp eq i64 %25, 3
  %30 = uitofp i1 %29 to double
  %31 = fsub double %28, %30
  %32 = tail call double @llvm.fabs.f64(double %31)
  %33 = fcmp ogt double %32, %2
  br i1 %33, label %105, label %21

34:                                               ; preds = %21, %68
  %35 = phi i64 [ %70, %68 ], [ 1, %21 ]
  %36 = phi i64 [ %69, %68 ], [ 0, %21 ]
  %37 = getelementptr inbounds double, ptr %11, i64 %36
  %38 = load double, ptr %37, align 8
  %39 = add nuw nsw i64 %36, 4
  %40 = getelementptr inbounds double, ptr %11, i64 %39
  %41 = load double, ptr %40, align 8
  %42 = add nuw nsw i64 %36, 8
  %43 = getelementptr inbounds double, ptr %11, i64 %42
  %44 = load double, ptr %43, align 8
  br label %48

45:                                               ; preds = %48
  %46 = add nuw nsw i64 %49, 1
  %47 = icmp eq i64 %46, %35
  br i1 %47, label %68, label %48

48:                                               ; preds = %34, %45
  %49 = phi i64 [ 0, %34 ], [ %46, %45 ]
  %50 = getelementptr inbounds double, ptr %11, i64 %49
  %51 = load double, ptr %50, align 8
  %52 = fmul double %38, %51
  %53 = add nuw nsw i64 %49, 4
  %54 = getelementptr inbounds double, ptr %11, i64 %53
  %55 = load double, ptr %54, align 8
  %56 = fmul double %41, %55
  %57 = fadd double %52, %56
  %58 = add nuw nsw i64 %49, 8
  %59 = getelementptr inbounds double, ptr %11, i64 %58
  %60 = load double, ptr %59, align 8
  %61 = fmul double %44, %60
  %62 = fadd double %57, %61
  %63 = icmp eq i64 %36, %49
  %64 = uitofp i1 %63 to double
  %65 = fsub double %62, %64
  %66 = tail call double @llvm.fabs.f64(double %65)
  %67 = fcmp olt double %66, %2
  br i1 %67, label %45, label %105

68:                                               ; preds = %45
  %69 = add nuw nsw i64 %36, 1
  %70 = add nuw nsw i64 %35, 1
  %71 = icmp eq i64 %69, 3
  br i1 %71, label %72, label %34

72:                                               ; preds = %68
  %73 = load double, ptr %11, align 8
  %74 = getelementptr inbounds double, ptr %11, i64 1
  %75 = load double, ptr %74, align 8
  %76 = getelementptr inbounds double, ptr %11, i64 2
  %77 = load double, ptr %76, align 8
  %78 = getelementptr inbounds double, ptr %11, i64 4
  %79 = load double, ptr %78, align 8
  %80 = getelementptr inbounds double, ptr %11, i64 5
  %81 = load double, ptr %80, align 8
  %82 = getelementptr inbounds double, ptr %11, i64 6
  %83 = load double, ptr %82, align 8
  %84 = getelementptr inbounds double, ptr %11, i64 8
  %85 = load double, ptr %84, align 8
  %86 = getelementptr inbounds double, ptr %11, i64 9
  %87 = load double, ptr %86, align 8
  %88 = getelementptr inbounds double, ptr %11, i64 10
  %89 = load double, ptr %88, align 8
  %90 = fmul double %75, %83
  %91 = fmul double %77, %81
  %92 = fsub double %90, %91
  %93 = fmul double %77, %79
  %94 = fmul double %73, %83
  %95 = fsub double %93, %94
  %96 = fmul double %73, %81
  %97 = fmul double %75, %79
  %98 = fsub double %96, %97
  %99 = fmul double %85, %92
  %100 = fmul double %95, %87
  %101 = fadd double %99, %100
  %102 = fmul double %98, %89
  %103 = fadd double %101, %102
  %104 = fcmp ugt double %103, 0.000000e+00
  br i1 %104, label %7, label %105

105:                                              ; preds = %72, %7, %15, %24, %48, %3
  %106 = phi i64 [ 1, %3 ], [ 0, %48 ], [ 0, %24 ], [ 0, %15 ], [ 0, %72 ], [ 1, %7 ]
  ret i64 %106
}

declare double @llvm.fabs.f64(double) #6

define dso_local void @manipplan_residuals(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, i64 noundef %3, ptr nocapture noundef %4) local_unnamed_addr #4 {
  %6 = icmp sgt i64 %3, 0
  br i1 %6, label %8, label %7

7:                                                ; preds = %17, %5
  ret void

8:                                                ; preds = %5, %17
  %9 = phi i64 [ %18, %17 ], [ 0, %5 ]
  %10 = shl nsw i64 %9, 4
  %11 = getelementptr inbounds double, ptr %0, i64 %10
  %12 = getelementptr inbounds i64, ptr %2, i64 %9
  %13 = load i64, ptr %12, align 8
  %14 = shl nsw i64 %13, 4
  %15 = getelementptr inbounds double, ptr %1, i64 %14
  %16 = getelementptr inbounds double, ptr %4, i64 %9
  store double 0.000000e+00, ptr %16, align 8
  br label %20

17:                                               ; preds = %20
  %18 = add nuw nsw i64 %9, 1
  %19 = icmp eq i64 %18, %3
  br i1 %19, label %7, label %8

20:                                               ; preds = %8, %20
  %21 = phi i64 [ 0, %8 ], [ %31, %20 ]
  %22 = phi double [ 0.000000e+00, %8 ], [ %30, %20 ]
  %23 = getelementptr inbounds double, ptr %11, i64 %21
  %24 = load double, ptr %23, align 8
  %25 = getelementptr inbounds double, ptr %15, i64 %21
  %26 = load double, ptr %25, align 8
  %27 = fsub double %24, %26
  %28 = tail call double @llvm.fabs.f64(double %27)
  %29 = fcmp ogt double %22, %28
  %30 = select i1 %29, double %22, double %28
  store double %30, ptr %16, align 8
  %31 = add nuw nsw i64 %21, 1
  %32 = icmp eq i64 %31, 12
  br i1 %32, label %17, label %20
}

define dso_local void @manipplan_first_ones(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, i64 noundef %2, i64 noundef %3, double noundef %4, ptr nocapture noundef %5) local_unnamed_addr #4 {
  %7 = icmp sgt i64 %2, 0
  br i1 %7, label %8, label %10

8:                                                ; preds = %6
  %9 = icmp sgt i64 %3, 0
  br label %11

10:                                               ; preds = %31, %6
  ret void

11:                                               ; preds = %8, %31
  %12 = phi i64 [ 0, %8 ], [ %32, %31 ]
  %13 = getelementptr inbounds i8, ptr %5, i64 %12
  store i8 1, ptr %13, align 1
  %14 = icmp eq i64 %12, 0
  br i1 %14, label %31, label %15

15:                                               ; preds = %11
  %16 = getelementptr inbounds i64, ptr %1, i64 %12
  %17 = mul nsw i64 %12, %3
  br label %18

18:                                               ; preds = %15, %52
  %19 = phi i64 [ %12, %15 ], [ %21, %52 ]
  %20 = phi i8 [ 1, %15 ], [ %54, %52 ]
  %21 = add nsw i64 %19, -1
  %22 = getelementptr inbounds i64, ptr %1, i64 %21
  %23 = load i64, ptr %22, align 8
  %24 = load i64, ptr %16, align 8
  %25 = icmp ne i64 %23, %24
  %26 = icmp eq i8 %20, 0
  %27 = select i1 %25, i1 true, i1 %26
  br i1 %27, label %31, label %28

28:                                               ; preds = %18
  br i1 %9, label %29, label %48

29:                                               ; preds = %28
  %30 = mul nsw i64 %21, %3
  br label %37

31:                                               ; preds = %52, %18, %11
  %32 = add nuw nsw i64 %12, 1
  %33 = icmp eq i64 %32, %2
  br i1 %33, label %10, label %11

34:                                               ; preds = %37
  %35 = add nuw nsw i64 %38, 1
  %36 = icmp eq i64 %35, %3
  br i1 %36, label %48, label %37

37:                                               ; preds = %29, %34
  %38 = phi i64 [ 0, %29 ], [ %35, %34 ]
  %39 = add nsw i64 %38, %17
  %40 = getelementptr inbounds double, ptr %0, i64 %39
  %41 = load double, ptr %40, align 8
  %42 = add nsw i64 %38, %30
  %43 = getelementptr inbounds double, ptr %0, i64 %42
  %44 = load double, ptr %43, align 8
  %45 = fsub double %41, %44
  %46 = tail call double @llvm.fabs.f64(double %45)
  %47 = fcmp olt double %46, %4
  br i1 %47, label %34, label %52

48:                                               ; preds = %34, %28
  %49 = getelementptr inbounds i8, ptr %5, i64 %21
  %50 = load i8, ptr %49, align 1
  %51 = icmp eq i8 %50, 0
  br label %52

52:                                               ; preds = %37, %48
  %53 = phi i1 [ %51, %48 ], [ true, %37 ]
  %54 = zext i1 %53 to i8
  store i8 %54, ptr %13, align 1
  %55 = icmp sgt i64 %19, 1
  br i1 %55, label %18, label %31
}

declare void @llvm.memcpy.p0.p0.i64(ptr noalias nocapture writeonly, ptr noalias nocapture readonly, i64, i1 immarg) #7

define internal fastcc void @shift_left(ptr nocapture noundef %0, ptr nocapture noundef readonly byval(%struct.Vector) align 8 %1, ptr nocapture noundef readonly byval(%struct.Vector) align 8 %2, i32 noundef %3, double noundef %4) unnamed_addr #3 {
  %6 = icmp eq i32 %3, 0
  br i1 %6, label %25, label %7

7:                                                ; preds = %5
  %8 = load double, ptr %1, align 8
  %9 = fmul double %8, %4
  %10 = getelementptr inbounds [4 x double], ptr %0, i64 0, i64 3
  %11 = load double, ptr %10, align 8
  %12 = fadd double %11, %9
  store double %12, ptr %10, align 8
  %13 = getelementptr inbounds %struct.Vector, ptr %1, i64 0, i32 1
  %14 = load double, ptr %13, align 8
  %15 = fmul double %14, %4
  %16 = getelementptr inbounds [4 x double], ptr %0, i64 1, i64 3
  %17 = load double, ptr %16, align 8
  %18 = fadd double %17, %15
  store double %18, ptr %16, align 8
  %19 = getelementptr inbounds %struct.Vector, ptr %1, i64 0, i32 2
  %20 = load double, ptr %19, align 8
  %21 = fmul double %20, %4
  %22 = getelementptr inbounds [4 x double], ptr %0, i64 2, i64 3
  %23 = load double, ptr %22, align 8
  %24 = fadd double %23, %21
  store double %24, ptr %22, align 8
  br label %122

25:                                               ; preds = %5
  %26 = tail call double @llvm.cos.f64(double %4)
  %27 = tail call double @llvm.sin.f64(double %4)
  %28 = load double, ptr %1, align 8
  %29 = getelementptr inbounds i8, ptr %1, i64 8
  %30 = load double, ptr %29, align 8
  %31 = getelementptr inbounds i8, ptr %1, i64 16
  %32 = load double, ptr %31, align 8
  %33 = fsub double 1.000000e+00, %26
  br label %82

34:                                               ; preds = %82
  %35 = getelementptr inbounds [4 x double], ptr %0, i64 0, i64 3
  %36 = load double, ptr %35, align 8
  %37 = getelementptr inbounds [4 x double], ptr %0, i64 1, i64 3
  %38 = load double, ptr %37, align 8
  %39 = getelementptr inbounds [4 x double], ptr %0, i64 2, i64 3
  %40 = load double, ptr %39, align 8
  %41 = load double, ptr %2, align 8
  %42 = getelementptr inbounds i8, ptr %2, i64 8
  %43 = load double, ptr %42, align 8
  %44 = getelementptr inbounds i8, ptr %2, i64 16
  %45 = load double, ptr %44, align 8
  %46 = fsub double %36, %41
  %47 = fsub double %38, %43
  %48 = fsub double %40, %45
  %49 = fmul double %46, %28
  %50 = fmul double %47, %30
  %51 = fadd double %49, %50
  %52 = fmul double %48, %32
  %53 = fadd double %51, %52
  %54 = fmul double %33, %53
  %55 = fmul double %48, %30
  %56 = fmul double %47, %32
  %57 = fsub double %55, %56
  %58 = fmul double %46, %32
  %59 = fmul double %28, %48
  %60 = fsub double %58, %59
  %61 = fmul double %47, %28
  %62 = fmul double %46, %30
  %63 = fsub double %61, %62
  %64 = fmul double %26, %46
  %65 = fmul double %27, %57
  %66 = fadd double %64, %65
  %67 = fmul double %28, %54
  %68 = fadd double %67, %66
  %69 = fmul double %26, %47
  %70 = fmul double %27, %60
  %71 = fadd double %69, %70
  %72 = fmul double %30, %54
  %73 = fadd double %72, %71
  %74 = fmul double %26, %48
  %75 = fmul double %27, %63
  %76 = fadd double %74, %75
  %77 = fmul double %32, %54
  %78 = fadd double %76, %77
  %79 = fadd double %41, %68
  %80 = fadd double %43, %73
  %81 = fadd double %45, %78
  store double %79, ptr %35, align 8
  store double %80, ptr %37, align 8
  store double %81, ptr %39, align 8
  br label %122

82:                                               ; preds = %25, %82
  %83 = phi i64 [ 0, %25 ], [ %120, %82 ]
  %84 = getelementptr inbounds [4 x double], ptr %0, i64 0, i64 %83
  %85 = load double, ptr %84, align 8
  %86 = getelementptr inbounds [4 x double], ptr %0, i64 1, i64 %83
  %87 = load double, ptr %86, align 8
  %88 = getelementptr inbounds [4 x double], ptr %0, i64 2, i64 %83
  %89 = load double, ptr %88, align 8
  %90 = fmul double %85, %28
  %91 = fmul double %87, %30
  %92 = fadd double %90, %91
  %93 = fmul double %89, %32
  %94 = fadd double %92, %93
  %95 = fmul double %33, %94
  %96 = fmul double %89, %30
  %97 = fmul double %87, %32
  %98 = fsub double %96, %97
  %99 = fmul double %85, %32
  %100 = fmul double %89, %28
  %101 = fsub double %99, %100
  %102 = fmul double %87, %28
  %103 = fmul double %85, %30
  %104 = fsub double %102, %103
  %105 = fmul double %26, %85
  %106 = fmul double %27, %98
  %107 = fadd double %105, %106
  %108 = fmul double %28, %95
  %109 = fadd double %108, %107
  %110 = fmul double %26, %87
  %111 = fmul double %27, %101
  %112 = fadd double %110, %111
  %113 = fmul double %30, %95
  %114 = fadd double %113, %112
  %115 = fmul double %26, %89
  %116 = fmul double %27, %104
  %117 = fadd double %115, %116
  %118 = fmul double %32, %95
  %119 = fadd double %117, %118
  store double %109, ptr %84, align 8
  store double %114, ptr %86, align 8
  store double %119, ptr %88, align 8
  %120 = add nuw nsw i64 %83, 1
  %121 = icmp eq i64 %120, 3
  br i1 %121, label %34, label %82

122:                                              ; preds = %34, %7
  ret void
}

declare double @llvm.cos.f64(double) #6

declare double @llvm.sin.f64(double) #6

define internal fastcc i64 @orient(ptr nocapture noundef readonly byval(%struct.Vector) align 8 %0, ptr nocapture noundef readonly byval(%struct.Vector) align 8 %1, ptr nocapture noundef readonly byval(%struct.Vector) align 8 %2, ptr nocapture noundef readonly %3, ptr nocapture noundef writeonly %4) unnamed_addr #3 {
  %6 = alloca %struct.Turns, align 8
  %7 = load double, ptr %2, align 8
  %8 = getelementptr inbounds i8, ptr %2, i64 8
  %9 = load double, ptr %8, align 8
  %10 = getelementptr inbounds i8, ptr %2, i64 16
  %11 = load double, ptr %10, align 8
  %12 = load double, ptr %3, align 8
  %13 = fmul double %7, %12
  %14 = getelementptr inbounds [4 x double], ptr %3, i64 0, i64 1
  %15 = load double, ptr %14, align 8
  %16 = fmul double %9, %15
  %17 = fadd double %13, %16
  %18 = getelementptr inbounds [4 x double], ptr %3, i64 0, i64 2
  %19 = load double, ptr %18, align 8
  %20 = fmul double %11, %19
  %21 = fadd double %17, %20
  %22 = getelementptr inbounds [4 x double], ptr %3, i64 1
  %23 = load double, ptr %22, align 8
  %24 = fmul double %7, %23
  %25 = getelementptr inbounds [4 x double], ptr %3, i64 1, i64 1
  %26 = load double, ptr %25, align 8
  %27 = fmul double %9, %26
  %28 = fadd double %24, %27
  %29 = getelementptr inbounds [4 x double], ptr %3, i64 1, i64 2
  %30 = load double, ptr %29, align 8
  %31 = fmul double %11, %30
  %32 = fadd double %28, %31
  %33 = getelementptr inbounds [4 x double], ptr %3, i64 2
  %34 = load double, ptr %33, align 8
  %35 = fmul double %7, %34
  %36 = getelementptr inbounds [4 x double], ptr %3, i64 2, i64 1
  %37 = load double, ptr %36, align 8
  %38 = fmul double %9, %37
  %39 = fadd double %35, %38
  %40 = getelementptr inbounds [4 x double], ptr %3, i64 2, i64 2
  %41 = load double, ptr %40, align 8
  %42 = fmul double %11, %41
  %43 = fadd double %39, %42
  %44 = tail call double @llvm.fabs.f64(double %7)
  %45 = fcmp olt double %44, 6.000000e-01
  %46 = fneg double %11
  %47 = fneg double %7
  %48 = select i1 %45, double %9, double %47
  %49 = select i1 %45, double %46, double 0.000000e+00
  %50 = select i1 %45, double 0.000000e+00, double %11
  %51 = fmul double %50, %50
  %52 = fmul double %49, %49
  %53 = fadd double %52, %51
  %54 = fmul double %48, %48
  %55 = fadd double %54, %53
  %56 = tail call double @llvm.sqrt.f64(double %55)
  %57 = fdiv double %50, %56
  %58 = fdiv double %49, %56
  %59 = fdiv double %48, %56
  %60 = fmul double %12, %57
  %61 = fmul double %15, %58
  %62 = fadd double %60, %61
  %63 = fmul double %19, %59
  %64 = fadd double %63, %62
  %65 = fmul double %23, %57
  %66 = fmul double %26, %58
  %67 = fadd double %65, %66
  %68 = fmul double %59, %30
  %69 = fadd double %68, %67
  %70 = fmul double %57, %34
  %71 = fmul double %58, %37
  %72 = fadd double %70, %71
  %73 = fmul double %59, %41
  %74 = fadd double %72, %73
  call void @llvm.lifetime.start.p0(i64 40, ptr nonnull %6) #13
  %75 = load double, ptr %0, align 8
  %76 = fmul double %21, %75
  %77 = getelementptr inbounds %struct.Vector, ptr %0, i64 0, i32 1
  %78 = load double, ptr %77, align 8
  %79 = fmul double %32, %78
  %80 = fadd double %76, %79
  %81 = getelementptr inbounds %struct.Vector, ptr %0, i64 0, i32 2
  %82 = load double, ptr %81, align 8
  %83 = fmul double %43, %82
  %84 = fadd double %80, %83
  call fastcc void @turns_to_height(ptr nonnull sret(%struct.Turns) align 8 %6, ptr noundef nonnull byval(%struct.Vector) align 8 %1, ptr noundef nonnull byval(%struct.Vector) align 8 %2, ptr noundef nonnull byval(%struct.Vector) align 8 %0, double noundef %84)
  %85 = load i64, ptr %6, align 8
  %86 = icmp sgt i64 %85, 0
  br i1 %86, label %87, label %135

87:                                               ; preds = %5
  %88 = load double, ptr %1, align 8
  %89 = getelementptr inbounds i8, ptr %1, i64 8
  %90 = load double, ptr %89, align 8
  %91 = getelementptr inbounds i8, ptr %1, i64 16
  %92 = load double, ptr %91, align 8
  %93 = fmul double %7, %88
  %94 = fmul double %9, %90
  %95 = fadd double %93, %94
  %96 = fmul double %11, %92
  %97 = fadd double %95, %96
  %98 = fmul double %11, %90
  %99 = fmul double %9, %92
  %100 = fsub double %98, %99
  %101 = fmul double %7, %92
  %102 = fmul double %11, %88
  %103 = fsub double %101, %102
  %104 = fmul double %9, %88
  %105 = fmul double %7, %90
  %106 = fsub double %104, %105
  %107 = fmul double %64, %75
  %108 = fmul double %69, %78
  %109 = fadd double %107, %108
  %110 = fmul double %74, %82
  %111 = fadd double %109, %110
  %112 = fmul double %74, %78
  %113 = fmul double %69, %82
  %114 = fsub double %112, %113
  %115 = fmul double %64, %82
  %116 = fmul double %75, %74
  %117 = fsub double %115, %116
  %118 = fmul double %69, %75
  %119 = fmul double %64, %78
  %120 = fsub double %118, %119
  %121 = fmul double %9, %59
  %122 = fmul double %11, %58
  %123 = fsub double %121, %122
  %124 = fmul double %11, %57
  %125 = fmul double %7, %59
  %126 = fsub double %124, %125
  %127 = fmul double %7, %58
  %128 = fmul double %9, %57
  %129 = fsub double %127, %128
  %130 = fmul double %7, %57
  %131 = fmul double %9, %58
  %132 = fadd double %130, %131
  %133 = fmul double %11, %59
  %134 = fadd double %133, %132
  br label %136

135:                                              ; preds = %136, %5
  call void @llvm.lifetime.end.p0(i64 40, ptr nonnull %6) #13
  ret i64 %85

136:                                              ; preds = %87, %136
  %137 = phi i64 [ 0, %87 ], [ %273, %136 ]
  %138 = getelementptr inbounds %struct.Turns, ptr %6, i64 0, i32 1, i64 %137
  %139 = load double, ptr %138, align 8
  %140 = getelementptr inbounds i8, ptr %138, i64 8
  %141 = load double, ptr %140, align 8
  %142 = fsub double 1.000000e+00, %139
  %143 = fmul double %142, %97
  %144 = fmul double %7, %139
  %145 = fmul double %141, %100
  %146 = fadd double %144, %145
  %147 = fmul double %88, %143
  %148 = fadd double %147, %146
  %149 = fmul double %9, %139
  %150 = fmul double %141, %103
  %151 = fadd double %149, %150
  %152 = fmul double %90, %143
  %153 = fadd double %152, %151
  %154 = fmul double %11, %139
  %155 = fmul double %141, %106
  %156 = fadd double %154, %155
  %157 = fmul double %92, %143
  %158 = fadd double %156, %157
  %159 = fmul double %78, %158
  %160 = fmul double %82, %153
  %161 = fsub double %159, %160
  %162 = fmul double %82, %148
  %163 = fmul double %75, %158
  %164 = fsub double %162, %163
  %165 = fmul double %75, %153
  %166 = fmul double %78, %148
  %167 = fsub double %165, %166
  %168 = fmul double %21, %161
  %169 = fmul double %32, %164
  %170 = fadd double %168, %169
  %171 = fmul double %43, %167
  %172 = fadd double %171, %170
  %173 = fmul double %21, %148
  %174 = fmul double %32, %153
  %175 = fadd double %173, %174
  %176 = fmul double %43, %158
  %177 = fadd double %176, %175
  %178 = fmul double %75, %148
  %179 = fmul double %78, %153
  %180 = fadd double %178, %179
  %181 = fmul double %82, %158
  %182 = fadd double %181, %180
  %183 = fmul double %84, %182
  %184 = fsub double %177, %183
  %185 = fmul double %172, %172
  %186 = fmul double %184, %184
  %187 = fadd double %185, %186
  %188 = tail call double @llvm.sqrt.f64(double %187)
  %189 = fcmp olt double %188, 0x3D06849B86A12B9B
  %190 = fdiv double %184, %188
  %191 = fdiv double %172, %188
  %192 = select i1 %189, double 1.000000e+00, double %190
  %193 = select i1 %189, double 0.000000e+00, double %191
  %194 = fsub double 1.000000e+00, %192
  %195 = fmul double %111, %194
  %196 = fmul double %64, %192
  %197 = fmul double %114, %193
  %198 = fsub double %196, %197
  %199 = fmul double %75, %195
  %200 = fadd double %198, %199
  %201 = fmul double %69, %192
  %202 = fmul double %117, %193
  %203 = fsub double %201, %202
  %204 = fmul double %78, %195
  %205 = fadd double %203, %204
  %206 = fmul double %74, %192
  %207 = fmul double %120, %193
  %208 = fsub double %206, %207
  %209 = fmul double %82, %195
  %210 = fadd double %208, %209
  %211 = fmul double %88, %200
  %212 = fmul double %90, %205
  %213 = fadd double %211, %212
  %214 = fmul double %92, %210
  %215 = fadd double %214, %213
  %216 = fmul double %142, %215
  %217 = fmul double %90, %210
  %218 = fmul double %92, %205
  %219 = fsub double %217, %218
  %220 = fmul double %92, %200
  %221 = fmul double %88, %210
  %222 = fsub double %220, %221
  %223 = fmul double %88, %205
  %224 = fmul double %90, %200
  %225 = fsub double %223, %224
  %226 = fmul double %139, %200
  %227 = fmul double %141, %219
  %228 = fsub double %226, %227
  %229 = fmul double %88, %216
  %230 = fadd double %228, %229
  %231 = fmul double %139, %205
  %232 = fmul double %141, %222
  %233 = fsub double %231, %232
  %234 = fmul double %90, %216
  %235 = fadd double %233, %234
  %236 = fmul double %139, %210
  %237 = fmul double %141, %225
  %238 = fsub double %236, %237
  %239 = fmul double %92, %216
  %240 = fadd double %238, %239
  %241 = getelementptr inbounds [3 x %struct.Turn], ptr %4, i64 %137
  store double %192, ptr %241, align 8
  %242 = getelementptr inbounds i8, ptr %241, i64 8
  store double %193, ptr %242, align 8
  %243 = getelementptr inbounds [3 x %struct.Turn], ptr %4, i64 %137, i64 1
  store double %139, ptr %243, align 8
  %244 = getelementptr inbounds i8, ptr %243, i64 8
  store double %141, ptr %244, align 8
  %245 = getelementptr inbounds [3 x %struct.Turn], ptr %4, i64 %137, i64 2
  %246 = fmul double %123, %230
  %247 = fmul double %126, %235
  %248 = fadd double %246, %247
  %249 = fmul double %129, %240
  %250 = fadd double %249, %248
  %251 = fmul double %57, %230
  %252 = fmul double %58, %235
  %253 = fadd double %251, %252
  %254 = fmul double %59, %240
  %255 = fadd double %254, %253
  %256 = fmul double %7, %230
  %257 = fmul double %9, %235
  %258 = fadd double %256, %257
  %259 = fmul double %11, %240
  %260 = fadd double %259, %258
  %261 = fmul double %134, %260
  %262 = fsub double %255, %261
  %263 = fmul double %250, %250
  %264 = fmul double %262, %262
  %265 = fadd double %263, %264
  %266 = tail call double @llvm.sqrt.f64(double %265)
  %267 = fcmp olt double %266, 0x3D06849B86A12B9B
  %268 = fdiv double %262, %266
  %269 = fdiv double %250, %266
  %270 = select i1 %267, double 1.000000e+00, double %268
  %271 = select i1 %267, double 0.000000e+00, double %269
  store double %270, ptr %245, align 8
  %272 = getelementptr inbounds i8, ptr %245, i64 8
  store double %271, ptr %272, align 8
  %273 = add nuw nsw i64 %137, 1
  %274 = icmp eq i64 %273, %85
  br i1 %274, label %135, label %136
}

define internal fastcc void @two_meeting(ptr noalias nocapture sret(%struct.Turns) align 8 %0, ptr nocapture noundef readonly byval(%struct.Vector) align 8 %1, ptr nocapture noundef readonly byval(%struct.Vector) align 8 %2, ptr nocapture noundef readonly byval(%struct.Vector) align 8 %3, ptr nocapture noundef readonly byval(%struct.Vector) align 8 %4, ptr nocapture noundef writeonly %5) unnamed_addr #3 {
  %7 = load double, ptr %1, align 8
  %8 = load double, ptr %4, align 8
  %9 = fmul double %7, %8
  %10 = getelementptr inbounds %struct.Vector, ptr %1, i64 0, i32 1
  %11 = load double, ptr %10, align 8
  %12 = getelementptr inbounds %struct.Vector, ptr %4, i64 0, i32 1
  %13 = load double, ptr %12, align 8
  %14 = fmul double %11, %13
  %15 = fadd double %9, %14
  %16 = getelementptr inbounds %struct.Vector, ptr %1, i64 0, i32 2
  %17 = load double, ptr %16, align 8
  %18 = getelementptr inbounds %struct.Vector, ptr %4, i64 0, i32 2
  %19 = load double, ptr %18, align 8
  %20 = fmul double %17, %19
  %21 = fadd double %15, %20
  tail call fastcc void @turns_to_height(ptr sret(%struct.Turns) align 8 %0, ptr noundef nonnull byval(%struct.Vector) align 8 %2, ptr noundef nonnull byval(%struct.Vector) align 8 %3, ptr noundef nonnull byval(%struct.Vector) align 8 %1, double noundef %21)
  %22 = load i64, ptr %0, align 8
  %23 = icmp sgt i64 %22, 0
  br i1 %23, label %24, label %49

24:                                               ; preds = %6
  %25 = load double, ptr %3, align 8
  %26 = getelementptr inbounds i8, ptr %3, i64 8
  %27 = load double, ptr %26, align 8
  %28 = getelementptr inbounds i8, ptr %3, i64 16
  %29 = load double, ptr %28, align 8
  %30 = load double, ptr %2, align 8
  %31 = getelementptr inbounds i8, ptr %2, i64 8
  %32 = load double, ptr %31, align 8
  %33 = getelementptr inbounds i8, ptr %2, i64 16
  %34 = load double, ptr %33, align 8
  %35 = fmul double %25, %30
  %36 = fmul double %27, %32
  %37 = fadd double %35, %36
  %38 = fmul double %29, %34
  %39 = fadd double %37, %38
  %40 = fmul double %29, %32
  %41 = fmul double %27, %34
  %42 = fsub double %40, %41
  %43 = fmul double %25, %34
  %44 = fmul double %29, %30
  %45 = fsub double %43, %44
  %46 = fmul double %27, %30
  %47 = fmul double %25, %32
  %48 = fsub double %46, %47
  br label %50

49:                                               ; preds = %50, %6
  ret void

50:                                               ; preds = %24, %50
  %51 = phi i64 [ 0, %24 ], [ %110, %50 ]
  %52 = getelementptr inbounds %struct.Turn, ptr %5, i64 %51
  %53 = getelementptr inbounds %struct.Turns, ptr %0, i64 0, i32 1, i64 %51
  %54 = load double, ptr %53, align 8
  %55 = getelementptr inbounds { double, double }, ptr %53, i64 0, i32 1
  %56 = load double, ptr %55, align 8
  %57 = fsub double 1.000000e+00, %54
  %58 = fmul double %57, %39
  %59 = fmul double %54, %25
  %60 = fmul double %56, %42
  %61 = fadd double %59, %60
  %62 = fmul double %30, %58
  %63 = fadd double %62, %61
  %64 = fmul double %54, %27
  %65 = fmul double %56, %45
  %66 = fadd double %64, %65
  %67 = fmul double %32, %58
  %68 = fadd double %67, %66
  %69 = fmul double %54, %29
  %70 = fmul double %56, %48
  %71 = fadd double %69, %70
  %72 = fmul double %34, %58
  %73 = fadd double %71, %72
  %74 = fmul double %11, %73
  %75 = fmul double %17, %68
  %76 = fsub double %74, %75
  %77 = fmul double %17, %63
  %78 = fmul double %7, %73
  %79 = fsub double %77, %78
  %80 = fmul double %7, %68
  %81 = fmul double %11, %63
  %82 = fsub double %80, %81
  %83 = fmul double %8, %76
  %84 = fmul double %13, %79
  %85 = fadd double %83, %84
  %86 = fmul double %19, %82
  %87 = fadd double %86, %85
  %88 = fmul double %8, %63
  %89 = fmul double %13, %68
  %90 = fadd double %88, %89
  %91 = fmul double %19, %73
  %92 = fadd double %91, %90
  %93 = fmul double %7, %63
  %94 = fmul double %11, %68
  %95 = fadd double %93, %94
  %96 = fmul double %17, %73
  %97 = fadd double %96, %95
  %98 = fmul double %21, %97
  %99 = fsub double %92, %98
  %100 = fmul double %87, %87
  %101 = fmul double %99, %99
  %102 = fadd double %100, %101
  %103 = tail call double @llvm.sqrt.f64(double %102)
  %104 = fcmp olt double %103, 0x3D06849B86A12B9B
  %105 = fdiv double %99, %103
  %106 = fdiv double %87, %103
  %107 = select i1 %104, double 1.000000e+00, double %105
  %108 = select i1 %104, double 0.000000e+00, double %106
  store double %107, ptr %52, align 8
  %109 = getelementptr inbounds i8, ptr %52, i64 8
  store double %108, ptr %109, align 8
  %110 = add nuw nsw i64 %51, 1
  %111 = icmp eq i64 %110, %22
  br i1 %111, label %49, label %50
}

define internal fastcc void @turns_to_height(ptr noalias nocapture writeonly sret(%struct.Turns) align 8 %0, ptr nocapture noundef readonly byval(%struct.Vector) align 8 %1, ptr nocapture noundef readonly byval(%struct.Vector) align 8 %2, ptr nocapture noundef readonly byval(%struct.Vector) align 8 %3, double noundef %4) unnamed_addr #8 {
  %6 = load double, ptr %3, align 8
  %7 = load double, ptr %2, align 8
  %8 = fmul double %6, %7
  %9 = getelementptr inbounds %struct.Vector, ptr %3, i64 0, i32 1
  %10 = load double, ptr %9, align 8
  %11 = getelementptr inbounds %struct.Vector, ptr %2, i64 0, i32 1
  %12 = load double, ptr %11, align 8
  %13 = fmul double %10, %12
  %14 = fadd double %8, %13
  %15 = getelementptr inbounds %struct.Vector, ptr %3, i64 0, i32 2
  %16 = load double, ptr %15, align 8
  %17 = getelementptr inbounds %struct.Vector, ptr %2, i64 0, i32 2
  %18 = load double, ptr %17, align 8
  %19 = fmul double %16, %18
  %20 = fadd double %14, %19
  %21 = load double, ptr %1, align 8
  %22 = fmul double %7, %21
  %23 = getelementptr inbounds %struct.Vector, ptr %1, i64 0, i32 1
  %24 = load double, ptr %23, align 8
  %25 = fmul double %12, %24
  %26 = fadd double %22, %25
  %27 = getelementptr inbounds %struct.Vector, ptr %1, i64 0, i32 2
  %28 = load double, ptr %27, align 8
  %29 = fmul double %18, %28
  %30 = fadd double %26, %29
  %31 = fmul double %6, %21
  %32 = fmul double %10, %24
  %33 = fadd double %31, %32
  %34 = fmul double %16, %28
  %35 = fadd double %33, %34
  %36 = fmul double %30, %35
  %37 = fsub double %20, %36
  %38 = fmul double %18, %24
  %39 = fmul double %12, %28
  %40 = fsub double %38, %39
  %41 = fmul double %7, %28
  %42 = fmul double %21, %18
  %43 = fsub double %41, %42
  %44 = fmul double %21, %12
  %45 = fmul double %7, %24
  %46 = fsub double %44, %45
  %47 = fmul double %6, %40
  %48 = fmul double %10, %43
  %49 = fadd double %47, %48
  %50 = fmul double %16, %46
  %51 = fadd double %50, %49
  %52 = fsub double %4, %36
  %53 = fmul double %37, %37
  %54 = fmul double %51, %51
  %55 = fadd double %53, %54
  %56 = tail call double @llvm.sqrt.f64(double %55)
  %57 = fcmp olt double %56, 0x3D719799812DEA11
  br i1 %57, label %58, label %64

58:                                               ; preds = %5
  %59 = tail call double @llvm.fabs.f64(double %52)
  %60 = fcmp olt double %59, 1.000000e-09
  %61 = zext i1 %60 to i64
  store i64 %61, ptr %0, align 8
  %62 = getelementptr inbounds %struct.Turns, ptr %0, i64 0, i32 1
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %62, ptr noundef nonnull align 8 dereferenceable(16) @still, i64 16, i1 false)
  %63 = getelementptr inbounds %struct.Turns, ptr %0, i64 0, i32 1, i64 1
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %63, ptr noundef nonnull align 8 dereferenceable(16) @still, i64 16, i1 false)
  br label %103

64:                                               ; preds = %5
  %65 = fdiv double %52, %56
  %66 = tail call double @llvm.fabs.f64(double %65)
  %67 = fcmp ugt double %66, 1.001000e+00
  br i1 %67, label %68, label %71

68:                                               ; preds = %64
  store i64 0, ptr %0, align 8
  %69 = getelementptr inbounds %struct.Turns, ptr %0, i64 0, i32 1
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %69, ptr noundef nonnull align 8 dereferenceable(16) @still, i64 16, i1 false)
  %70 = getelementptr inbounds %struct.Turns, ptr %0, i64 0, i32 1, i64 1
  tail call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 8 dereferenceable(16) %70, ptr noundef nonnull align 8 dereferenceable(16) @still, i64 16, i1 false)
  br label %103

71:                                               ; preds = %64
  %72 = fcmp ugt double %66, 1.000000e+00
  br i1 %72, label %78, label %73

73:                                               ; preds = %71
  %74 = fsub double 1.000000e+00, %65
  %75 = fadd double %65, 1.000000e+00
  %76 = fmul double %74, %75
  %77 = tail call double @llvm.sqrt.f64(double %76)
  br label %86

78:                                               ; preds = %71
  %79 = fadd double %66, -1.000000e+00
  %80 = fmul double %79, 2.000000e+00
  %81 = tail call double @llvm.sqrt.f64(double %80)
  %82 = fmul double %81, %81
  %83 = fsub double 1.000000e+00, %82
  %84 = tail call double @llvm.sqrt.f64(double %83)
  %85 = tail call double @llvm.copysign.f64(double %84, double %65)
  br label %86

86:                                               ; preds = %78, %73
  %87 = phi double [ %65, %73 ], [ %85, %78 ]
  %88 = phi double [ %77, %73 ], [ %81, %78 ]
  %89 = fdiv double %37, %56
  %90 = fdiv double %51, %56
  store i64 2, ptr %0, align 8
  %91 = getelementptr inbounds %struct.Turns, ptr %0, i64 0, i32 1
  %92 = fmul double %89, %87
  %93 = fmul double %90, %88
  %94 = fsub double %92, %93
  store double %94, ptr %91, align 8
  %95 = getelementptr inbounds %struct.Turns, ptr %0, i64 0, i32 1, i64 0, i32 1
  %96 = fmul double %90, %87
  %97 = fmul double %89, %88
  %98 = fadd double %96, %97
  store double %98, ptr %95, align 8
  %99 = getelementptr inbounds %struct.Turns, ptr %0, i64 0, i32 1, i64 1
  %100 = fadd double %92, %93
  store double %100, ptr %99, align 8
  %101 = getelementptr inbounds %struct.Turns, ptr %0, i64 0, i32 1, i64 1, i32 1
  %102 = fsub double %96, %97
  store double %102, ptr %101, align 8
  br label %103

103:                                              ; preds = %68, %86, %58
  ret void
}

declare double @llvm.sqrt.f64(double) #6

declare double @llvm.copysign.f64(double, double) #6

declare double @atan2(double noundef, double noundef) local_unnamed_addr #9

declare double @llvm.floor.f64(double) #6

declare double @hypot(double noundef, double noundef) local_unnamed_addr #9

define internal fastcc double @look(ptr nocapture noundef readonly %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, ptr nocapture noundef %3) unnamed_addr #0 {
  %5 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 4
  %6 = load ptr, ptr %5, align 8
  %7 = getelementptr inbounds double, ptr %6, i64 3
  %8 = load double, ptr %7, align 8
  %9 = getelementptr inbounds double, ptr %6, i64 7
  %10 = load double, ptr %9, align 8
  %11 = getelementptr inbounds double, ptr %6, i64 11
  %12 = load double, ptr %11, align 8
  br label %34

13:                                               ; preds = %34
  %14 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 6
  %15 = load i64, ptr %14, align 8
  %16 = icmp sgt i64 %15, 0
  br i1 %16, label %20, label %17

17:                                               ; preds = %13
  %18 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 7
  %19 = load ptr, ptr %18, align 8
  br label %49

20:                                               ; preds = %13
  %21 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 1
  %22 = load ptr, ptr %21, align 8
  %23 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 2
  %24 = load ptr, ptr %23, align 8
  %25 = getelementptr inbounds %struct.State, ptr %3, i64 0, i32 2
  %26 = load ptr, ptr %25, align 8
  %27 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 7
  %28 = load ptr, ptr %27, align 8
  %29 = icmp eq ptr %28, null
  %30 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 8
  %31 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 9
  %32 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 3
  %33 = load ptr, ptr %32, align 8
  br label %65

34:                                               ; preds = %34, %4
  %35 = phi i64 [ 0, %4 ], [ %47, %34 ]
  %36 = getelementptr inbounds double, ptr %6, i64 %35
  %37 = load double, ptr %36, align 8
  %38 = add nuw nsw i64 %35, 4
  %39 = getelementptr inbounds double, ptr %6, i64 %38
  %40 = load double, ptr %39, align 8
  %41 = add nuw nsw i64 %35, 8
  %42 = getelementptr inbounds double, ptr %6, i64 %41
  %43 = load double, ptr %42, align 8
  %44 = getelementptr inbounds [4 x double], ptr %3, i64 0, i64 %35
  store double %37, ptr %44, align 8
  %45 = getelementptr inbounds [4 x double], ptr %3, i64 1, i64 %35
  store double %40, ptr %45, align 8
  %46 = getelementptr inbounds [4 x double], ptr %3, i64 2, i64 %35
  store double %43, ptr %46, align 8
  %47 = add nuw nsw i64 %35, 1
  %48 = icmp eq i64 %47, 3
  br i1 %48, label %13, label %34

49:                                               ; preds = %265, %17
  %50 = phi ptr [ %19, %17 ], [ %28, %265 ]
  %51 = phi double [ %8, %17 ], [ %266, %265 ]
  %52 = phi double [ %10, %17 ], [ %267, %265 ]
  %53 = phi double [ %12, %17 ], [ %268, %265 ]
  %54 = getelementptr inbounds [4 x double], ptr %3, i64 0, i64 3
  store double %51, ptr %54, align 8
  %55 = getelementptr inbounds [4 x double], ptr %3, i64 1, i64 3
  store double %52, ptr %55, align 8
  %56 = getelementptr inbounds [4 x double], ptr %3, i64 2, i64 3
  store double %53, ptr %56, align 8
  %57 = icmp eq ptr %50, null
  br i1 %57, label %271, label %58

58:                                               ; preds = %49
  %59 = load i64, ptr %0, align 8
  %60 = icmp sgt i64 %59, 0
  br i1 %60, label %61, label %270

61:                                               ; preds = %58
  %62 = getelementptr inbounds %struct.State, ptr %3, i64 0, i32 1
  %63 = load ptr, ptr %62, align 8
  %64 = mul nuw i64 %59, 48
  tail call void @llvm.memset.p0.i64(ptr align 8 %63, i8 0, i64 %64, i1 false)
  br label %270

65:                                               ; preds = %265, %20
  %66 = phi i64 [ %15, %20 ], [ %70, %265 ]
  %67 = phi double [ %12, %20 ], [ %268, %265 ]
  %68 = phi double [ %10, %20 ], [ %267, %265 ]
  %69 = phi double [ %8, %20 ], [ %266, %265 ]
  %70 = add nsw i64 %66, -1
  %71 = mul nsw i64 %70, 3
  %72 = getelementptr inbounds double, ptr %22, i64 %71
  %73 = load double, ptr %72, align 8
  %74 = add nsw i64 %71, 1
  %75 = getelementptr inbounds double, ptr %22, i64 %74
  %76 = load double, ptr %75, align 8
  %77 = add nsw i64 %71, 2
  %78 = getelementptr inbounds double, ptr %22, i64 %77
  %79 = load double, ptr %78, align 8
  %80 = getelementptr inbounds double, ptr %24, i64 %71
  %81 = load double, ptr %80, align 8
  %82 = getelementptr inbounds double, ptr %24, i64 %74
  %83 = load double, ptr %82, align 8
  %84 = getelementptr inbounds double, ptr %24, i64 %77
  %85 = load double, ptr %84, align 8
  %86 = getelementptr inbounds [6 x double], ptr %26, i64 %70
  br i1 %29, label %100, label %87

87:                                               ; preds = %65
  %88 = load ptr, ptr %30, align 8
  %89 = getelementptr inbounds double, ptr %88, i64 %70
  %90 = load double, ptr %89, align 8
  %91 = getelementptr inbounds i64, ptr %28, i64 %70
  %92 = load i64, ptr %91, align 8
  %93 = getelementptr inbounds double, ptr %2, i64 %92
  %94 = load double, ptr %93, align 8
  %95 = fmul double %90, %94
  %96 = load ptr, ptr %31, align 8
  %97 = getelementptr inbounds double, ptr %96, i64 %70
  %98 = load double, ptr %97, align 8
  %99 = fadd double %95, %98
  br label %103

100:                                              ; preds = %65
  %101 = getelementptr inbounds double, ptr %2, i64 %70
  %102 = load double, ptr %101, align 8
  br label %103

103:                                              ; preds = %100, %87
  %104 = phi double [ %99, %87 ], [ %102, %100 ]
  %105 = getelementptr inbounds i8, ptr %33, i64 %70
  %106 = load i8, ptr %105, align 1
  %107 = icmp eq i8 %106, 0
  br i1 %107, label %118, label %108

108:                                              ; preds = %103
  %109 = fmul double %73, %104
  %110 = fmul double %76, %104
  %111 = fmul double %79, %104
  %112 = fadd double %69, %109
  %113 = fadd double %68, %110
  %114 = fadd double %67, %111
  store double %73, ptr %86, align 8
  %115 = getelementptr inbounds double, ptr %86, i64 1
  store double %76, ptr %115, align 8
  %116 = getelementptr inbounds double, ptr %86, i64 2
  store double %79, ptr %116, align 8
  %117 = getelementptr inbounds double, ptr %86, i64 3
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(24) %117, i8 0, i64 24, i1 false)
  br label %265

118:                                              ; preds = %103
  %119 = tail call double @llvm.cos.f64(double %104)
  %120 = tail call double @llvm.sin.f64(double %104)
  %121 = fsub double %69, %81
  %122 = fsub double %68, %83
  %123 = fsub double %67, %85
  %124 = fmul double %73, %121
  %125 = fmul double %76, %122
  %126 = fadd double %124, %125
  %127 = fmul double %79, %123
  %128 = fadd double %126, %127
  %129 = fsub double 1.000000e+00, %119
  %130 = fmul double %128, %129
  %131 = fmul double %79, %122
  %132 = fmul double %79, %121
  %133 = fmul double %73, %123
  %134 = fsub double %132, %133
  %135 = fmul double %73, %122
  %136 = fmul double %76, %121
  %137 = fsub double %135, %136
  %138 = fmul double %73, %130
  %139 = fmul double %134, %120
  %140 = fmul double %76, %130
  %141 = fmul double %123, %119
  %142 = fmul double %137, %120
  %143 = fadd double %141, %142
  %144 = fmul double %79, %130
  %145 = fadd double %143, %144
  br label %160

146:                                              ; preds = %160
  %147 = fmul double %76, %123
  %148 = fsub double %147, %131
  %149 = fmul double %148, %120
  %150 = fmul double %122, %119
  %151 = fadd double %150, %139
  %152 = fadd double %151, %140
  %153 = fadd double %83, %152
  %154 = fmul double %121, %119
  %155 = fadd double %154, %149
  %156 = fadd double %155, %138
  %157 = fadd double %81, %156
  %158 = fadd double %85, %145
  %159 = icmp slt i64 %66, %15
  br i1 %159, label %200, label %203

160:                                              ; preds = %160, %118
  %161 = phi i64 [ 0, %118 ], [ %198, %160 ]
  %162 = getelementptr inbounds [4 x double], ptr %3, i64 0, i64 %161
  %163 = load double, ptr %162, align 8
  %164 = getelementptr inbounds [4 x double], ptr %3, i64 1, i64 %161
  %165 = load double, ptr %164, align 8
  %166 = getelementptr inbounds [4 x double], ptr %3, i64 2, i64 %161
  %167 = load double, ptr %166, align 8
  %168 = fmul double %73, %163
  %169 = fmul double %76, %165
  %170 = fadd double %168, %169
  %171 = fmul double %79, %167
  %172 = fadd double %170, %171
  %173 = fmul double %129, %172
  %174 = fmul double %76, %167
  %175 = fmul double %79, %165
  %176 = fsub double %174, %175
  %177 = fmul double %79, %163
  %178 = fmul double %73, %167
  %179 = fsub double %177, %178
  %180 = fmul double %73, %165
  %181 = fmul double %76, %163
  %182 = fsub double %180, %181
  %183 = fmul double %119, %163
  %184 = fmul double %120, %176
  %185 = fadd double %183, %184
  %186 = fmul double %73, %173
  %187 = fadd double %186, %185
  %188 = fmul double %119, %165
  %189 = fmul double %120, %179
  %190 = fadd double %188, %189
  %191 = fmul double %76, %173
  %192 = fadd double %191, %190
  %193 = fmul double %119, %167
  %194 = fmul double %120, %182
  %195 = fadd double %193, %194
  %196 = fmul double %79, %173
  %197 = fadd double %195, %196
  store double %187, ptr %162, align 8
  store double %192, ptr %164, align 8
  store double %197, ptr %166, align 8
  %198 = add nuw nsw i64 %161, 1
  %199 = icmp eq i64 %198, 3
  br i1 %199, label %146, label %160

200:                                              ; preds = %146, %221
  %201 = phi i64 [ %222, %221 ], [ %66, %146 ]
  %202 = getelementptr inbounds [6 x double], ptr %26, i64 %201
  br label %224

203:                                              ; preds = %221, %146
  %204 = fsub double %157, %81
  %205 = fsub double %153, %83
  %206 = fsub double %158, %85
  %207 = fmul double %76, %206
  %208 = fmul double %79, %205
  %209 = fsub double %207, %208
  %210 = fmul double %79, %204
  %211 = fmul double %73, %206
  %212 = fsub double %210, %211
  %213 = fmul double %73, %205
  %214 = fmul double %76, %204
  %215 = fsub double %213, %214
  store double %209, ptr %86, align 8
  %216 = getelementptr inbounds double, ptr %86, i64 1
  store double %212, ptr %216, align 8
  %217 = getelementptr inbounds double, ptr %86, i64 2
  store double %215, ptr %217, align 8
  %218 = getelementptr inbounds double, ptr %86, i64 3
  store double %73, ptr %218, align 8
  %219 = getelementptr inbounds double, ptr %86, i64 4
  store double %76, ptr %219, align 8
  %220 = getelementptr inbounds double, ptr %86, i64 5
  store double %79, ptr %220, align 8
  br label %265

221:                                              ; preds = %224
  %222 = add nsw i64 %201, 1
  %223 = icmp eq i64 %222, %15
  br i1 %223, label %203, label %200

224:                                              ; preds = %224, %200
  %225 = phi i1 [ true, %200 ], [ false, %224 ]
  %226 = phi i64 [ 0, %200 ], [ 3, %224 ]
  %227 = getelementptr inbounds double, ptr %202, i64 %226
  %228 = load double, ptr %227, align 8
  %229 = add nuw nsw i64 %226, 1
  %230 = getelementptr inbounds double, ptr %202, i64 %229
  %231 = load double, ptr %230, align 8
  %232 = add nuw nsw i64 %226, 2
  %233 = getelementptr inbounds double, ptr %202, i64 %232
  %234 = load double, ptr %233, align 8
  %235 = fmul double %73, %228
  %236 = fmul double %76, %231
  %237 = fadd double %235, %236
  %238 = fmul double %79, %234
  %239 = fadd double %237, %238
  %240 = fmul double %129, %239
  %241 = fmul double %76, %234
  %242 = fmul double %79, %231
  %243 = fsub double %241, %242
  %244 = fmul double %79, %228
  %245 = fmul double %73, %234
  %246 = fsub double %244, %245
  %247 = fmul double %73, %231
  %248 = fmul double %76, %228
  %249 = fsub double %247, %248
  %250 = fmul double %119, %228
  %251 = fmul double %120, %243
  %252 = fadd double %250, %251
  %253 = fmul double %73, %240
  %254 = fadd double %253, %252
  %255 = fmul double %119, %231
  %256 = fmul double %120, %246
  %257 = fadd double %255, %256
  %258 = fmul double %76, %240
  %259 = fadd double %258, %257
  %260 = fmul double %119, %234
  %261 = fmul double %120, %249
  %262 = fadd double %260, %261
  %263 = fmul double %79, %240
  %264 = fadd double %262, %263
  store double %254, ptr %227, align 8
  store double %259, ptr %230, align 8
  store double %264, ptr %233, align 8
  br i1 %225, label %224, label %221

265:                                              ; preds = %203, %108
  %266 = phi double [ %157, %203 ], [ %112, %108 ]
  %267 = phi double [ %153, %203 ], [ %113, %108 ]
  %268 = phi double [ %158, %203 ], [ %114, %108 ]
  %269 = icmp sgt i64 %66, 1
  br i1 %269, label %65, label %49

270:                                              ; preds = %61, %58
  br i1 %16, label %272, label %271

271:                                              ; preds = %284, %49, %270
  br label %298

272:                                              ; preds = %270
  %273 = getelementptr inbounds %struct.Screws, ptr %0, i64 0, i32 8
  %274 = load ptr, ptr %273, align 8
  %275 = getelementptr inbounds %struct.State, ptr %3, i64 0, i32 2
  %276 = load ptr, ptr %275, align 8
  %277 = getelementptr inbounds %struct.State, ptr %3, i64 0, i32 1
  %278 = load ptr, ptr %277, align 8
  br label %279

279:                                              ; preds = %284, %272
  %280 = phi i64 [ 0, %272 ], [ %285, %284 ]
  %281 = getelementptr inbounds double, ptr %274, i64 %280
  %282 = getelementptr inbounds i64, ptr %50, i64 %280
  %283 = load i64, ptr %282, align 8
  br label %287

284:                                              ; preds = %287
  %285 = add nuw nsw i64 %280, 1
  %286 = icmp eq i64 %285, %15
  br i1 %286, label %271, label %279

287:                                              ; preds = %287, %279
  %288 = phi i64 [ 0, %279 ], [ %296, %287 ]
  %289 = load double, ptr %281, align 8
  %290 = getelementptr inbounds [6 x double], ptr %276, i64 %280, i64 %288
  %291 = load double, ptr %290, align 8
  %292 = fmul double %289, %291
  %293 = getelementptr inbounds [6 x double], ptr %278, i64 %283, i64 %288
  %294 = load double, ptr %293, align 8
  %295 = fadd double %292, %294
  store double %295, ptr %293, align 8
  %296 = add nuw nsw i64 %288, 1
  %297 = icmp eq i64 %296, 6
  br i1 %297, label %284, label %287

298:                                              ; preds = %271, %298
  %299 = phi i64 [ %308, %298 ], [ 0, %271 ]
  %300 = shl nuw nsw i64 %299, 2
  %301 = or i64 %300, 3
  %302 = getelementptr inbounds double, ptr %1, i64 %301
  %303 = load double, ptr %302, align 8
  %304 = getelementptr inbounds [3 x [4 x double]], ptr %3, i64 0, i64 %299, i64 3
  %305 = load double, ptr %304, align 8
  %306 = fsub double %303, %305
  %307 = getelementptr inbounds %struct.State, ptr %3, i64 0, i32 3, i64 %299
  store double %306, ptr %307, align 8
  %308 = add nuw nsw i64 %299, 1
  %309 = icmp eq i64 %308, 3
  br i1 %309, label %331, label %298

310:                                              ; preds = %331
  %311 = fmul double %366, %366
  %312 = fmul double %367, %367
  %313 = fadd double %312, %311
  %314 = fmul double %368, %368
  %315 = fadd double %314, %313
  %316 = tail call double @llvm.sqrt.f64(double %315)
  %317 = fmul double %316, 5.000000e-01
  %318 = fadd double %356, -1.000000e+00
  %319 = fmul double %318, 5.000000e-01
  %320 = tail call double @atan2(double noundef %317, double noundef %319) #14
  %321 = fcmp ogt double %317, 1.000000e-09
  %322 = fdiv double %320, %317
  %323 = fmul double %322, 5.000000e-01
  %324 = select i1 %321, double %323, double 5.000000e-01
  %325 = fmul double %366, %324
  %326 = fmul double %367, %324
  %327 = fmul double %368, %324
  %328 = getelementptr inbounds %struct.State, ptr %3, i64 0, i32 3, i64 3
  store double %325, ptr %328, align 8
  %329 = getelementptr inbounds %struct.State, ptr %3, i64 0, i32 3, i64 4
  store double %326, ptr %329, align 8
  %330 = getelementptr inbounds %struct.State, ptr %3, i64 0, i32 3, i64 5
  store double %327, ptr %330, align 8
  br label %372

331:                                              ; preds = %298, %331
  %332 = phi double [ %356, %331 ], [ 0.000000e+00, %298 ]
  %333 = phi i64 [ %369, %331 ], [ 0, %298 ]
  %334 = phi double [ %366, %331 ], [ 0.000000e+00, %298 ]
  %335 = phi double [ %367, %331 ], [ 0.000000e+00, %298 ]
  %336 = phi double [ %368, %331 ], [ 0.000000e+00, %298 ]
  %337 = getelementptr inbounds [4 x double], ptr %3, i64 0, i64 %333
  %338 = load double, ptr %337, align 8
  %339 = getelementptr inbounds [4 x double], ptr %3, i64 1, i64 %333
  %340 = load double, ptr %339, align 8
  %341 = getelementptr inbounds [4 x double], ptr %3, i64 2, i64 %333
  %342 = load double, ptr %341, align 8
  %343 = getelementptr inbounds double, ptr %1, i64 %333
  %344 = load double, ptr %343, align 8
  %345 = add nuw nsw i64 %333, 4
  %346 = getelementptr inbounds double, ptr %1, i64 %345
  %347 = load double, ptr %346, align 8
  %348 = add nuw nsw i64 %333, 8
  %349 = getelementptr inbounds double, ptr %1, i64 %348
  %350 = load double, ptr %349, align 8
  %351 = fmul double %338, %344
  %352 = fmul double %340, %347
  %353 = fadd double %351, %352
  %354 = fmul double %342, %350
  %355 = fadd double %353, %354
  %356 = fadd double %332, %355
  %357 = fmul double %340, %350
  %358 = fmul double %342, %347
  %359 = fsub double %357, %358
  %360 = fmul double %342, %344
  %361 = fmul double %338, %350
  %362 = fsub double %360, %361
  %363 = fmul double %338, %347
  %364 = fmul double %340, %344
  %365 = fsub double %363, %364
  %366 = fadd double %334, %359
  %367 = fadd double %335, %362
  %368 = fadd double %336, %365
  %369 = add nuw nsw i64 %333, 1
  %370 = icmp eq i64 %369, 3
  br i1 %370, label %310, label %331

371:                                              ; preds = %372
  ret double %379

372:                                              ; preds = %310, %372
  %373 = phi i64 [ 0, %310 ], [ %380, %372 ]
  %374 = phi double [ 0.000000e+00, %310 ], [ %379, %372 ]
  %375 = getelementptr inbounds %struct.State, ptr %3, i64 0, i32 3, i64 %373
  %376 = load double, ptr %375, align 8
  %377 = tail call double @llvm.fabs.f64(double %376)
  %378 = fcmp ogt double %374, %377
  %379 = select i1 %378, double %374, double %377
  %380 = add nuw nsw i64 %373, 1
  %381 = icmp eq i64 %380, 6
  br i1 %381, label %371, label %372
}

define internal fastcc i32 @step(i64 noundef %0, ptr nocapture noundef readonly %1, ptr nocapture noundef readonly %2, double noundef %3, double noundef %4, ptr nocapture noundef readonly %5, ptr nocapture noundef writeonly %6) unnamed_addr #10 {
  %8 = alloca [6 x [6 x double]], align 16
  %9 = alloca [6 x double], align 16
  %10 = alloca [6 x double], align 16
  call void @llvm.lifetime.start.p0(i64 288, ptr nonnull %8) #13
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 16 dereferenceable(288) %8, i8 0, i64 288, i1 false)
  call void @llvm.lifetime.start.p0(i64 48, ptr nonnull %9) #13
  call void @llvm.lifetime.start.p0(i64 48, ptr nonnull %10) #13
  %11 = icmp sgt i64 %0, 0
  br i1 %11, label %12, label %14

12:                                               ; preds = %7
  %13 = getelementptr inbounds %struct.State, ptr %1, i64 0, i32 1
  br label %16

14:                                               ; preds = %41, %7
  %15 = getelementptr i8, ptr %1, i64 112
  call void @llvm.memcpy.p0.p0.i64(ptr noundef nonnull align 16 dereferenceable(48) %9, ptr noundef nonnull align 8 dereferenceable(48) %15, i64 48, i1 false)
  br label %47

16:                                               ; preds = %12, %41
  %17 = phi i64 [ 0, %12 ], [ %42, %41 ]
  %18 = getelementptr inbounds i8, ptr %2, i64 %17
  %19 = load i8, ptr %18, align 1
  %20 = icmp eq i8 %19, 0
  br i1 %20, label %21, label %41

21:                                               ; preds = %16
  %22 = load ptr, ptr %13, align 8
  %23 = getelementptr inbounds [6 x double], ptr %22, i64 %17
  br label %24

24:                                               ; preds = %21, %28
  %25 = phi i64 [ 0, %21 ], [ %29, %28 ]
  %26 = getelementptr inbounds double, ptr %23, i64 %25
  %27 = load double, ptr %26, align 8
  br label %31

28:                                               ; preds = %31
  %29 = add nuw nsw i64 %25, 1
  %30 = icmp eq i64 %29, 6
  br i1 %30, label %41, label %24

31:                                               ; preds = %24, %31
  %32 = phi i64 [ 0, %24 ], [ %39, %31 ]
  %33 = getelementptr inbounds double, ptr %23, i64 %32
  %34 = load double, ptr %33, align 8
  %35 = fmul double %27, %34
  %36 = getelementptr inbounds [6 x [6 x double]], ptr %8, i64 0, i64 %25, i64 %32
  %37 = load double, ptr %36, align 8
  %38 = fadd double %37, %35
  store double %38, ptr %36, align 8
  %39 = add nuw nsw i64 %32, 1
  %40 = icmp eq i64 %39, 6
  br i1 %40, label %28, label %31

41:                                               ; preds = %28, %16
  %42 = add nuw nsw i64 %17, 1
  %43 = icmp eq i64 %42, %0
  br i1 %43, label %14, label %16

44:                                               ; preds = %47
  %45 = fmul double %52, %4
  %46 = fadd double %45, %3
  br label %147

47:                                               ; preds = %14, %47
  %48 = phi i64 [ 0, %14 ], [ %53, %47 ]
  %49 = phi double [ 0.000000e+00, %14 ], [ %52, %47 ]
  %50 = getelementptr inbounds [6 x [6 x double]], ptr %8, i64 0, i64 %48, i64 %48
  %51 = load double, ptr %50, align 8
  %52 = fadd double %49, %51
  %53 = add nuw nsw i64 %48, 1
  %54 = icmp eq i64 %53, 6
  br i1 %54, label %44, label %47

55:                                               ; preds = %147, %117
  %56 = phi i64 [ %57, %117 ], [ 0, %147 ]
  %57 = add nuw nsw i64 %56, 1
  %58 = icmp eq i64 %56, 5
  br i1 %58, label %59, label %64

59:                                               ; preds = %64, %55
  %60 = phi i64 [ 5, %55 ], [ %74, %64 ]
  %61 = getelementptr inbounds [6 x double], ptr %8, i64 %60, i64 %56
  %62 = load double, ptr %61, align 8
  %63 = fcmp ueq double %62, 0.000000e+00
  br i1 %63, label %178, label %85

64:                                               ; preds = %55, %64
  %65 = phi i64 [ %75, %64 ], [ %57, %55 ]
  %66 = phi i64 [ %74, %64 ], [ %56, %55 ]
  %67 = getelementptr inbounds [6 x double], ptr %8, i64 %65, i64 %56
  %68 = load double, ptr %67, align 8
  %69 = tail call double @llvm.fabs.f64(double %68)
  %70 = getelementptr inbounds [6 x double], ptr %8, i64 %66, i64 %56
  %71 = load double, ptr %70, align 8
  %72 = tail call double @llvm.fabs.f64(double %71)
  %73 = fcmp ogt double %69, %72
  %74 = select i1 %73, i64 %65, i64 %66
  %75 = add nuw nsw i64 %65, 1
  %76 = icmp ult i64 %65, 5
  br i1 %76, label %64, label %59

77:                                               ; preds = %85
  %78 = getelementptr inbounds double, ptr %9, i64 %56
  %79 = load double, ptr %78, align 8
  %80 = getelementptr inbounds double, ptr %9, i64 %60
  %81 = load double, ptr %80, align 8
  store double %81, ptr %78, align 8
  store double %79, ptr %80, align 8
  %82 = icmp ult i64 %56, 5
  br i1 %82, label %83, label %117

83:                                               ; preds = %77
  %84 = getelementptr inbounds [6 x double], ptr %8, i64 %56, i64 %56
  br label %93

85:                                               ; preds = %59, %85
  %86 = phi i64 [ %91, %85 ], [ 0, %59 ]
  %87 = getelementptr inbounds [6 x double], ptr %8, i64 %56, i64 %86
  %88 = load double, ptr %87, align 8
  %89 = getelementptr inbounds [6 x double], ptr %8, i64 %60, i64 %86
  %90 = load double, ptr %89, align 8
  store double %90, ptr %87, align 8
  store double %88, ptr %89, align 8
  %91 = add nuw nsw i64 %86, 1
  %92 = icmp eq i64 %91, 6
  br i1 %92, label %77, label %85

93:                                               ; preds = %99, %83
  %94 = phi i64 [ %57, %83 ], [ %105, %99 ]
  %95 = getelementptr inbounds [6 x double], ptr %8, i64 %94, i64 %56
  %96 = load double, ptr %95, align 8
  %97 = load double, ptr %84, align 8
  %98 = fdiv double %96, %97
  br label %107

99:                                               ; preds = %107
  %100 = load double, ptr %78, align 8
  %101 = fmul double %98, %100
  %102 = getelementptr inbounds double, ptr %9, i64 %94
  %103 = load double, ptr %102, align 8
  %104 = fsub double %103, %101
  store double %104, ptr %102, align 8
  %105 = add nuw nsw i64 %94, 1
  %106 = icmp ult i64 %94, 5
  br i1 %106, label %93, label %117

107:                                              ; preds = %107, %93
  %108 = phi i64 [ %115, %107 ], [ %57, %93 ]
  %109 = getelementptr inbounds [6 x double], ptr %8, i64 %56, i64 %108
  %110 = load double, ptr %109, align 8
  %111 = fmul double %98, %110
  %112 = getelementptr inbounds [6 x double], ptr %8, i64 %94, i64 %108
  %113 = load double, ptr %112, align 8
  %114 = fsub double %113, %111
  store double %114, ptr %112, align 8
  %115 = add nuw nsw i64 %108, 1
  %116 = icmp ult i64 %108, 5
  br i1 %116, label %107, label %99

117:                                              ; preds = %99, %77
  %118 = icmp eq i64 %57, 6
  br i1 %118, label %119, label %55

119:                                              ; preds = %117, %125
  %120 = phi i64 [ %130, %125 ], [ 5, %117 ]
  %121 = getelementptr inbounds double, ptr %9, i64 %120
  %122 = load double, ptr %121, align 8
  %123 = getelementptr inbounds double, ptr %10, i64 %120
  store double %122, ptr %123, align 8
  %124 = icmp ult i64 %120, 5
  br i1 %124, label %136, label %125

125:                                              ; preds = %136, %119
  %126 = phi double [ %122, %119 ], [ %145, %136 ]
  %127 = getelementptr inbounds [6 x double], ptr %8, i64 %120, i64 %120
  %128 = load double, ptr %127, align 8
  %129 = fdiv double %126, %128
  store double %129, ptr %123, align 8
  %130 = add nsw i64 %120, -1
  %131 = icmp eq i64 %120, 0
  br i1 %131, label %132, label %119

132:                                              ; preds = %125
  br i1 %11, label %133, label %178

133:                                              ; preds = %132
  %134 = getelementptr inbounds %struct.State, ptr %1, i64 0, i32 1
  %135 = load ptr, ptr %134, align 8
  br label %154

136:                                              ; preds = %119, %136
  %137 = phi i64 [ %139, %136 ], [ %120, %119 ]
  %138 = phi double [ %145, %136 ], [ %122, %119 ]
  %139 = add nuw nsw i64 %137, 1
  %140 = getelementptr inbounds [6 x double], ptr %8, i64 %120, i64 %139
  %141 = load double, ptr %140, align 8
  %142 = getelementptr inbounds double, ptr %10, i64 %139
  %143 = load double, ptr %142, align 8
  %144 = fmul double %141, %143
  %145 = fsub double %138, %144
  store double %145, ptr %123, align 8
  %146 = icmp eq i64 %139, 5
  br i1 %146, label %125, label %136

147:                                              ; preds = %44, %147
  %148 = phi i64 [ 0, %44 ], [ %152, %147 ]
  %149 = getelementptr inbounds [6 x [6 x double]], ptr %8, i64 0, i64 %148, i64 %148
  %150 = load double, ptr %149, align 8
  %151 = fadd double %46, %150
  store double %151, ptr %149, align 8
  %152 = add nuw nsw i64 %148, 1
  %153 = icmp eq i64 %152, 6
  br i1 %153, label %55, label %147

154:                                              ; preds = %133, %156
  %155 = phi i64 [ 0, %133 ], [ %165, %156 ]
  br label %167

156:                                              ; preds = %167
  %157 = getelementptr inbounds i8, ptr %2, i64 %155
  %158 = load i8, ptr %157, align 1
  %159 = icmp eq i8 %158, 0
  %160 = getelementptr inbounds double, ptr %5, i64 %155
  %161 = load double, ptr %160, align 8
  %162 = select i1 %159, double %175, double -0.000000e+00
  %163 = fadd double %161, %162
  %164 = getelementptr inbounds double, ptr %6, i64 %155
  store double %163, ptr %164, align 8
  %165 = add nuw nsw i64 %155, 1
  %166 = icmp eq i64 %165, %0
  br i1 %166, label %178, label %154

167:                                              ; preds = %154, %167
  %168 = phi i64 [ 0, %154 ], [ %176, %167 ]
  %169 = phi double [ 0.000000e+00, %154 ], [ %175, %167 ]
  %170 = getelementptr inbounds [6 x double], ptr %135, i64 %155, i64 %168
  %171 = load double, ptr %170, align 8
  %172 = getelementptr inbounds [6 x double], ptr %10, i64 0, i64 %168
  %173 = load double, ptr %172, align 8
  %174 = fmul double %171, %173
  %175 = fadd double %169, %174
  %176 = add nuw nsw i64 %168, 1
  %177 = icmp eq i64 %176, 6
  br i1 %177, label %156, label %167

178:                                              ; preds = %59, %156, %132
  %179 = phi i32 [ 1, %132 ], [ 1, %156 ], [ 0, %59 ]
  call void @llvm.lifetime.end.p0(i64 48, ptr nonnull %10) #13
  call void @llvm.lifetime.end.p0(i64 48, ptr nonnull %9) #13
  call void @llvm.lifetime.end.p0(i64 288, ptr nonnull %8) #13
  ret i32 %179
}

declare i32 @llvm.smin.i32(i32, i32) #11


attributes #0 = { nofree nosync nounwind uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #1 = { mustprogress nocallback nofree nosync nounwind willreturn memory(argmem: readwrite) }
attributes #2 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: write) }
attributes #3 = { nofree nosync nounwind memory(argmem: readwrite, inaccessiblemem: readwrite) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #4 = { nofree nosync nounwind memory(argmem: readwrite) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #5 = { nofree nosync nounwind memory(read, inaccessiblemem: readwrite) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #6 = { mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #7 = { mustprogress nocallback nofree nounwind willreturn memory(argmem: readwrite) }
attributes #8 = { mustprogress nofree nosync nounwind willreturn memory(argmem: readwrite, inaccessiblemem: readwrite) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #9 = { mustprogress nofree nosync nounwind willreturn memory(none) "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #10 = { nofree nosync nounwind memory(read, argmem: readwrite, inaccessiblemem: none) uwtable "min-legal-vector-width"="0" "no-trapping-math"="true" "stack-protector-buffer-size"="8"    }
attributes #11 = { nocallback nofree nosync nounwind speculatable willreturn memory(none) }
attributes #12 = { nocallback nofree nosync nounwind willreturn memory(inaccessiblemem: readwrite) }
attributes #13 = { nounwind }
attributes #14 = { nounwind willreturn memory(none) }
attributes #15 = { memory(none) }


