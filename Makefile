# make demo, make test: each does all set-up on a fresh machine; a second run starts in seconds.
PYTHON ?= python3
BIN := .venv/bin
READY := .venv/.ready
OLD := .peers/manipplan-0.1

.PHONY: demo test quick test-all test-long browser ffmpeg egl marching lint types docs links figures pictures kernels fuzz benchmark benchmark-peers benchmark-paths benchmark-convergence clean

demo: $(READY)
	$(BIN)/manipplan demo

test: $(READY) ffmpeg egl
	$(BIN)/python -m pytest

# For work on the code, in less than a minute: the first case of each test that took less than 0.2 s when it ran last.
quick: $(READY)
	$(BIN)/python -m pytest --brief tests/unit

# Adds the slow tests, all examples of the laws, the pages, the studies, the benchmarks and what needs a browser.
test-all: $(READY) browser ffmpeg egl marching
	$(BIN)/python -m pytest -m "not long and not site"

test-long: $(READY)
	$(BIN)/python -m pytest -m long

# Tests drive the interactive planar page, and read films back; without these programs they fail and say the same line.
browser:
	$(call package,command -v chromium || command -v chromium-browser || command -v google-chrome,chromium)

ffmpeg:
	$(call package,command -v ffmpeg,ffmpeg)

# Films are rendered without a display.
egl:
	$(call package,test "$$(uname)" != Linux || /sbin/ldconfig -p | grep -q libEGL.so.1,libegl1 libgl1-mesa-dri)

# Whole runs of the study kth2012 need it; a C compiler builds it.
marching: $(READY)
	@$(BIN)/python -c "import skfmm" 2>/dev/null || $(BIN)/python -m pip install --quiet --disable-pip-version-check scikit-fmm==2025.6.23

