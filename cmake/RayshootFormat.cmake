# Targets `format` and `format_check`: every own source and header, by .clang-format.
find_program(RAYSHOOT_CLANG_FORMAT NAMES clang-format-14 clang-format)
if(RAYSHOOT_CLANG_FORMAT AND PROJECT_IS_TOP_LEVEL)
    foreach(folder IN ITEMS accel data tracer bench tests examples version)
        list(APPEND patterns "${folder}/*.h" "${folder}/*.cpp")
    endforeach()
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" ${patterns})
    list(JOIN sources "\n" listing)
    file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/format_sources.txt" CONTENT "${listing}\n")
    add_custom_target(format
        COMMAND xargs ${RAYSHOOT_CLANG_FORMAT} -i < "${PROJECT_BINARY_DIR}/format_sources.txt"
        WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}" VERBATIM)
    add_custom_target(format_check
        COMMAND xargs ${RAYSHOOT_CLANG_FORMAT} --dry-run --Werror
                < "${PROJECT_BINARY_DIR}/format_sources.txt"
        WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}" VERBATIM)
endif()
