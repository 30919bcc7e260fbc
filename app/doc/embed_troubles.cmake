# cmake -DIN=operators.md -DOUT=trouble_text.h -P embed_troubles.cmake: the page's part on messages and troubles as a C++
# string constant, so that `carom help` finds it wherever the program runs.
file(READ "${IN}" text)
string(FIND "${text}" "## When something goes wrong" begin)
if(begin LESS 0)
  message(FATAL_ERROR "${IN} has no part 'When something goes wrong'")
endif()
string(SUBSTRING "${text}" ${begin} -1 text)
string(REGEX REPLACE "\n## [^W].*" "\n" text "${text}")
file(WRITE "${OUT}.new" "#pragma once\nnamespace carom {\ninline constexpr char kTroubleText[] = R\"page(${text})page\";\n}\n")
file(RENAME "${OUT}.new" "${OUT}")
