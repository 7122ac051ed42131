# A sanitizer is of use only if every translation unit of the build has it: hence for the directory.
if(RAYSHOOT_SANITIZE)
    add_compile_options(-fsanitize=${RAYSHOOT_SANITIZE} -fno-sanitize-recover=all
        -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${RAYSHOOT_SANITIZE})
endif()
