# What Doxygen 1.9 makes of links for GitHub: it knows no anchors, and its pages lie in one folder, with headers and pictures beside them.
# A link to a heading becomes one to its page, or text on the same page; one to a file that has no page, text.
s/\[([^]]*)\]\(#[^)]*\)/\1/g
s/\]\(([^)#]+)#[^)]*\)/](\1)/g
s/\[([^]]*)\]\((\.\.\/)*((cmake|src)\/[^)]*\.(cmake|cpp|h)|(meshes|scripts|test)(\/[^)]*)?)\)/\1/g
s/\]\(([^):]*\/)?(\w+\.h)\)/](@ref \2)/g
s/\]\(([^):]*\/)?(\w+\.(action|csv|json|msg|png|rst|srv|svg))\)/](\2)/g
