# Configures Whittle in FOLDER, alone and as a subfolder, and looks at how its sources would be compiled.

# configure(NAME FOLDER [OPTION...]): sets NAME to the compile commands, one a line.
function(configure name source)
  set(build ${FOLDER}/${name})
  file(REMOVE_RECURSE ${build})
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env --unset=CXXFLAGS --unset=CMAKE_BUILD_TYPE ${CMAKE_COMMAND} -S ${source} -B ${build}
            -G ${GENERATOR} -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_EXPORT_COMPILE_COMMANDS=ON ${ARGN}
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(STRINGS ${build}/compile_commands.json commands REGEX "\"command\":")
  set(${name} "${commands}" PARENT_SCOPE)
endfunction()

# expect(NAME SOURCE REGEX): the first source of that name is compiled like this. `expect_none`: and not like this.
function(expect name source regex)
  set(commands ${${name}})
  list(FILTER commands INCLUDE REGEX "${source}")
  list(GET commands 0 command)
  if(NOT command MATCHES "${regex}")
    message(FATAL_ERROR "${name}: ${source} is to be compiled with '${regex}': ${command}")
  endif()
endfunction()
function(expect_none name source regex)
  set(commands ${${name}})
  list(FILTER commands INCLUDE REGEX "${source}")
  list(GET commands 0 command)
  if(command MATCHES "${regex}")
    message(FATAL_ERROR "${name}: ${source} is not to be compiled with '${regex}': ${command}")
  endif()
endfunction()

set(plain -DUSE_OPENMESH=OFF -DWHITTLE_BUILD_OPENMESH=OFF -DWHITTLE_FOLDER=${SOURCE})
set(consumer ${SOURCE}/tests/package/consumer)
set(alone -DWHITTLE_BUILD_APPS=OFF -DWHITTLE_BUILD_TESTS=OFF -DWHITTLE_BUILD_OPENMESH=OFF -DWHITTLE_BUILD_REPORT=OFF)

configure(top_level ${SOURCE} ${alone})
expect(top_level decimate.cc " -O3 .*-DNDEBUG")
configure(top_level_debug ${SOURCE} ${alone} -DCMAKE_BUILD_TYPE=Debug)
expect(top_level_debug decimate.cc " -g ")
expect_none(top_level_debug decimate.cc " -O3 ")

configure(subfolder ${consumer} ${plain})
expect(subfolder decimate.cc " -O3 .*-DNDEBUG")
expect_none(subfolder plain.cc " -O")
configure(subfolder_debug ${consumer} ${plain} -DCMAKE_BUILD_TYPE=Debug)
expect(subfolder_debug decimate.cc " -g ")
configure(subfolder_flags ${consumer} ${plain} -DCMAKE_CXX_FLAGS=-O1)
expect(subfolder_flags decimate.cc " -O1 ")
expect_none(subfolder_flags decimate.cc " -O3 ")
