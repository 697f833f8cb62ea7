# In place of ROS's hook of this name, which sets ROS_PACKAGE_PATH anew: calls that one, then appends what was on the path before, so
# that sourcing build/devel/setup.bash of collision_hulls loses no package.
_collision_hulls_before="${ROS_PACKAGE_PATH:-}"
for _collision_hulls_hook in $(echo "$CMAKE_PREFIX_PATH:" | tr ':' '\n' | sed 's|$|/etc/catkin/profile.d/1.ros_package_path.sh|'); do
  if [ -f "$_collision_hulls_hook" ] && ! grep -q collision_hulls "$_collision_hulls_hook"; then
    . "$_collision_hulls_hook"
    break
  fi
done
while [ -n "$_collision_hulls_before" ]; do
  _collision_hulls_folder="${_collision_hulls_before%%:*}"
  _collision_hulls_before="${_collision_hulls_before#"$_collision_hulls_folder"}"
  _collision_hulls_before="${_collision_hulls_before#:}"
  case ":$ROS_PACKAGE_PATH:" in
    *":$_collision_hulls_folder:"*) ;;
    *) export ROS_PACKAGE_PATH="$ROS_PACKAGE_PATH${_collision_hulls_folder:+:$_collision_hulls_folder}" ;;
  esac
done
unset _collision_hulls_before _collision_hulls_folder _collision_hulls_hook
