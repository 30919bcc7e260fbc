# The engine as WebAssembly, for pages in a browser: compiled from the same sources by clang and wasi-libc (Debian's packages,
# config/packages-page.txt). carom_page_engine(OUT) makes OUT, the module compressed and written as letters; without the
# compiler CAROM_BROWSER is off, and nothing is made.
find_program(CAROM_WASM_CLANG clang++-19)
find_program(CAROM_WASM_LINK wasm-ld-19)
set(CAROM_WASI /usr/lib/wasm32-wasi)
file(GLOB CAROM_WASM_BUILTINS /usr/lib/llvm-19/lib/clang/19/lib/wasi/libclang_rt.builtins-wasm32.a)
set(found OFF)
option(CAROM_BROWSER "Compile the engine for browsers, too, where their compiler is found: carom page" ON)
if(CAROM_WASM_CLANG AND CAROM_WASM_LINK AND CAROM_WASM_BUILTINS AND EXISTS ${CAROM_WASI}/crt1-reactor.o
   AND EXISTS ${CAROM_WASI}/libc++.a)
  set(found ON)
endif()
# Not in the cache, so that it is found once it is installed.
if(CAROM_BROWSER AND NOT found)
  message(STATUS "No compiler for browsers: config/install-packages page installs it. carom page will make no pages.")
  set(CAROM_BROWSER OFF)
endif()

function(carom_page_engine out)
  file(GLOB sources CONFIGURE_DEPENDS
    ${PROJECT_SOURCE_DIR}/app/page/engine/*.cpp ${PROJECT_SOURCE_DIR}/engine/base/portable_math.cpp
    ${PROJECT_SOURCE_DIR}/engine/spacetime/*.cpp ${PROJECT_SOURCE_DIR}/engine/light/*.cpp
    ${PROJECT_SOURCE_DIR}/engine/colour/*.cpp ${PROJECT_SOURCE_DIR}/engine/collision/*.cpp
    ${PROJECT_SOURCE_DIR}/engine/polygons/*.cpp ${PROJECT_SOURCE_DIR}/engine/soft/*.cpp
    ${PROJECT_SOURCE_DIR}/engine/game/*.cpp ${PROJECT_SOURCE_DIR}/engine/impact/*.cpp ${PROJECT_SOURCE_DIR}/engine/billiard/*.cpp)
  # page_runtime.cpp has what stands in for these.
  list(FILTER sources EXCLUDE REGEX "/engine/billiard/soft_(game|ahead)\\.cpp$")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/wasm)
  # With GLM alone: the system's other headers are for another machine.
  find_path(CAROM_GLM glm/glm.hpp)
  file(MAKE_DIRECTORY ${folder}/include)
  file(CREATE_LINK ${CAROM_GLM}/glm ${folder}/include/glm SYMBOLIC)
  set(launcher)
  if(CCACHE)
    set(launcher ${CCACHE})
  endif()
  set(objects)
  foreach(source ${sources})
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${source})
    string(REPLACE "/" "_" name ${name})
    set(object ${folder}/${name}.o)
    add_custom_command(OUTPUT ${object}
      COMMAND ${launcher} ${CAROM_WASM_CLANG} --target=wasm32-wasi -std=c++20 -Os -ffp-contract=off -fignore-exceptions -DNDEBUG
              -I ${folder}/include -I ${PROJECT_SOURCE_DIR} -MMD -MF ${object}.d -c ${source} -o ${object}
      DEPENDS ${source} DEPFILE ${object}.d VERBATIM)
    list(APPEND objects ${object})
  endforeach()
  add_custom_command(OUTPUT ${folder}/engine.wasm ${out}
    COMMAND ${CAROM_WASM_LINK} ${CAROM_WASI}/crt1-reactor.o ${objects} -L${CAROM_WASI} -lc++ -lc++abi -lc -lm
            ${CAROM_WASM_BUILTINS} --gc-sections --strip-all --entry=_initialize -o ${folder}/engine.wasm
    COMMAND gzip -9nc ${folder}/engine.wasm > ${folder}/engine.wasm.gz
    COMMAND base64 -w0 ${folder}/engine.wasm.gz > ${out}
    DEPENDS ${objects} VERBATIM)
endfunction()
