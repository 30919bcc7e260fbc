# Debian packages of the program and of the engine, by the target `deb`; also `cmake --install build/release`.
include(GNUInstallDirs)

# Installing builds nothing: it takes the files that are there, which need not include the tests.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

# The program finds share/carom relative to its own place (app/toml/config_folder.h).
install(TARGETS carom COMPONENT program DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY config/ COMPONENT program DESTINATION ${CMAKE_INSTALL_DATADIR}/carom
  PATTERN build EXCLUDE PATTERN install-packages EXCLUDE PATTERN "packages*.txt" EXCLUDE PATTERN "*.cmake" EXCLUDE
  PATTERN "*.schema.json" EXCLUDE
  PATTERN udev EXCLUDE PATTERN desktop EXCLUDE PATTERN systemd EXCLUDE)
install(FILES config/udev/70-carom.rules COMPONENT program DESTINATION lib/udev/rules.d)
install(FILES config/desktop/carom.desktop COMPONENT program DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES config/systemd/carom.service config/systemd/carom-room.service COMPONENT program DESTINATION lib/systemd/user)
install(FILES ${PROJECT_BINARY_DIR}/app/doc/carom.1.gz COMPONENT program DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
# The pages keep their places relative to each other, so that their links remain valid.
install(FILES README.md CONTRIBUTING.md CHANGELOG.md COMPONENT program DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY app/pictures app/doc COMPONENT program DESTINATION ${CMAKE_INSTALL_DOCDIR}/app
  FILES_MATCHING PATTERN "*.md" PATTERN "*.html" PATTERN "*.png" PATTERN "*.svg")
install(FILES LICENSE COMPONENT program DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES LICENSE COMPONENT engine DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libcarom-dev RENAME copyright)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME carom)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "billiards where light is slow, in a CAVE")
set(CPACK_PACKAGE_CONTACT "The Carom authors <carom@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL program engine)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME carom)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION
  "Pucks move at nearly the speed of a light of 1.4 m/s, and a person with a
 tracked head, in a room of stereo walls, sees them as special relativity says.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
# The font of charts; and orted, without which MPI does not start even for a single process.
set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "fonts-dejavu-core, openmpi-bin")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "ffmpeg, libgl1-mesa-dri, libopenxr-loader1")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS "fxload, r-base-core, r-cran-lme4, sqlite3, xvfb")

set(CPACK_DEBIAN_ENGINE_PACKAGE_NAME libcarom-dev)
set(CPACK_DEBIAN_ENGINE_PACKAGE_SECTION libdevel)
set(CPACK_COMPONENT_ENGINE_DESCRIPTION
  "The engine alone: world lines, light cones and collisions of special relativity;
 a static library and its headers, found by CMake as carom::engine.")
set(CPACK_DEBIAN_ENGINE_PACKAGE_DEPENDS "libglm-dev")
include(CPack)

add_custom_target(deb COMMAND ${CMAKE_CPACK_COMMAND} WORKING_DIRECTORY ${CMAKE_BINARY_DIR} USES_TERMINAL)
add_dependencies(deb carom man schemas)
