# The commands that people use; cmake does the work. `make help` lists them.
.DEFAULT_GOAL := build
.PHONY: help build program demo studio install dist test soak bench pictures format clean
JOBS ?= $(shell nproc)
PREFIX ?= /usr/local

help:
	@echo "make build  the program, at build/snug, and the studio, at studio/dist"
	@echo "make studio build both and serve the studio on this machine"
	@echo "make demo   install what is missing, build, and make foams from a sample"
	@echo "make install  the program and the library, into PREFIX ($(PREFIX))"
	@echo "make dist   what is handed to others, in build/dist"
	@echo "make test   install what is missing and run every test"
	@echo "make soak   the long random tests and fuzzing (SOAK_CASES, SOAK_SECONDS or SOAK_RUNS)"
	@echo "make bench  the benchmark"
	@echo "make pictures / make format / make clean"

build: program
	@scripts/install-packages studio
	@scripts/build-studio

program:
	@scripts/install-packages build
	@cmake --preset release --log-level=WARNING >/dev/null
	@cmake --build --preset release -j $(JOBS) --target snug_program

demo: program
	@scripts/demo

studio: build
	@build/snug studio

install: program
	@cmake --build --preset release -j $(JOBS) --target snug_pages
	@cmake --install build --prefix "$(PREFIX)" >/dev/null
	@echo "Snug is installed in $(DESTDIR)$(PREFIX)"

dist: program
	@scripts/install-packages studio dist
	@scripts/dist

test:
	@scripts/install-packages build studio test bench
	@scripts/test

soak:
	@scripts/install-packages build studio dist test soak
	@scripts/soak

bench:
	@scripts/install-packages build studio test bench
	@scripts/bench

pictures: build
	@scripts/install-packages test
	@scripts/pictures

format:
	@git ls-files '*.h' '*.cpp' | xargs clang-format-14 -i

clean:
	@rm -rf build demo
