# SPDX-License-Identifier: MIT
# cmake -DARCHIVE=libkodo.a -DLINKER=ld -DOBJCOPY=objcopy -DAR=ar -P seal.cmake
# Joins the objects of a static library into one that exports the public API alone. The linker keeps
# one copy of an inline function. Without this it may be that of a user's file, which other flags
# (-mfma, -march=native) round differently, and the engine would compute with it.
function(seal_step)
    execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

cmake_path(GET ARCHIVE STEM LAST_ONLY name)
set(object ${ARCHIVE}.dir/${name}.o)
file(MAKE_DIRECTORY ${ARCHIVE}.dir)
seal_step(${LINKER} -r --whole-archive ${ARCHIVE} -o ${object})
seal_step(${OBJCOPY} --localize-hidden --remove-section=.group ${object})
file(REMOVE ${ARCHIVE})
seal_step(${AR} qcs ${ARCHIVE} ${object})
file(REMOVE_RECURSE ${ARCHIVE}.dir)
