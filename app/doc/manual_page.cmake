# The manual page OUT is the text IN with the commands that PROGRAM has.
execute_process(COMMAND ${PROGRAM} help --manual OUTPUT_VARIABLE COMMANDS COMMAND_ERROR_IS_FATAL ANY)
configure_file(${IN} ${OUT} @ONLY)
