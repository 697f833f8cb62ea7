# Tab completion of the programs' options.
. "$CATKIN_ENV_HOOK_WORKSPACE/share/collision_hulls/completion.bash"
