# Installs BUILD into FIRST and moves it to PREFIX, so that references to FIRST that are left cause errors.
file(REMOVE_RECURSE ${FIRST} ${PREFIX})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${FIRST} COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${FIRST} ${PREFIX})
foreach(
  name
  WhittleConfig.cmake
  whittle.pc
  LICENSE
  include/whittle/version.hh
  share/bash-completion/completions/whittle
  share/zsh/site-functions/_whittle
  share/fish/vendor_completions.d/whittle.fish
  share/man/man1/whittle.1)
  file(GLOB_RECURSE files RELATIVE ${PREFIX} ${PREFIX}/*)
  list(FILTER files INCLUDE REGEX "(^|/)${name}$")
  if(NOT files)
    message(FATAL_ERROR "the package installs no ${name}")
  endif()
  file(SIZE ${PREFIX}/${files} size)
  if(size EQUAL 0)
    message(FATAL_ERROR "the package's ${name} is empty")
  endif()
endforeach()
file(GLOB_RECURSE scripts ${PREFIX}/*.cmake ${PREFIX}/*.pc)
get_filename_component(source ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
foreach(script IN LISTS scripts)
  file(READ ${script} text)
  foreach(folder ${FIRST} ${BUILD} ${source})
    string(FIND "${text}" "${folder}" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${script} names the folder ${folder} of the machine that built it")
    endif()
  endforeach()
endforeach()
