# Link rayshoot_warnings PRIVATE to own targets; third-party headers are SYSTEM and stay silent.
add_library(rayshoot_warnings INTERFACE)
# clang counts -Wsign-conversion among -Wconversion, g++ does not: both are to mean the same.
target_compile_options(rayshoot_warnings INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion
    $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-sign-conversion>)
