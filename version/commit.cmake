# cmake -D SOURCE=<dir> -D TEMPLATE=<file> -D OUTPUT=<file> -P commit.cmake
# The commit that is being built, "unknown" without git or outside the project's own repository (an
# unpacked archive inside somebody else's, say). The file is touched only when it changes.
set(COMMIT "unknown")
find_program(GIT git)
if(GIT)
    set(ENV{GIT_OPTIONAL_LOCKS} 0)
    # The folder may belong to another user (a container's volume); only reading is asked for.
    file(REAL_PATH "${SOURCE}" source)
    set(git "${GIT}" -c "safe.directory=${source}" -C "${source}")
    execute_process(COMMAND ${git} rev-parse --show-toplevel
        OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(top STREQUAL source)
        execute_process(COMMAND ${git} describe --always --dirty --abbrev=12 --exclude=*
            OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
            RESULT_VARIABLE failed)
        if(NOT failed)
            set(COMMIT "${described}")
        endif()
    endif()
endif()
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
