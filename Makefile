# The front door. Thin on purpose: everything is built by CMake; this only sets up, configures and calls it.
#   make reproduce    from nothing to build/report/index.html
#   make help         the rest

SHELL  := /bin/sh
PRESET ?= release
BUILD  := $(if $(filter dev sanitize,$(PRESET)),build-$(PRESET),build)
SETUP  ?= yes
JOBS   ?= $(shell nproc)

.DEFAULT_GOAL := help
.PHONY: help reproduce test verify bench report phase_map build setup configure clean

help:
	@echo 'make reproduce   everything, from nothing: verification, figures, report; fails if a claim fails'
	@echo 'make test        the test suite'
	@echo 'make verify      the verification programs alone'
	@echo 'make bench       what accuracy costs, measured on this machine'
	@echo 'make figNN       one figure, e.g. make fig05, into $(BUILD)/report/figures'
	@echo 'make report      the report page; runs first whatever is out of date'
	@echo 'make build       the programs, into $(BUILD)/bin'
	@echo 'make setup       install the Debian packages that are missing (tools/packages.txt); done by all of the above'
	@echo 'make clean       remove $(BUILD)'
	@echo 'PRESET=release | ci | dev | sanitize chooses a preset of CMakePresets.json, JOBS=N the number of processes,'
	@echo 'SETUP=no leaves the packages alone.'

setup:
ifneq ($(SETUP),no)
	@tools/setup
endif

# Configures where that has not been done for this preset; later changes of CMake files are seen by the build itself.
configure: setup
	@if [ ! -e $(BUILD)/build.ninja ] || [ "$$(cat $(BUILD)/preset.txt 2>/dev/null)" != '$(PRESET)' ]; then \
	  cmake --preset $(PRESET) && echo '$(PRESET)' > $(BUILD)/preset.txt; \
	fi

build: configure
	@cmake --build $(BUILD) -j $(JOBS)

test: build
	@ctest --test-dir $(BUILD) -j $(JOBS) --output-on-failure --no-tests=error

# Not the tests: they have their own command, and the report does not need them.
reproduce: configure
	@cmake --build $(BUILD) -j $(JOBS) --target contensou_program reproduce

verify bench report phase_map: configure
	@cmake --build $(BUILD) -j $(JOBS) --target $@

fig%: configure
	@cmake --build $(BUILD) -j $(JOBS) --target $@

clean:
	rm -rf $(BUILD)
