# Link rayshoot_warnings PRIVATE to own targets; third-party headers are SYSTEM and stay silent.
add_library(rayshoot_warnings INTERFACE)
target_compile_options(rayshoot_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # clang counts -Wsign-conversion among -Wconversion, g++ does not: both are to mean the same.
    target_compile_options(rayshoot_warnings INTERFACE -Wno-sign-conversion)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # Said wrongly of "text" + std::string (gcc bug 105651).
    target_compile_options(rayshoot_warnings INTERFACE -Wno-restrict)
endif()
