# Draws the curves of a folder of figures; says what is missing where Python's packages are not there.
if(NOT EXISTS "${PYTHON}")
    message(STATUS "no curves: ${PYTHON} is missing; ./setup.sh makes it. Their numbers are in ${FIGURES}/*.csv")
    return()
endif()
execute_process(COMMAND "${PYTHON}" "${CMAKE_CURRENT_LIST_DIR}/curves.py" "${FIGURES}"
    COMMAND_ERROR_IS_FATAL ANY)
