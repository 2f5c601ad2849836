# Keeps a list of what `cmake --install` wrote and which folders it had to make, whatever the prefix, DESTDIR and component:
# the target `uninstall` takes that away again. CMake's own install_manifest.txt knows only the last install, no folders, and
# of a package's staging the paths it will have on another machine.
set(WINDLOOM_INSTALL_RECORD ${CMAKE_BINARY_DIR}/installed_files.txt)

# Called before the first install rule: remembers the folders that are missing.
function(windloom_record_begin)
  set(folders bin share share/windloom share/doc share/doc/windloom share/man share/man/man1 share/bash-completion
    share/bash-completion/completions share/zsh share/zsh/site-functions share/zsh/vendor-completions share/applications
    share/mime share/mime/packages share/metainfo share/icons share/icons/hicolor ${CMAKE_INSTALL_LIBDIR}
    ${CMAKE_INSTALL_LIBDIR}/cmake ${CMAKE_INSTALL_LIBDIR}/cmake/windloom_runtime ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    ${CMAKE_INSTALL_INCLUDEDIR})
  foreach(size ${WINDLOOM_ICON_SIZES})
    list(APPEND folders share/icons/hicolor/${size}x${size} share/icons/hicolor/${size}x${size}/apps)
  endforeach()
  install(CODE "set(windloom_folders \"${folders}\")" ALL_COMPONENTS)
  install(CODE [[
    get_filename_component(windloom_prefix "${CMAKE_INSTALL_PREFIX}" ABSOLUTE)
    set(windloom_prefix "$ENV{DESTDIR}${windloom_prefix}")
    set(windloom_made "")
    foreach(folder IN LISTS windloom_folders)
      if(NOT EXISTS "${windloom_prefix}/${folder}")
        list(APPEND windloom_made "${windloom_prefix}/${folder}")
      endif()
    endforeach()
    set(folder "${windloom_prefix}")
    while(NOT EXISTS "${folder}")
      list(APPEND windloom_made "${folder}")
      get_filename_component(folder "${folder}" DIRECTORY)
    endwhile()]] ALL_COMPONENTS)
endfunction()

# Called after the last install rule. A line is "file PATH", "folder PATH" or "ours PATH": a folder that only holds our files.
function(windloom_record_end)
  install(CODE "set(windloom_record \"${WINDLOOM_INSTALL_RECORD}\")" ALL_COMPONENTS)
  install(CODE [[
    if(NOT windloom_prefix MATCHES "/_CPack_Packages/")
      set(windloom_lines "")
      if(EXISTS "${windloom_record}")
        file(STRINGS "${windloom_record}" windloom_lines ENCODING UTF-8)
      endif()
      foreach(file IN LISTS CMAKE_INSTALL_MANIFEST_FILES)
        list(APPEND windloom_lines "file $ENV{DESTDIR}${file}")
      endforeach()
      foreach(folder IN LISTS windloom_made)
        list(APPEND windloom_lines "folder ${folder}")
      endforeach()
      list(APPEND windloom_lines "ours ${windloom_prefix}/share/windloom" "ours ${windloom_prefix}/share/doc/windloom")
      list(REMOVE_DUPLICATES windloom_lines)
      string(REPLACE ";" "\n" windloom_lines "${windloom_lines}")
      file(WRITE "${windloom_record}" "${windloom_lines}\n")
    endif()]] ALL_COMPONENTS)
  add_custom_target(uninstall
    COMMAND ${CMAKE_COMMAND} -DRECORD=${WINDLOOM_INSTALL_RECORD} -P ${CMAKE_SOURCE_DIR}/cmake/uninstall.cmake
    COMMENT "Removing what was installed from this build folder" VERBATIM)
endfunction()
