# if_installed(<variable> <packages> <hint>): settles an option that is ON or IF_INSTALLED. IF_INSTALLED becomes ON, or OFF where
# packages are missing; ON without them is an error, which ends with the hint.
function(if_installed variable missing hint)
  if(missing AND ${variable} STREQUAL "ON")
    list(JOIN missing ", " missing)
    message(FATAL_ERROR "${variable}=ON needs ${missing}: ${hint}")
  elseif(${variable} STREQUAL "IF_INSTALLED")
    if(missing)
      set(${variable} OFF PARENT_SCOPE)
    else()
      set(${variable} ON PARENT_SCOPE)
    endif()
  endif()
endfunction()