# Installs packages $(2) unless the command $(1) succeeds.
define package
@if $(1) >/dev/null 2>&1; then exit 0; fi; \
if [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
  apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $(2) && exit 0; \
fi; \
echo "$(2) was not found; install it with: sudo apt-get install $(2)   (as root: make $@)"
endef

lint: $(READY)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

types: $(READY)
	$(BIN)/mypy

# Builds the site with its gallery, checks every link and picture, and opens its pages in a browser.
docs: $(READY) browser
	rm -rf docs/reference/api
	$(BIN)/python -m sphinx -W --keep-going -q -j auto -b html docs docs/_build/html
	$(BIN)/python docs/check_site.py docs/_build/html
	$(BIN)/python -m pytest -m site tests/docs/test_site.py
	@echo "open docs/_build/html/index.html"

# Links to other sites; needs a network.
links: $(READY)
	$(BIN)/python -m sphinx -q -D plot_gallery=0 -b linkcheck docs docs/_build/links

# Writes the numbers that README and pages state from the tables of docs/benchmarks.
figures: $(READY)
	$(BIN)/python docs/figures.py

# The films of the README, the stills of the examples and the drawings of the concepts; says which look different afterwards.
pictures: $(READY) egl
	$(BIN)/python docs/make_pictures.py
	$(BIN)/python docs/pictures/stills.py
	$(BIN)/python docs/pictures/tutorials.py
	$(BIN)/python docs/pictures/draw.py
	$(BIN)/python docs/pictures/shapes.py
	$(BIN)/python docs/compare_pictures.py

# Builds the kernels again after a change of manipplan/csrc: the library, and their text in LLVM's language for machines without
# a C compiler, which needs clang 16.
KERNELS = $(shell $(BIN)/python -c "from manipplan.support.kernel_library import KERNELS; print(*KERNELS)")
kernels: $(READY)
	$(BIN)/python manipplan/support/kernel_library.py
	set -e; cd manipplan/csrc; for kernel in $(KERNELS); do \
	  echo "; $$kernel $$(cat $$kernel.c $$(ls *.h | LC_ALL=C sort) | sha256sum | cut -d' ' -f1)"; \
	  clang-16 -O2 -fno-unroll-loops -fno-inline-functions -fno-vectorize -fno-slp-vectorize \
	    -ffp-contract=off -fno-math-errno -fno-trapping-math -S -emit-llvm -o - $$kernel.c | sed -E -e '/^(target|source_filename|!|;)|noalias\.scope\.decl/d' \
	    -e 's/"(target|tune)-[a-z]+"="[^"]*"//g' -e 's/, !(tbaa|tbaa\.struct|llvm\.loop|noalias|alias\.scope|prof) ![0-9]+//g'; \
	  done | xz -9e > kernels.ll.xz

# Edited files for every loader, 10,000 each: half an hour. Files at fault are kept in .faults.
fuzz: $(READY)
	$(BIN)/python benchmarks/fuzz_loaders.py --faults .faults

benchmark: $(READY)
	$(BIN)/python benchmarks/panda_boxes.py
	$(BIN)/python benchmarks/panda_pairs.py
	$(BIN)/python benchmarks/kinematics.py
	$(BIN)/python benchmarks/import_time.py
	$(BIN)/python benchmarks/cold_start.py
	$(BIN)/python benchmarks/files_to_read.py
	$(BIN)/python benchmarks/first_models.py
	$(BIN)/python benchmarks/first_plans.py
	$(BIN)/python benchmarks/threads.py
	$(BIN)/python benchmarks/rest.py
	$(BIN)/python benchmarks/killed_saves.py
	$(BIN)/python benchmarks/random_steps.py
	$(BIN)/python benchmarks/control_step.py
	$(BIN)/python benchmarks/servo_step.py
	$(BIN)/python benchmarks/six_joint_arms.py
	$(BIN)/python benchmarks/own_configuration.py
	$(BIN)/python benchmarks/slide_arms.py
	$(BIN)/python benchmarks/rounded_poses.py
	$(BIN)/python benchmarks/pose_paths.py
	$(BIN)/python benchmarks/motionbenchmaker.py --problems 50
	$(BIN)/python benchmarks/motionbenchmaker.py --arm ur5 --problems 50
	$(BIN)/python benchmarks/first_paths.py
	$(BIN)/python benchmarks/plan_many.py
	$(BIN)/python benchmarks/time_limits.py
	$(BIN)/python benchmarks/again.py
	$(BIN)/python benchmarks/check_trajectories.py
	$(BIN)/python benchmarks/pose_goals.py
	$(BIN)/python benchmarks/two_arms.py
	$(BIN)/python benchmarks/level_cup.py
	$(BIN)/python benchmarks/tool_paths.py
	$(BIN)/python benchmarks/constant_speed.py
	$(BIN)/python benchmarks/pose_regions.py
	$(BIN)/python benchmarks/follow_starts.py
	$(BIN)/python benchmarks/lead_ins.py
	$(BIN)/python benchmarks/online_global.py
	$(BIN)/python benchmarks/grid_steps.py
	$(BIN)/python benchmarks/recorded_motions.py
	$(BIN)/python benchmarks/programs.py
	$(BIN)/python benchmarks/blends.py
	$(BIN)/python benchmarks/seeds.py
	$(BIN)/python benchmarks/search.py
	$(BIN)/python benchmarks/timing.py
	$(BIN)/python benchmarks/many_pieces.py
	$(BIN)/python benchmarks/planar_suite.py
	$(BIN)/python benchmarks/collision_shapes.py
	$(BIN)/python benchmarks/file_bombs.py
	$(BIN)/python benchmarks/mesh_readers.py
	$(BIN)/python benchmarks/fixed_bodies.py
	$(BIN)/python benchmarks/mesh_pairs.py
	$(BIN)/python benchmarks/closed_meshes.py
	$(BIN)/python benchmarks/catalogue_arms.py
	$(if $(MUJOCO_MENAGERIE),$(BIN)/python benchmarks/menagerie.py)
	$(BIN)/python benchmarks/gallery.py
	$(BIN)/python benchmarks/documentation.py

benchmark-peers: $(READY)
	$(BIN)/python benchmarks/tracking.py
	$(BIN)/python benchmarks/inverse_kinematics.py
	$(BIN)/python benchmarks/demo_timing.py
	$(BIN)/python benchmarks/motionbenchmaker.py --peers mplib --out docs/benchmarks/motionbenchmaker_mplib.md --picture docs/pictures/motionbenchmaker_mplib.png
	$(BIN)/python benchmarks/timed_motions.py
	$(BIN)/python benchmarks/servo.py
	$(BIN)/python docs/pictures/servo_film.py

benchmark-paths: $(READY)
	$(BIN)/python benchmarks/path_suite.py

# Beside a checkout of version 0.1, which is made first.
benchmark-convergence: $(READY) $(OLD)
	$(BIN)/python benchmarks/convergence.py --old $(OLD)
	$(BIN)/python benchmarks/against_01.py --old $(OLD)
	$(BIN)/python benchmarks/version_01.py --old $(OLD)
	$(BIN)/python benchmarks/collision.py --old $(OLD)

$(OLD):
	git worktree add --detach $(OLD) 6f9afba

$(READY): requirements.txt pyproject.toml
	@$(PYTHON) -c 'import sys; v = sys.version_info[:2]; sys.exit(0 if (3, 11) <= v <= (3, 13) else "manipplan needs Python 3.11 to 3.13, not %d.%d; name another: make PYTHON=python3.12" % v)'
	@echo "setting up .venv: downloads about 500 MB the first time, a few minutes"
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install --quiet --disable-pip-version-check -r requirements.txt
	$(BIN)/python -m pip install --quiet --disable-pip-version-check --no-deps --no-build-isolation --editable .
	@touch $(READY)

clean:
	rm -rf .venv demo docs/_build docs/gallery docs/reference/api .mypy_cache .ruff_cache .pytest_cache
