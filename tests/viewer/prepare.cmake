# Runs the missions that the tests of the viewer look at, and exports what run.h5 has of them.
file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")

function(retiarius)
  execute_process(COMMAND "${PROGRAM}" ${ARGN} WORKING_DIRECTORY "${FOLDER}"
                  OUTPUT_QUIET RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "retiarius ${ARGN} ends with ${result}")
  endif()
endfunction()

retiarius(run "${MISSIONS}/drop-on-sphere.toml" --out drop --quiet)
foreach(angle 30 45)
  retiarius(run "${MISSIONS}/shoot.toml" --out shot-${angle} --quiet --set net.mesh=1.0
            --set "phase[0].half_angle_deg=${angle}")
endforeach()
foreach(run drop shot-30 shot-45)
  retiarius(export ${run} --to csv --out ${run}-csv)
endforeach()
retiarius(report shot-30 shot-45)
