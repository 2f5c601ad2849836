# What `cmake --install` puts where, besides the runtime library (engine/runtime). Components: programs, documentation, runtime.
# Programs find their files relative to themselves, so that the prefix may be moved.
set(data share/windloom)
set(docs share/doc/windloom)

# Manual pages and completion, made by the programs themselves from the options that they have. The folder is made afresh, so
# that no page of a verb that is gone stays; pages are packed without name and time, so that the same text gives the same bytes.
find_program(WINDLOOM_GZIP gzip)
set(made ${CMAKE_BINARY_DIR}/share/made)
set(programs windloom)
set(write_docs COMMAND windloom docs ${made} --man --completion)
if(WINDLOOM_EDITOR)
  list(APPEND programs windloom-editor)
  list(APPEND write_docs COMMAND windloom-editor --docs ${made})
endif()
if(WINDLOOM_GZIP)
  list(APPEND write_docs COMMAND sh -c "cd '${made}' && '${WINDLOOM_GZIP}' -9nf *.1")
endif()
add_custom_command(OUTPUT ${made}/stamp DEPENDS ${programs} VERBATIM COMMENT "Manual pages and completion"
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${made}
  COMMAND ${CMAKE_COMMAND} -E make_directory ${made}
  ${write_docs}
  COMMAND ${CMAKE_COMMAND} -E touch ${made}/stamp)
add_custom_target(manual ALL DEPENDS ${made}/stamp)
install(DIRECTORY ${made}/ DESTINATION share/man/man1 COMPONENT programs FILES_MATCHING PATTERN "*.1" PATTERN "*.1.gz")

foreach(program ${programs})
  install(FILES ${made}/${program}.bash DESTINATION share/bash-completion/completions RENAME ${program} COMPONENT programs)
endforeach()
# Debian's zsh looks for what packages bring in a folder of its own.
install(CODE "set(windloom_made_files ${made})" COMPONENT programs)
install(CODE [[
  set(windloom_zsh site-functions)
  if(CMAKE_INSTALL_PREFIX STREQUAL "/usr" AND EXISTS /etc/debian_version)
    set(windloom_zsh vendor-completions)
  endif()
  file(GLOB windloom_files ${windloom_made_files}/_windloom*)
  file(INSTALL DESTINATION "${CMAKE_INSTALL_PREFIX}/share/zsh/${windloom_zsh}" TYPE FILE FILES ${windloom_files})]]
  COMPONENT programs)

install(TARGETS ${programs} RUNTIME DESTINATION bin COMPONENT programs)
install(DIRECTORY shaders/ DESTINATION ${data}/shaders COMPONENT programs)
# The samples by name: what else lies in their folders is somebody's own work. A test holds this list against git's.
foreach(sample canyon colliding-winds flowers footsteps fur helicopter hills knoll meadow moebius nature prairie rolling-ball)
  install(FILES projects/${sample}/${sample}.wind.json projects/${sample}/README.md DESTINATION ${data}/projects/${sample}
    COMPONENT programs)
endforeach()
foreach(asset flowers/assets/oat-grass.glb helicopter/assets/helicopter.glb hills/terrain/hills.png knoll/terrain/hills.png
    nature/assets/fallen-tree.glb nature/terrain/hills.png prairie/terrain/hills.png)
  get_filename_component(folder ${asset} DIRECTORY)
  install(FILES projects/${asset} DESTINATION ${data}/projects/${folder} COMPONENT programs)
endforeach()
install(FILES projects/README.md DESTINATION ${data}/projects COMPONENT programs)
# Windloom's license, and those of the libraries that are compiled in.
install(FILES packaging/copyright DESTINATION ${docs} COMPONENT programs)
if(WINDLOOM_EDITOR)
  install(FILES packaging/windloom.desktop DESTINATION share/applications COMPONENT programs)
  install(FILES packaging/windloom-mime.xml DESTINATION share/mime/packages RENAME windloom.xml COMPONENT programs)
  install(FILES packaging/org.windloom.Windloom.metainfo.xml DESTINATION share/metainfo COMPONENT programs)
  foreach(size ${WINDLOOM_ICON_SIZES})
    install(FILES packaging/icons/windloom-${size}.png DESTINATION share/icons/hicolor/${size}x${size}/apps
      RENAME windloom.png COMPONENT programs)
  endforeach()
  # Those that the window itself shows.
  foreach(size 16 32 48 128)
    install(FILES packaging/icons/windloom-${size}.png DESTINATION ${data}/icons COMPONENT programs)
  endforeach()
endif()

# Laid out as in the repository, so that links between pages hold; what they name of the program's files is linked, and so are
# the pages, for those of the samples.
install(FILES README.md CHANGELOG.md DESTINATION ${docs} COMPONENT documentation)
install(DIRECTORY docs/ DESTINATION ${docs}/docs COMPONENT documentation PATTERN ".*" EXCLUDE
  PATTERN "*.bak" EXCLUDE PATTERN "__pycache__" EXCLUDE)
file(MAKE_DIRECTORY ${CMAKE_BINARY_DIR}/share/links)
foreach(folder projects shaders)
  file(CREATE_LINK ../../windloom/${folder} ${CMAKE_BINARY_DIR}/share/links/${folder} SYMBOLIC)
  install(FILES ${CMAKE_BINARY_DIR}/share/links/${folder} DESTINATION ${docs} COMPONENT documentation)
endforeach()
file(CREATE_LINK ../doc/windloom/docs ${CMAKE_BINARY_DIR}/share/links/docs SYMBOLIC)
install(FILES ${CMAKE_BINARY_DIR}/share/links/docs DESTINATION ${data} COMPONENT documentation)
# Links to what stays with the sources become their words. Every link of the installed pages is looked at by a test.
install(CODE [=[
  set(windloom_pages "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share/doc/windloom")
  foreach(page README.md docs/README.md docs/architecture.md)
    file(READ "${windloom_pages}/${page}" text)
    string(REPLACE "](LICENSE)" "](copyright)" text "${text}")
    string(REGEX REPLACE "\\[([^]]+)\\]\\((\\.\\./)*(CONTRIBUTING\\.md|tests/README\\.md)\\)" "\\1" text "${text}")
    file(WRITE "${windloom_pages}/${page}" "${text}")
  endforeach()]=] COMPONENT documentation)
