package frustum.contract.ray

import frustum.contract.ValidFor

/** Ranges within which the methods of the ray caster keep their error bounds. */
object RayDomains {
  val Root = ValidFor("roots", "root", "argument", 1.0 / 64, 1, 1.6e-3, "of the value")
  val InverseRoot = ValidFor("roots", "inverse-root", "argument", 1.0 / 16, 1, 4e-4, "of the value")
  val SphereDistance =
    ValidFor("sphere", "sphere-distance", "units from the eye to the centre", 21, 940, 2, "of 255")
  val SphereRadius = ValidFor("sphere", "sphere-radius", "units", 1, 240, 2, "of 255")
  val LightDistance = ValidFor("sphere", "light-distance", "units from the surface", 2, 200, 2, "of 255")
}
