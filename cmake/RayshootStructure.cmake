# rayshoot_structure(<name> <header> <Class> [exact|tolerance] [SOURCES <file>...]
#                    [LIBRARIES <target>...])
#
# Makes the library rayshoot_<name> of one acceleration structure: its sources (a header that lies in
# a folder of its own brings every .cpp of that folder), one file per counting policy, and
# <name>_entry.h with `rayshoot::<name>_entry()`, its line of the catalogue. The same function serves
# accel/catalogue.def and programs that bring a structure of their own.
function(rayshoot_structure name header class)
    cmake_parse_arguments(PARSE_ARGV 3 arg "exact;tolerance" "" "SOURCES;LIBRARIES")
    set(RAYSHOOT_NAME "${name}")
    set(RAYSHOOT_HEADER "${header}")
    set(RAYSHOOT_CLASS "${class}")
    set(RAYSHOOT_AGREEMENT "exact")
    if(arg_tolerance)
        set(RAYSHOOT_AGREEMENT "tolerance")
    endif()

    set(generated "${CMAKE_CURRENT_BINARY_DIR}/rayshoot_${name}")
    foreach(template IN ITEMS entry.h entry.cpp timing.cpp counting.cpp)
        configure_file("${RAYSHOOT_STRUCTURE_TEMPLATES}/${template}.in"
            "${generated}/${name}_${template}" @ONLY)
    endforeach()
    cmake_path(GET header PARENT_PATH folder)
    if(folder)
        file(GLOB sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/${folder}/*.cpp")
    endif()

    add_library(rayshoot_${name} STATIC ${sources} ${arg_SOURCES}
        "${generated}/${name}_entry.cpp" "${generated}/${name}_timing.cpp"
        "${generated}/${name}_counting.cpp")
    target_include_directories(rayshoot_${name} PUBLIC "$<BUILD_INTERFACE:${generated}>"
        PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
    target_link_libraries(rayshoot_${name} PUBLIC rayshoot::core ${arg_LIBRARIES}
        PRIVATE $<BUILD_INTERFACE:$<TARGET_NAME_IF_EXISTS:rayshoot_warnings>>)
    # Link-time optimisation would undo the separation of the policies (11 % more instructions).
    set_target_properties(rayshoot_${name} PROPERTIES INTERPROCEDURAL_OPTIMIZATION OFF)
    set_property(GLOBAL APPEND PROPERTY RAYSHOOT_STRUCTURES ${name})
    set_property(GLOBAL APPEND PROPERTY RAYSHOOT_ENTRY_HEADERS "${name}_entry.h")
endfunction()

# Where the templates lie: beside this file in the sources as in the installed package.
set(RAYSHOOT_STRUCTURE_TEMPLATES "${CMAKE_CURRENT_LIST_DIR}/RayshootStructure"
    CACHE INTERNAL "Templates of a structure's generated files")
