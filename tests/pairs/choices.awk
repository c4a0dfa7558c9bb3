# The choices that a case makes, and which values never go together.
#
# choice(ARRAYS, NAME, VALUES): ARRAYS are letters: c fluid and particles
# coupled, p particles alone, f fluid alone, m coupled and closed, so that
# momentum stays.
# values_of(KEY, BUT): what winnow list keys says of it (keys.awk). A choice that has the
# path of a key is set by -s, but for off.
# apart(NAME, VALUES, NAME, VALUES, WHY): no case has both. With a WHY, what the
# program says when it refuses them, each such pair is a case of its own.

BEGIN {
    choice("cpf", "mesh", "box graded sheared thin dual cyclic slanted")
    choice("cpf", "periodic", "none x y z xz xyz")
    choice("cf", "drive", "closed wall turning through parabola formula table ramp pressure outlet gradient flow")
    choice("cf", "sides", "no-slip slip mixed")
    choice("cfm", "medium", "air liquid")
    choice("cfm", "fluid.time", values_of("fluid.time"))
    choice("cfm", "fluid.gradient", values_of("fluid.gradient", "by-mesh"))
    choice("cfm", "fluid.correctors", "1 2 4")
    choice("cfm", "fluid.piso_tolerance", "1e-3 0.0")
    choice("cfm", "fluid.outer_correctors", "0 2")
    choice("f", "fluid.cfl", "off 0.5")
    choice("cf", "fluid.tolerance", "1e-8 1e-10")
    choice("c", "bodies", "none fixed free moving cylinder surface solid")
    choice("f", "bodies", "none fixed free moving cylinder surface solid clump box")
    choice("m", "bodies", "none free")
    choice("f", "bodies.stiffness", "off 500.0")
    for (k = split("restitution friction roughness", word, " "); k > 0; k--)
        choice("f", "bodies." word[k], values_of("bodies." word[k]))
    choice("cpm", "count", "none one few sixty settled crowd")
    choice("cpm", "parcel", "none " values_of("particles.parcel.restitution"))
    choice("cpm", "clumps", "none egg")
    choice("cpm", "sizes", "equal uniform normal lognormal discrete table")
    choice("cpm", "materials", "one wall several pairs")
    choice("cpm", "rolling", "off on")
    choice("cpm", "cohesion", "none electrostatic van_der_waals capillary all")
    choice("cpm", "insert", "none once rate mass late file moved")
    choice("cp", "sinks", "none bottom left region both")
    choice("m", "sinks", "none region")
    choice("cp", "driven", "none line swing circle")
    choice("cp", "surface", "none plane cylinder stl moving turning loaded")
    choice("cm", "particles.integrator", values_of("particles.integrator", "heun adaptive-heun"))
    choice("p", "particles.integrator", values_of("particles.integrator"))
    choice("cpm", "particles.list", values_of("particles.list"))
    choice("p", "particles.skin", "off 3e-4")
    choice("cpm", "effects.particle_stress", effect("effects.particle_stress", "pressure=10.0;"))
    choice("cpm", "effects.collision_damping", effect("effects.collision_damping", "restitution=0.9;"))
    choice("cp", "gravity", "down none oblique")
    choice("cpm", "effects.energy_budget", effect("effects.energy_budget", ""))
    choice("cm", "width", "bandwidth delta_05 cells grains regions")
    choice("cm", "averaging.steps", "1 3")
    choice("cm", "averaging.cap", "off 0.6")
    choice("cm", "drag", "syamlal-obrien gidaspow schiller-naumann beetstra another")
    choice("cm", "exchange.substeps", "auto 1 3 1000")
    choice("c", "exchange.coupling", values_of("exchange.coupling"))
    choice("cm", "effects.lubrication", effect("effects.lubrication", "roughness=1e-6;range=1e-4;"))
    choice("c", "effects.time_average", effect("effects.time_average", "time=1e-3;"))
    choice("cm", "effects.stochastic_drag", effect("effects.stochastic_drag", "sigma_low=3.0;sigma_high=1.0;Re_high=100.0;time=1e-3;"))
    choice("cm", "effects.bubbles", effect("effects.bubbles", "height=0.004;"))
    choice("cpm", "effects.mixing", effect("effects.mixing", "sample=0.004;direction=[1.0,1.0,0.0];"))
    choice("cpf", "history", "each second never")
    choice("cpf", "every", "each end")
    choice("cf", "profiles", "off on")
    choice("cf", "probes", "off on")
    choice("cf", "forces", "off on")
    choice("cp", "contacts", "off on")
    choice("cp", "shown", "few all")
    choice("cp", "statistics", "off on")
    learn_others()

    # Nothing comes from outside: momentum stays.
    choice("m", "mesh", "box graded thin")
    choice("m", "periodic", "xyz")
    choice("m", "drive", "closed")
    choice("m", "exchange.coupling", "two-way")
    choice("m", "history", "each")
    choice("m", "every", "end")
    choice("m", "gravity", "none")

    # What a mesh from files has is said by the files.
    apart("mesh", "dual slanted", "periodic", "x y z xz xyz", "")
    apart("mesh", "cyclic", "periodic", "none y z xz xyz", "")
    # A flow is driven round a period, and goes in or out at a side.
    apart("drive", "gradient flow", "periodic", "none",
          "x is not periodic, so no mean flow can be driven along it")
    apart("drive", "gradient flow", "mesh", "dual slanted", "")
    apart("drive", "through parabola formula table ramp pressure outlet", "periodic", "y xyz",
          "y is periodic, so the fluid has no")
    apart("drive", "wall turning", "periodic", "z xz xyz",
          "z is periodic, so the fluid has no")
    apart("drive", "parabola", "mesh", "sheared dual cyclic slanted",
          "only the inlet of a plain box can have a parabola")
    apart("effects.pressure_gradient", "on", "effects.whole_drag", "on", "takes the place of")
    # Particles go round along an axis; an oblique box does so in x and z.
    if (letter != "f")
        apart("mesh", "sheared", "periodic", "y xyz",
              "for particles a period must be along x, y or z|y is not periodic")
    # Attractions know the sides of the box, and no other walls.
    apart("mesh", "slanted", "cohesion", "van_der_waals capillary all",
          "not on the walls of this mesh")
    apart("mesh", "sheared", "cohesion", "van_der_waals capillary all", "")
    apart("surface", "plane cylinder stl moving turning loaded", "cohesion",
          "van_der_waals capillary all", "not on surfaces")
    # Who goes out below comes in above, behind this plane.
    apart("surface", "plane", "periodic", "y xyz",
          "not parallel to y, which is periodic")
    # The reference loop knows the sides of a box.
    apart("particles.list", "link-cells all-pairs none", "particles.integrator", "heun adaptive-heun",
          "does not support integrators that")
    apart("particles.list", "link-cells all-pairs none", "driven", "line swing circle",
          "does not support prescribed particles")
    apart("particles.list", "link-cells all-pairs none", "surface",
          "plane cylinder stl moving turning loaded", "does not support surfaces")
    apart("particles.list", "link-cells all-pairs none", "mesh",
          "slanted", "does not support surfaces")
    # A sheared box has walls of its own only where it is not periodic.
    apart("particles.list", "link-cells all-pairs none", "mesh", "sheared")
    apart("particles.list", "link-cells all-pairs none", "particles.skin", "3e-4", "")
    # A parcel loses no more than all of the energy of an impact.
    apart("parcel", "dissipation", "materials", "pairs",
          "parcels of 2 diameters cannot lose as much as grains of e = 0.5")
    apart("parcel", "kept dissipation", "bodies",
          "fixed free moving cylinder surface solid", "there are grains, not parcels")
    # A clump moves as its balls do together.
    apart("clumps", "egg", "particles.integrator", "symplectic-euler heun adaptive-heun",
          "moved by velocity-verlet alone")
    apart("clumps", "egg", "particles.list", "none", "they would pass through each other")
    apart("clumps", "egg", "particles.overlaps", "relax", "their balls would be moved apart")
    apart("clumps", "egg", "parcel", "kept dissipation", "a ball is no parcel")
    apart("clumps", "egg", "driven", "line swing circle", "the numbers of their balls")
    apart("clumps", "egg", "surface", "cylinder stl turning loaded", "the wear by a clump")
    apart("clumps", "egg", "bodies", "fixed free moving cylinder surface solid", "bodies.clumps")
    apart("clumps", "egg", "exchange.slip_integration", "exponential", "force of a fluid on clumps")
    apart("clumps", "egg", "averaging.method", "dpvm cube", "it divides spheres by the cells")
    n_forces = split("virtual_mass basset saffman fluid_torque magnus whole_drag", force, " ")
    for (k = 1; k <= n_forces; k++)
        apart("clumps", "egg", "effects." force[k], "on", "that force is known for spheres alone")
    apart("clumps", "egg", "effects.lubrication", "on", "for spheres alone")
    apart("clumps", "egg", "effects.stochastic_drag", "on", "for spheres alone")
    # Without contacts nothing comes to rest, and no pair is close.
    apart("particles.list", "none", "count", "settled",
          "no bed comes to rest without contacts|does not support")
    apart("particles.list", "none", "effects.lubrication", "on",
          "does not support forces between particles at a distance")
    apart("particles.list", "none", "cohesion", "electrostatic van_der_waals capillary all",
          "does not support forces between particles at a distance")
    # A stress stands for contacts, and collisions go with it. They know what the loop
    # without contacts knows.
    n_stress = split("effects.particle_stress effects.collision_damping effects.collision_isotropy", \
                     stress, " ")
    for (k = 1; k <= n_stress; k++) {
        apart(stress[k], "on", "particles.list", "verlet link-cells all-pairs", \
              k == 1 ? "it takes the place of contacts|does not support|no bed comes to rest" : "")
        apart(stress[k], "on", "particles.skin", "3e-4", "")
        apart(stress[k], "on", "mesh", "dual cyclic", \
              k == 1 ? "it is computed on plain boxes" : "")
        apart(stress[k], "on", "mesh", "sheared slanted", "")
        apart(stress[k], "on", "materials", "wall several pairs", \
              k == 1 ? "all materials must have the same density" : "")
        apart(stress[k], "on", "effects.virtual_mass", "on", \
              k == 1 ? "leave out the effects with an added mass" : "")
        apart(stress[k], "on", "effects.basset", "on", "")
        apart(stress[k], "on", "particles.integrator", "heun adaptive-heun", "")
        apart(stress[k], "on", "driven", "line swing circle", "")
        apart(stress[k], "on", "surface",
              "plane cylinder stl moving turning loaded", "")
        apart(stress[k], "on", "count", "settled", "")
        apart(stress[k], "on", "effects.energy_budget", "on", \
              k == 1 ? "does not know its work" : "")
        apart(stress[k], "on", "clumps", "egg", "")
        apart(stress[k], "on", "cohesion", "electrostatic van_der_waals capillary all", "")
        apart(stress[k], "on", "effects.lubrication", "on", "")
        apart(stress[k], "on", "bodies", "fixed free moving cylinder surface solid", "")
        if (k > 1)
            apart("effects.particle_stress", "off", stress[k], "on",
                  "needs effects.particle_stress")
    }
    # Refused where none comes at the start either: a fact of the command line.
    apart("count", "none", "driven", "line swing circle")
    # The width at half the height is of a Gaussian.
    apart("width", "delta_05", "averaging.method",
          "pcm dpvm cube two-grid kernel gaussian",
          "it is a key of images, diffusion")
    # Bodies are held in equal cells of a plain box, and have three at least.
    apart("bodies", "fixed free moving cylinder surface solid clump box", "mesh",
          "sheared dual cyclic slanted", "held in the cells of a plain box")
    apart("bodies", "fixed free moving cylinder surface solid clump box", "mesh", "graded",
          "bodies ask for equal cells")
    apart("bodies", "fixed free moving", "mesh", "thin", "has a diameter of")
    apart("bodies", "surface solid clump", "mesh", "thin", "has a part of")
    # Among particles they are surfaces; one that moves changes eps where it is.
    if (letter != "f")
        apart("bodies", "free moving surface solid", "fluid.continuity", "void-rate",
              "among particles a body that moves asks for")
    apart("bodies", "fixed free moving cylinder surface solid", "cohesion",
          "van_der_waals capillary all", "not on bodies")
    apart("bodies", "fixed free moving cylinder surface solid", "particles.list",
          "link-cells all-pairs none", "does not support surfaces")
    # One-way there are no solids on the mesh.
    apart("exchange.coupling", "one-way", "effects.time_average", "on",
          "one-way there are no averaged fields")
}
