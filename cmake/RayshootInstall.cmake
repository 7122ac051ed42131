# Installs every library of the project that is called rayshoot_*, its headers and the program
# `rayshoot`, so that find_package(rayshoot) offers them as rayshoot::core, rayshoot::accel, ...
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

function(rayshoot_collect_libraries directory result)
    get_property(targets DIRECTORY "${directory}" PROPERTY BUILDSYSTEM_TARGETS)
    get_property(subdirectories DIRECTORY "${directory}" PROPERTY SUBDIRECTORIES)
    set(found)
    foreach(target IN LISTS targets)
        get_target_property(type ${target} TYPE)
        if(target MATCHES "^rayshoot_" AND type MATCHES "LIBRARY$")
            list(APPEND found ${target})
        endif()
    endforeach()
    foreach(subdirectory IN LISTS subdirectories)
        if(NOT subdirectory STREQUAL "${PROJECT_SOURCE_DIR}/tests")
            rayshoot_collect_libraries("${subdirectory}" deeper)
            list(APPEND found ${deeper})
        endif()
    endforeach()
    set(${result} ${found} PARENT_SCOPE)
endfunction()

rayshoot_collect_libraries("${PROJECT_SOURCE_DIR}" libraries)
set(headers "${CMAKE_INSTALL_INCLUDEDIR}/rayshoot")
set(package "${CMAKE_INSTALL_LIBDIR}/cmake/rayshoot")
foreach(library IN LISTS libraries)
    string(REGEX REPLACE "^rayshoot_" "" short "${library}")
    set_target_properties(${library} PROPERTIES EXPORT_NAME ${short})
endforeach()

install(TARGETS ${libraries} EXPORT rayshoot
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}"
    OBJECTS DESTINATION "${CMAKE_INSTALL_LIBDIR}/rayshoot"
    INCLUDES DESTINATION "${headers}")
install(EXPORT rayshoot NAMESPACE rayshoot:: FILE rayshootTargets.cmake DESTINATION "${package}")
foreach(folder IN ITEMS accel data tracer bench version)
    if(EXISTS "${PROJECT_SOURCE_DIR}/${folder}")
        install(DIRECTORY "${folder}" DESTINATION "${headers}"
            FILES_MATCHING PATTERN "*.h" PATTERN "*.def" PATTERN "meshes" EXCLUDE)
    endif()
endforeach()
if(TARGET rayshoot)
    install(TARGETS rayshoot RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
install(FILES LICENSE NOTICE DESTINATION "${CMAKE_INSTALL_DOCDIR}")

configure_package_config_file(cmake/rayshootConfig.cmake.in rayshootConfig.cmake
    INSTALL_DESTINATION "${package}" NO_SET_AND_CHECK_MACRO)
# Answers may change between minor versions before 1.0: a plug-in asks for the one it was made for.
write_basic_package_version_file(rayshootConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/rayshootConfig.cmake"
    "${PROJECT_BINARY_DIR}/rayshootConfigVersion.cmake" DESTINATION "${package}")
install(FILES cmake/RayshootStructure.cmake DESTINATION "${package}")
install(DIRECTORY cmake/RayshootStructure DESTINATION "${package}")
