# One place for every command. `make` alone lists them.

.PHONY: help run generate test python wheel bench peers soak book dist sbom fmt lint

help:
	@echo "make run      a simulated cell with its panel: open the address that it prints"
	@echo "make generate what the panel's type check, its tests and editors need, and the build does not: web/generated/"
	@echo "make test     format, lints, all tests; prints how many passed"
	@echo "make python   the tests of the Python package; part of make test"
	@echo "make wheel    the Python package for pip: target/wheels; its tests run against the installed wheel"
	@echo "make bench    speed and memory of this build on this machine"
	@echo "make peers    compare with other programs (LinuxCNC); installs what is missing, needs root"
	@echo "make soak     the property tests with a hundred times the cases; ten minutes of many who watch the panel; every reader is fuzzed, SEAMWRIGHT_FUZZ_S seconds each (60)"
	@echo "make book     the documentation as a book with offline search: target/book/index.html"
	@echo "make dist     the program for packages, optimised across crates and stripped, with its licences and bill of materials: target/dist"
	@echo "make sbom     the bill of materials alone, CycloneDX 1.6: target/seamwright.cdx.json"
	@echo "make fmt      format the sources"
	@echo "make lint     clippy with warnings as errors, spelling, words to avoid, rules for third-party packages"

run:
	cargo run --release

generate:
	scripts/generate

test:
	scripts/test

python:
	scripts/python

wheel:
	scripts/python wheel

bench:
	scripts/bench

peers:
	peers/run

soak:
	SEAMWRIGHT_SOAK=100 PROPTEST_CASES=25600 cargo test --release --workspace -- --include-ignored
	scripts/fuzz all $${SEAMWRIGHT_FUZZ_S:-60}

book:
	scripts/book

dist:
	scripts/dist

sbom:
	mkdir -p target
	cargo run --release -- licences --sbom >target/seamwright.cdx.json

fmt:
	cargo fmt --all

lint:
	cargo clippy --workspace --all-targets -- -D warnings
	scripts/language
	scripts/supply-chain
