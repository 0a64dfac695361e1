// A mesh of React Three Fiber that draws a geometry with a share of its faces:
// <Simplified geometry={geometry} faceRatio={0.1}><meshStandardMaterial /></Simplified>
import {useEffect, useState} from 'react';
import {simplifyGeometryInWorker} from 'whittle-mesh/three';

export function Simplified({geometry, faceRatio, children, ...props}) {
  const [shown, setShown] = useState(geometry);
  useEffect(() => {
    const controller = new AbortController();
    let made = null;
    simplifyGeometryInWorker(geometry, {faceRatio}, {signal: controller.signal})
      .then((small) => {
        made = small;
        setShown(small);
      })
      .catch((error) => {
        if (error.name !== 'AbortError') throw error;
      });
    return () => {
      controller.abort();
      made?.dispose();
    };
  }, [geometry, faceRatio]);
  return (
    <mesh geometry={shown} {...props}>
      {children}
    </mesh>
  );
}
