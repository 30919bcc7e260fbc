#!/usr/bin/env bash
# printed_models.sh CAROM CONFIG: three games as .stl and as .3mf, opened again by the libraries of printers' programs,
# admesh and lib3mf: closed, oriented, as large as was told.
. "$(dirname "$0")/../../session.sh"
needs python3 admesh
python3 "$(dirname "$0")/printed_models.py" "$carom" "$out"
