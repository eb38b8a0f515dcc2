# The two commands of the README are `make reproduce` and `make test`.
SHELL := /bin/bash
.SHELLFLAGS := -eu -o pipefail -c
.DELETE_ON_ERROR:
.DEFAULT_GOAL := help

# One thread a process: runs are spread over the cores as processes, and bytes stay the same.
export OMP_NUM_THREADS := 1
export OPENBLAS_NUM_THREADS := 1
# Any value of CI switches the rerun viewer's analytics off.
export CI ?= true
# Without cached bytecode every snakemake job would compile its imports anew.
unexport PYTHONDONTWRITEBYTECODE

PYTHON ?= python3
NEWEST ?= $(PYTHON)
COVERED := coupling dynamics fem fluid stability analysis
COVERING := $(COVERED) paper piston external transient
# One more than the cores, since many tests wait for what they start.
WORKERS ?= $(shell n=$$(getconf _NPROCESSORS_ONLN); echo $$((n < 8 ? n + 1 : 8)))
VENV := .venv
BIN := $(VENV)/bin
UV_VERSION := 0.13.9
INDEX := $(shell $(PYTHON) -m pip config get global.index-url 2>/dev/null || true)
WITH_INDEX := $(if $(INDEX),UV_DEFAULT_INDEX=$(INDEX))

.PHONY: help environment reproduce test types suite test-fuzz test-faults test-report test-slurm docs test-coverage test-newest test-mutants format lock benchmark clean

help:  ## list the commands
	@sed -nE 's/^([a-z-]+):.*## (.*)/  make \1@\2/p' Makefile | column -t -s@

environment: $(VENV)/.ready  ## create .venv/ from requirements.lock

$(VENV)/.ready: requirements.lock pyproject.toml workflows/system_libraries.py
	$(PYTHON) -c 'import sys; sys.version_info >= (3, 11) or sys.exit("squat needs Python >= 3.11, this is " + sys.version.split()[0] + ": set PYTHON=")'
	$(PYTHON) workflows/system_libraries.py
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --disable-pip-version-check uv==$(UV_VERSION)
	$(WITH_INDEX) $(BIN)/uv pip install --quiet --python $(BIN)/python --require-hashes -r requirements.lock
	$(BIN)/uv pip install --quiet --python $(BIN)/python --no-deps --no-build-isolation -e .
	touch $@

reproduce: environment  ## reproduce the paper: every table, figure and the report in results/
	PATH="$(CURDIR)/$(BIN):$$PATH" python workflows/unlock.py
	PATH="$(CURDIR)/$(BIN):$$PATH" snakemake all

test: environment  ## formatter, linter, types, architecture and all tests
	$(BIN)/ruff format --check .
	$(BIN)/ruff check .
	$(BIN)/snakefmt --check Snakefile workflows/rules
	$(BIN)/lint-imports
	$(MAKE) --no-print-directory --jobs=2 types suite

types: environment  # one process for half a minute: beside the tests
	$(BIN)/mypy

suite: environment
	PATH="$(CURDIR)/$(BIN):$$PATH" pytest -n $(WORKERS) --dist loadscope

test-fuzz: environment  ## 10,000 generated bad inputs, and damaged files
	SQUAT_FUZZ=10000 $(BIN)/pytest tests/fuzz

test-faults: environment  ## 100 kills of the graph, full disks, read-only folders, clocks moved back
	PATH="$(CURDIR)/$(BIN):$$PATH" SQUAT_KILLS=100 pytest tests/faults

test-report: environment  ## results/report.html in headless Chromium
	$(BIN)/pytest tests/report -m browser

test-slurm: environment  ## the graph and a sweep on a real SLURM of two nodes on this machine (root)
	PATH="$(CURDIR)/$(BIN):$$PATH" pytest tests/slurm -m slurm -p no:xdist

docs: environment  ## build the pages of docs/ in build/docs/index.html
	$(BIN)/sphinx-build -W --keep-going -q -b html docs build/docs

test-coverage: environment  ## branch coverage of the rooms that carry the numbers, at least 95 %
	PATH="$(CURDIR)/$(BIN):$$PATH" pytest -n $(WORKERS) --dist loadscope $(COVERING:%=tests/%) $(COVERED:%=--cov=squat.%) --cov-branch \
	    --cov-report=term-missing:skip-covered --cov-fail-under=95

test-newest: environment  ## all tests with the newest version of everything, in .venv-newest/; NEWEST=python3.13
	$(BIN)/uv venv --quiet --clear --python $(NEWEST) .venv-newest
	$(WITH_INDEX) $(BIN)/uv pip install --quiet --python .venv-newest/bin/python --upgrade --group dev -e .
	PATH="$(CURDIR)/.venv-newest/bin:$$PATH" pytest -n $(WORKERS) --dist loadscope

test-mutants: environment  ## change the code in small ways: does a test notice? an hour; goes on if killed
	$(BIN)/python -m workflows.mutants

format: environment  ## rewrite the code in the house format
	$(BIN)/ruff format .
	$(BIN)/ruff check --fix .
	$(BIN)/snakefmt Snakefile workflows/rules

lock: environment  ## resolve requirements.lock anew
	$(WITH_INDEX) $(BIN)/uv pip compile pyproject.toml --group dev --universal --python-version 3.11 \
	    --generate-hashes --no-emit-index-url --no-header --no-annotate --upgrade -o requirements.lock

benchmark: environment  ## timings as ratios within one run
	$(BIN)/pytest benchmarks -q -o addopts="" -p no:xdist

clean:  ## remove what the runs and the tools wrote; keeps .venv
	rm -rf results/*/ results/report.html multirun .snakemake .pytest_cache .mypy_cache .ruff_cache .hypothesis .benchmarks
