# cmake -DIN=file.glsl -DOUT=file.h -DNAME=name -DSPACE=shaders -P embed_shader.cmake: a text as a C++ string constant of this
# namespace.
file(READ "${IN}" text)
file(WRITE "${OUT}.new" "#pragma once\nnamespace carom::${SPACE} {\ninline constexpr char ${NAME}[] = R\"glsl(${text})glsl\";\n}\n")
file(RENAME "${OUT}.new" "${OUT}")
