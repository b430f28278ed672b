# omniproof: `make` sets up and builds, `make test` checks. `make help` lists the rest.

PYTHON ?= python3
VENV := .venv
INSTALL := uv pip install --quiet --compile-bytecode --require-hashes --requirement
LOCK := uv pip compile --quiet --upgrade --universal --generate-hashes --no-header --python-version 3.11

export VIRTUAL_ENV := $(if $(filter /%,$(VENV)),,$(CURDIR)/)$(VENV)
export PATH := $(VIRTUAL_ENV)/bin:$(PATH)
export PIP_DISABLE_PIP_VERSION_CHECK := 1
# Modules that are compiled anew in every process cost more than most steps.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: build test test-slow bench lock clean help

build: $(VENV)/ready
	@snakemake
	@cat results/summary.txt

# A process that has run out of tests takes half of another's: neighbours, which share their fixtures,
# mostly stay together, and no long file is left for the end.
test: $(VENV)/ready-to-test
	@ruff check
	@ruff format --check --quiet
	@snakefmt --check Snakefile workflow/rules
	@mypy
	@snakemake --lint
	@pytest --numprocesses auto --dist worksteal

bench: $(VENV)/ready-to-test
	@python tests/corpus/bench.py results/benchmarks
	@python -m omniproof.simulation.sensitivity results/benchmarks/simulation/sensitivity.csv

test-slow: $(VENV)/ready-to-test
	@pytest --numprocesses auto -m slow

lock: $(VENV)/ready
	@for name in requirements-setup requirements requirements-test; do \
	    echo "$$name.lock"; $(LOCK) $$name.in --output-file $$name.lock || exit 1; \
	done
	@echo requirements-engines.lock
	@$(LOCK) --no-deps requirements-engines.in --output-file requirements-engines.lock

clean:
	rm -rf results logs book/_build .snakemake

help:
	@echo "make        set up .venv if needed, then build results and report"
	@echo "make test   lint, types and tests"
	@echo "make bench  compare with other systems, vary the simulation, to results/benchmarks (minutes)"
	@echo "make test-slow  the long studies: all planted misprints, long fuzzing (minutes)"
	@echo "make lock   resolve requirements*.in anew into requirements*.lock"
	@echo "make clean  remove what was built (.venv stays)"

LOCKS := requirements-setup.lock requirements.lock requirements-engines.lock pyproject.toml

# One set-up at a time, even after a `make` that was killed: whoever had to wait looks again what is left to do.
ifndef ALONE
$(VENV)/ready: $(LOCKS)
$(VENV)/ready-to-test: $(VENV)/ready requirements-test.lock
$(VENV)/ready $(VENV)/ready-to-test:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { \
	    echo "omniproof needs Python 3.11 or newer; '$(PYTHON)' is `$(PYTHON) --version 2>&1`." \
	        "Name another one, such as: make PYTHON=python3.12" >&2; exit 1; }
	@$(PYTHON) -P workflow/omniproof/lock.py $(MAKE) --no-print-directory ALONE=yes $@
else
# The environment, from scratch whenever a lock file changes or the last set-up did not end. uv installs it three
# times faster than pip; where uv cannot (a package mirror that only pip knows of), pip installs the same file.
$(VENV)/ready: $(LOCKS)
	@echo "Setting up $(VENV)"
	@$(PYTHON) -m venv --clear $(VENV)
	@pip install --quiet --require-hashes --requirement requirements-setup.lock
	@$(INSTALL) requirements.lock || pip install --quiet --require-hashes --requirement requirements.lock
	@$(INSTALL) requirements-engines.lock --no-deps || pip install --quiet --no-deps --require-hashes \
	    --requirement requirements-engines.lock || \
	    echo "There is no package of Drake for this platform; what it would run is left out."
	@uv pip install --quiet --no-deps --no-build-isolation --editable .
	@touch $@

# Half the test tools make no environment: it is ready again when they all are there.
$(VENV)/ready-to-test: $(VENV)/ready requirements-test.lock
	@echo "Setting up the test tools"
	@rm $(VENV)/ready
	@$(INSTALL) requirements-test.lock || pip install --quiet --require-hashes --requirement requirements-test.lock
	@touch $(VENV)/ready $@
endif
