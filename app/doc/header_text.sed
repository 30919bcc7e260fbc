#!/bin/sed -f
# For Doxygen: the text that follows a header's #pragma once becomes that file's description, laid out as it is.
1s/.*/\/*! \\file/
2,/^$/ {
  s/^$/\\endverbatim *\//
  2s/^\/\//\\verbatim/
  s/^\/\/ \{0,1\}//
}
