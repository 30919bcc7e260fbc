#!/usr/bin/env bash
# analyse_test.sh ANALYSE TESTS [SETS]: the analysis of studies in R (analyse_test.R), with SETS made-up sets a kind, 20 if it is left out.
set -euo pipefail
command -v Rscript >/dev/null || { echo "skipped: R is not installed (r-base-core)"; exit 77; }
Rscript --vanilla -e "quit(status = if (requireNamespace('lme4', quietly = TRUE)) 0 else 1)" ||
  { echo "skipped: lme4 is not installed (r-cran-lme4)"; exit 77; }
exec Rscript --vanilla "$2/analyse_test.R" "$1" "$2/made_up.R" "${3:-20}"
